// SPDX-License-Identifier: MIT
/**
 * @file Holes filled and faired in one line, with the rest held.
 */
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { jsonOf, outputOf, scratchFolder, tetrahedron, umbilic } from './program.js';

const scratch = scratchFolder();
afterAll(scratch.dispose);

/**
 * A rounded cube of n x n quads on each side, as OBJ, its sides in the groups side-1 to side-6.
 * @param {number} n
 * @param {(side: number, i: number, j: number) => boolean} kept whether a quad is there
 * @param {(corner: (side: number, i: number, j: number) => number) => string} more further lines; `corner` is the
 *   number of a vertex
 */
function roundedCube(n, kept, more = () => '') {
  /** @type {Map<string, number>} */
  const numbers = new Map();
  let text = '';
  const corner = (/** @type {number} */ side, /** @type {number} */ i, /** @type {number} */ j) => {
    const sign = side % 2 === 0 ? 1 : -1;
    const axis = side >> 1;
    const cube = [0, 0, 0];
    cube[axis] = sign * n;
    cube[(axis + 1) % 3] = sign * (2 * i - n);
    cube[(axis + 2) % 3] = 2 * j - n;
    const key = cube.join();
    if (!numbers.has(key)) {
      const scale = Math.hypot(...cube) ** -0.75;
      text += `v ${cube.map((x) => x * scale).join(' ')}\n`;
      numbers.set(key, numbers.size + 1);
    }
    return /** @type {number} */ (numbers.get(key));
  };
  let faces = '';
  for (let side = 0; side < 6; ++side) {
    faces += `g side-${side + 1}\n`;
    for (let i = 0; i < n; ++i) {
      for (let j = 0; j < n; ++j) {
        if (!kept(side, i, j)) continue;
        faces += `f ${corner(side, i, j)} ${corner(side, i + 1, j)} ${corner(side, i + 1, j + 1)} ${corner(side, i, j + 1)}\n`;
      }
    }
  }
  const lines = more(corner);
  return text + faces + lines;
}

/** @param {string} obj @returns {string[]} its vertices */
const verticesOf = (obj) => obj.split('\n').filter((line) => line.startsWith('v '));

/** A triangle leaves five sides of a hole of two quads. */
const fiveSided = () =>
  roundedCube(
    5,
    (side, i, j) => !(side === 0 && j === 2 && (i === 1 || i === 2)),
    (corner) => `g cut\nf ${corner(0, 3, 2)} ${corner(0, 3, 3)} ${corner(0, 2, 3)}\n`,
  );

const twelveSided = () => roundedCube(5, (side, i, j) => !(side === 0 && i > 0 && i < 4 && j > 0 && j < 4));

beforeAll(() => {
  scratch.write('five.obj', fiveSided());
  scratch.write('twelve.obj', twelveSided());
});

describe.each(['bending', 'mvs_cross'])('a filled hole, minimizing %s', (functional) => {
  const line = (/** @type {string} */ file, /** @type {string[]} */ ...more) => [
    'optimize',
    file,
    '--fill=all',
    '--functional',
    functional,
    '-q',
    ...more,
  ];

  test('of twelve sides keeps every vertex of the file to the last digit', () => {
    const written = outputOf(line('twelve.obj', '--levels', '0..0', '-o', '-'), scratch);
    const given = verticesOf(scratch.read('twelve.obj'));
    const numbers = (/** @type {string} */ vertex) => vertex.slice(2).split(' ').map(Number);
    expect(verticesOf(written).length).toBeGreaterThan(given.length);
    expect(verticesOf(written).slice(0, given.length).map(numbers)).toEqual(given.map(numbers));
  });

  test.each(
    /** @type {[string, string, RegExp][]} */ ([
      ['twelve.obj', '0..1', /^filled boundary 1 of 12 vertices with \d+ faces, the group 'fill-1'$/],
      [
        'five.obj',
        '0..0',
        /^filled boundary 1 of 10 vertices with .*; the cage was refined once first, because boundary 1 has 5 /,
      ],
    ]),
  )('of %s is a converged surface of the rest and the fill', (file, levels, note) => {
    const report = jsonOf(line(file, '--levels', levels, '--report', '-'), scratch);
    expect(report.levels.at(-1).stop).toBe('converged');
    expect(report.cage).toMatchObject({ genus: 0, boundaries: [] });
    expect(report.cage.notes[0]).toMatch(note);
    expect(report.problem.fill).toEqual({});
    expect(report.problem.constraints.free.groups).toEqual(['fill-1', 'fill-1-rim']);
    expect(report.energies.resolved).toBe(true);
    expect(report.energies.free.area).toBeLessThan(report.energies.area / 3);
    const goesOn = ['optimize', '-', '--print-problem'];
    const again = jsonOf(goesOn, { input: JSON.stringify(report), folder: scratch.folder });
    expect([again.fill, again.constraints]).toEqual([{}, report.problem.constraints]);
  });
});

