// SPDX-License-Identifier: MIT
/**
 * @file Cages far away, tiny, huge, in need of repair, degenerate or endless: what the commands say of them.
 */
import { afterAll, describe, expect, test } from '@jest/globals';
import { jsonOf, outputOf, scratchFolder, tetrahedron, umbilic } from './program.js';

const scratch = scratchFolder();
afterAll(scratch.dispose);

/** @param {string} cage OBJ @param {(x: number) => number} map of each coordinate */
const moved = (cage, map) =>
  cage.replace(
    /^v (.*)$/gm,
    (_, words) =>
      `v ${words
        .split(' ')
        .map((/** @type {string} */ x) => map(Number(x)))
        .join(' ')}`,
  );

const frame = outputOf(['cage', 'two-3']);
const cube = outputOf(['cage', 'cube']);

describe('a cage of any size', () => {
  test.each([2 ** 300, 2 ** -300])('of %f times the size has the same energies', (scale) => {
    const plain = jsonOf(['evaluate', '-', '--json'], { input: frame });
    const scaled = jsonOf(['evaluate', '-', '--json'], { input: moved(frame, (x) => x * scale) });
    expect(scaled.energies).toEqual({ ...plain.energies, area: plain.energies.area * scale * scale });
  });

  test('has an area that may be too large or too small for a double', () => {
    const huge = moved(cube, (x) => x * 2 ** 600);
    expect(outputOf(['evaluate', '-'], { input: huge })).toMatch(/^ {2}area +above 1.8e\+308$/m);
    expect(jsonOf(['evaluate', '-', '--json'], { input: huge }).energies.area).toBeNull();
    expect(outputOf(['evaluate', '-'], { input: moved(cube, (x) => x * 2 ** -600) })).toMatch(
      /^ {2}area +below 4.9e-324$/m,
    );
  });
});

describe('a cage far from the origin', () => {
  const far = scratch.write(
    'far.obj',
    moved(frame, (x) => x + 1e9),
  );
  const note =
    /^note: the cage lies so far .*\ntheir rounding changes energies of second order by up to \S+ of their value, of third order by up to \S+$/m;

  test('is minimized to a mesh that evaluates to what was reported, with a note on its digits', () => {
    const options = ['--functional', 'bending', '--levels', '0..1', '-q', '-o', 'out.obj', '--report', 'out.json'];
    expect(outputOf(['optimize', far, ...options], scratch)).toMatch(note);
    const {
      energies: { input_rounding, resolved, ...energies },
    } = JSON.parse(scratch.read('out.json'));
    expect(resolved).toBe(true);
    const again = jsonOf(['evaluate', 'out.obj', '--json'], scratch);
    for (const [name, energy] of Object.entries(energies)) {
      if (name === 'quadrature_error' || typeof energy !== 'number') continue;
      expect(Math.abs(again.energies[name] / energy - 1)).toBeLessThan(1e-12);
    }
    expect(input_rounding.mvs_cross).toBeGreaterThan(input_rounding.bending);
    expect(input_rounding.bending).toBeGreaterThan(1e-12);
  });

  test('has no note where it has all its digits', () => {
    expect(outputOf(['evaluate', '-'], { input: frame })).not.toMatch(note);
    expect(jsonOf(['evaluate', '-', '--json'], { input: frame }).energies.input_rounding).toBeUndefined();
  });
});

describe('repairs', () => {
  const inside_out = `v 9 9 9\n${tetrahedron}`.replace(
    /^f (\d) (\d) (\d)$/gm,
    (_, a, b, c) => `f ${[a, c, b].map((v) => Number(v) + 1).join(' ')}`,
  );

  test.each([['info'], ['evaluate'], ['optimize', '--functional', 'bending', '--levels', '0..0', '-q']])(
    'are said by %s',
    (...command) => {
      const out = outputOf([...command, '-'], { input: inside_out });
      expect(out).toContain('\nrepaired: turned 4 faces, so that what pointed inward points outward\n');
      expect(out).toContain('\nrepaired: dropped 1 vertex that no face uses\n');
    },
  );

  test('stand in the report', () => {
    expect(jsonOf(['info', '-', '--json'], { input: inside_out }).cage.repairs).toHaveLength(2);
    expect(jsonOf(['info', '-', '--json'], { input: tetrahedron }).cage.repairs).toEqual([]);
  });
});

describe('a cage that is no surface', () => {
  test.each([
    ['all vertices of the cage coincide', () => 1],
    ['all vertices of the cage lie on one line', (/** @type {number} */ v) => v * v],
  ])('is refused: %s', (reason, place) => {
    const faces = tetrahedron.slice(tetrahedron.indexOf('f'));
    const input = [1, 2, 3, 4].map((v) => `v ${place(v)} ${place(v)} ${place(v)}\n`).join('') + faces;
    for (const command of [['info'], ['evaluate'], ['optimize', '--functional', 'bending']]) {
      expect(umbilic([...command, '-'], { input })).toEqual({
        code: 3,
        out: '',
        err: `umbilic: standard input: line 5: face 1 is part of no surface: ${reason}\n`,
      });
    }
  });
});

describe('too much', () => {
  test('input is refused while it is read', () => {
    expect(umbilic(['info', '/dev/zero'])).toEqual({
      code: 3,
      out: '',
      err: 'umbilic: cannot read /dev/zero: it has more than 268435456 bytes\n',
    });
  });

  test('memory for a run is refused with the level that fits', () => {
    const line = 'optimize - --functional bending --levels 0..8 --no-symmetry --metric hessian';
    expect(umbilic(line.split(' '), { input: cube })).toEqual({
      code: 3,
      out: '',
      err: 'umbilic: standard input: level 8 would take 38 GB; at most level 7 fits in 16 GB\n',
    });
  });
});
