// SPDX-License-Identifier: MIT
/**
 * @file What the terms on the pages mean, in plain sentences, for the glossary.
 */

/** @typedef {{id: string, name: string, words: string}} Term */

/** In alphabetical order of their names. @type {Term[]} */
export const glossary = [
  {
    id: 'bound',
    name: 'Bound',
    words:
      'An upper bound is the energy of a surface that exists, so the least energy is not above it. A lower bound is an energy below which no surface of that shape can be.',
  },
  {
    id: 'boundary',
    name: 'Boundary',
    words:
      'A closed curve where an open surface ends. What is held there says whether its place, slope or curvature stays.',
  },
  {
    id: 'cage',
    name: 'Cage',
    words:
      'The coarse mesh that controls a smooth surface, as in subdivision modelling. Moving its points moves the surface.',
  },
  {
    id: 'cap',
    name: 'Cap',
    words:
      'The small piece that replaces the surface around each extraordinary vertex, where its curvature would not be smooth. The smooth cap is right for all energies.',
  },
  {
    id: 'certificate',
    name: 'Certificate',
    words:
      'A check, by the eigenvalues of the Hessian, whether any small change of the surface lowers its energy, also one that breaks its symmetry.',
  },
  {
    id: 'curvature',
    name: 'Curvature',
    words:
      'How strongly a surface bends: 1 divided by the radius of the circle that fits it. κ₁ and κ₂ are its largest and its smallest at a point, H is their mean, and K their product.',
  },
  {
    id: 'energy',
    name: 'Energy',
    words:
      'The number that a functional gives a surface. The lower, the more the surface is what the functional prefers.',
  },
  {
    id: 'error-bar',
    name: 'Error bar',
    words:
      'How far the true least energy may be from the number before the ±. It is told from three meshes, each finer than the one before.',
  },
  {
    id: 'evaluation',
    name: 'Evaluation',
    words: 'One computation of the energy, and of how each control point changes it. A run is a few hundred of them.',
  },
  {
    id: 'even-invariants',
    name: 'Even invariants',
    words:
      'J₁, the variation of the second form, J₂, that of mean curvature, and J₅, that of curvedness: they are the same from both sides of a surface, never below 0, and can be minimized.',
  },
  {
    id: 'extraordinary-vertex',
    name: 'Extraordinary vertex',
    words: 'A vertex where not four edges meet. Everywhere else the surface is as smooth as can be.',
  },
  {
    id: 'family',
    name: 'Family',
    words:
      'Two ways to build the cage of a frame. Hub cages have a prism at each junction, flag cages put the extraordinary vertices on the axes of the junctions. The minimizer does not depend on it.',
  },
  {
    id: 'functional',
    name: 'Functional',
    words: 'A rule that gives every surface one number, its energy. Which shape is best depends on the rule.',
  },
  {
    id: 'genus',
    name: 'Genus',
    words: 'The number of handles: 0 for a ball, 1 for a ring, 2 for a pretzel with two holes.',
  },
  {
    id: 'gradient',
    name: 'Gradient norm',
    words: 'How steeply the energy still falls if the surface is moved. At a minimum it is 0.',
  },
  {
    id: 'held',
    name: 'Held',
    words:
      'What is held stays exactly where the cage puts it: faces, points, normals or boundaries. Everything else is free to move.',
  },
  {
    id: 'hessian',
    name: 'Hessian',
    words:
      'The table of second derivatives of the energy, which says in which directions the energy is a valley or a ridge.',
  },
  {
    id: 'integration',
    name: 'Integration',
    words:
      'Energies are sums over many sample points of the surface. The error of the integration is what a finer set of points would change.',
  },
  {
    id: 'level',
    name: 'Level',
    words:
      'How often the cage has been refined. Each level has four times as many patches as the one before, so it can come closer to the smooth minimizer and takes longer.',
  },
  {
    id: 'limit',
    name: 'Limit',
    words: 'The energy that finer and finer meshes lead to, estimated from the last three levels.',
  },
  {
    id: 'metric',
    name: 'Metric',
    words:
      'How the run measures the size of a step. A good one reaches the minimum in fewer evaluations; the minimum is the same.',
  },
  {
    id: 'minimizer',
    name: 'Minimizer',
    words: 'The surface of least energy among those that one asked for.',
  },
  {
    id: 'order',
    name: 'Observed order',
    words: 'How fast the error falls from level to level: with order 2, each finer level has a quarter of the error.',
  },
  {
    id: 'odd-invariants',
    name: 'Odd invariants',
    words:
      'J₃, J₄ and J₆ weigh the change of curvature by curvature itself. From the other side of a surface they have the opposite sign and no least value, so they are evaluated and never minimized.',
  },
  {
    id: 'patch',
    name: 'Patch',
    words: 'The piece of the smooth surface that belongs to one face of its mesh.',
  },
  {
    id: 'rim',
    name: 'Rim',
    words: 'The edge of a thin or cut part, where a surface bends most; also where a held part meets a free one.',
  },
  {
    id: 'sobolev',
    name: 'Sobolev product',
    words:
      'A way to compare how much two surfaces differ that also counts how differently they bend. It needs no second derivatives of the energy.',
  },
  {
    id: 'symmetry',
    name: 'Symmetry group',
    words:
      'The turns and mirrors that map the cage to itself. Its order is their number; D3h, for example, has 12. A surface that keeps them needs only a part of the work.',
  },
  {
    id: 'tau',
    name: 'τ (tau)',
    words: 'The threshold of a certificate: the energy must fall by more than this along a direction for it to count.',
  },
  {
    id: 'tolerance',
    name: 'Tolerance',
    words:
      'A level ends when what it can still gain is a smaller part of the energy than this. A lower one takes longer.',
  },
];

/** @param {string} id @returns {Term} */
export function termWords(id) {
  const found = glossary.find((term) => term.id === id);
  if (!found) throw new Error(`the glossary has no ${id}`);
  return found;
}