test('a fill goes on from its report to the same surface, perhaps by a finer rule', () => {
  const options = ['--functional', 'mvs_cross', '--levels', '0..1', '-q', '--report', '-'];
  const whole = jsonOf(['optimize', 'twelve.obj', '--fill=all', ...options], scratch);
  const goingOn = (/** @type {string[]} */ ...more) =>
    jsonOf(['optimize', '-', ...options, ...more], { input: JSON.stringify(whole), folder: scratch.folder });
  const on = goingOn();
  const [first, second] = [whole, on].map(({ levels }) => levels.at(-1));
  // What is minimized is the same: the symmetry, the constant area, what is held.
  expect(on.group).toEqual(whole.group);
  expect(on.energies.free.area_factor).toBe(whole.energies.free.area_factor);
  expect(on.constraints.held_faces).toBe(whole.constraints.held_faces);
  expect(second.unknowns).toBe(first.unknowns);
  const start = goingOn('--max-iterations', '0').levels.at(-1);
  expect(Math.abs(start.energy / first.energy - 1)).toBeLessThan(1e-10);
  // The gain is small from there, so that the coarser rule's error matters beside it.
  expect([first.quadrature, second.quadrature]).toEqual([0, 1]);
  expect(second.energy - first.energy).toBeGreaterThan(5e-4 * first.energy);
  // By one rule the energies are the same.
  expect(Math.abs(second.energy_reported / first.energy_reported - 1)).toBeLessThan(1e-5);
  expect(Math.abs(on.energies.free.area / whole.energies.free.area - 1)).toBeLessThan(1e-4);
});

describe('--fill', () => {
  const bending = ['--functional', 'bending', '-q', '--levels', '0..0'];
  const problem = (/** @type {string[]} */ ...args) =>
    jsonOf(['optimize', 'twelve.obj', ...bending, '--print-problem', ...args], scratch);

  test('asks for all boundaries or for some', () => {
    expect(problem('--fill').fill).toEqual({});
    expect(problem('--fill', 'all').fill).toEqual({});
    expect(problem('--fill', '1,3').fill).toEqual({ loops: [1, 3] });
    expect(problem('--fill=2').fill).toEqual({ loops: [2] });
    expect(problem()).not.toHaveProperty('fill');
  });

  test('leaves to --hold and --free what is held', () => {
    const report = jsonOf(
      ['optimize', 'twelve.obj', ...bending, '--fill', '--report', '-', '--hold', 'side-2'],
      scratch,
    );
    expect(report.problem.constraints).toEqual({ hold: { groups: ['side-2'], faces: [] } });
    const { code, err } = umbilic(['optimize', 'twelve.obj', ...bending, '--fill', '--free', 'fill-2'], scratch);
    expect({ code, err }).toEqual({
      code: 3,
      err:
        "umbilic: twelve.obj: constraints.free.groups[0]: there is no group 'fill-2'; the cage has 'side-1', " +
        "'fill-1-rim', 'side-2', 'side-3', 'side-4', 'side-5', 'side-6', 'fill-1'\n",
    });
  });

  test('says in the table what was done', () => {
    const out = outputOf(['optimize', 'twelve.obj', ...bending, '--fill'], scratch);
    expect(out).toContain('note: filled boundary 1 of 12 vertices with ');
    expect(out).toContain('note: held is what is not filled and touches no filled boundary: ');
  });

  test.each([
    [['twelve.obj', '--fill=2'], 3, 'twelve.obj: fill.loops[0]: there is no boundary 2; the cage has 1'],
    [['-', '--fill=all'], 3, 'standard input: fill: the cage is closed, and has no boundary to fill'],
    [['twelve.obj', '--fill', '0'], 2, '--fill: '],
    [['--fill', 'twelve.obj'], 2, "--fill: 'twelve.obj' is not all, nor numbers of boundaries as in 1,3"],
  ])('%j ends with %i', (args, code, reason) => {
    const ended = umbilic(['optimize', ...args, ...bending], { ...scratch, input: tetrahedron });
    expect(ended.err).toContain(`umbilic: ${reason}`);
    expect(ended.code).toBe(code);
  });
});
