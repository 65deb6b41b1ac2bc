// SPDX-License-Identifier: MIT
/**
 * @file What the catalog says of shapes, columns and entries, number by number.
 */
import { describe, expect, test } from '@jest/globals';
import {
  besideWords,
  boundaryWords,
  citation,
  columnWords,
  commands,
  energyWords,
  junctionWords,
  opinionWords,
  shapeTitle,
  typeset,
} from '../../../web/words/entries.js';
import { upperBound } from '../../../web/words/numbers.js';
import { catalog, entry, hole } from './small.js';

describe('an energy', () => {
  test.each(
    /** @type {Array<[Parameters<typeof entry>[2], ReturnType<typeof energyWords>]>} */ ([
      [{}, { value: '112.7669', error: '0.0076', note: '' }],
      [
        { status: 'upper_bound', energy: 263.41, error: null },
        { value: '≤ 263.5', error: '', note: '' },
      ],
      [
        { status: 'zero_attained', energy: 0, error: null },
        { value: '0', error: '', note: 'attained' },
      ],
      [
        { status: 'infimum_not_attained', energy: 8 * Math.PI ** 4, error: null },
        { value: '779.273', error: '', note: 'infimum, not attained' },
      ],
      [
        { status: 'none_found', energy: null, error: null },
        { value: '–', error: '', note: 'none found' },
      ],
    ]),
  )('of %j is %j', (more, words) => expect(energyWords(entry('two-3', 'bending', more))).toEqual(words));

  test.each([263.41, 4367.0001, 9999.9, 0.0123456, 112.7, 36420, 75720, 1e-7])(
    'that bounds from above is never rounded below %p, nor by more than its last digit',
    (value) => {
      const text = upperBound(value);
      const powers = /^(.*)\u202f×\u202f10⁻(.)$/.exec(text);
      const shown = powers
        ? Number(powers[1]) * 10 ** -'⁰¹²³⁴⁵⁶⁷⁸⁹'.indexOf(powers[2])
        : Number(text.replaceAll('\u202f', ''));
      // Powers of ten are not exact in binary: an ulp or so below is the same number.
      expect(shown).toBeGreaterThanOrEqual(value * (1 - 1e-15));
      expect(shown).toBeLessThanOrEqual(value * 1.001);
    },
  );

  test('stands beside the paper’s and the exact one where there are any', () => {
    expect(besideWords(catalog.entries[0])).toEqual(['paper 113', 'exact 112.7668']);
    expect(besideWords(entry('two-12', 'mvs', { paper: 75720 }))).toEqual(['paper 75\u202f720']);
    expect(besideWords(entry('torus', 'mvs', { status: 'zero_attained', energy: 0, exact: 0 }))).toEqual([]);
  });

  test('has what another way of computing finds beside it, where the entry tells', () => {
    const of = (/** @type {number | null} */ energy, /** @type {number | null} */ difference) =>
      opinionWords(entry('two-3', 'mvs_cross', { second_opinion: { energy, difference } }));
    expect(of(3917.4032, -2.04e-9)).toBe('Computed another way: 3917.4 (difference 2\u202f×\u202f10⁻⁹)');
    expect(of(112.7672, 0)).toBe('Computed another way: 112.767 (difference 0)');
    expect(of(null, null)).toBe('');
    expect(opinionWords(entry('two-3', 'bending'))).toBe('');
  });

  test.each([
    ["Lawson's xi_{2,1}", 'Lawson’s ξ₂,₁'],
    ["Lawson's xi_{11,1}, in 1/(g+1) to third order", 'Lawson’s ξ₁₁,₁, in 1/(g+1) to third order'],
    ['the Clifford torus: 8 pi^2', 'the Clifford torus: 8π²'],
    ['the energy changes by -24 % from level 1 to 2', 'the energy changes by −24 % from level 1 to 2'],
    ['the least of round tori, r/R = 0.241309', 'the least of round tori, r/R = 0.241309'],
    ['the second-order term', 'the second-order term'],
  ])('has its reason and source in words, where %p is set %p', (text, expected) => {
    expect(typeset(text)).toBe(expected);
  });

  test('comes from commands that name the cage, the functional and the levels', () => {
    const [two] = catalog.shapes;
    expect(commands(two, catalog.functionals[0], catalog.entries[0])).toBe(
      'umbilic cage two-3 --family flag -o two-3.obj\numbilic optimize two-3.obj --functional bending --levels 0..3',
    );
    const thick = { ...two, cage: { ...two.cage, thickness: 0.5 } };
    const text = commands(thick, catalog.functionals[2], catalog.entries[0]);
    expect(text).toMatch(/--thickness 0.5 .*--weights bending=1,mvs_cross=1 /s);
  });
});

test('a hole is named by its sides, and comes from commands that hold its boundary', () => {
  expect(shapeTitle('hole-5')).toBe('5-sided hole');
  expect(boundaryWords(hole)).toBe('curvature held');
  expect(boundaryWords(catalog.shapes[0])).toBe('');
  const deep = entry('hole-5', 'mvs');
  deep.settings = { ...deep.settings, metric: 'hessian', levels: [0, 5] };
  expect(commands(hole, catalog.functionals[1], deep)).toBe(
    'umbilic cage n-sided --sides 5 --rise 0.25 -o hole-5.obj\n' +
      'umbilic optimize hole-5.obj --functional mvs --boundary curvature --holes hole --levels 0..5 --metric hessian',
  );
});

describe('a title', () => {
  test('belongs to each shape and column', () => {
    expect(shapeTitle('sphere')).toBe('Sphere');
    expect(shapeTitle('two-3')).toBe('Two junctions, 3 arms');
    expect(junctionWords(catalog.shapes[1])).toBe('4 junctions of 3 arms');
    expect(junctionWords(catalog.shapes[3])).toBe('');
    expect(columnWords(catalog.functionals[0])).toMatchObject({ name: 'Bending energy', formula: '∫ κ₁² + κ₂² dA' });
    expect(columnWords(catalog.functionals[2]).name).toBe('Bending + MVS cross');
    expect(columnWords({ name: 'x', weights: { bending: 0.95, mvs_cross: 0.05 } }).name).toBe(
      '0.95 × Bending + 0.05 × MVS cross',
    );
  });

  test('and an address are how the catalog is cited, with its version', () => {
    expect(citation('0.1.0', 'https://example.org/umbilic/')).toMatch(
      /umbilic 0\.1\.0.*https:\/\/example\.org\/umbilic\//,
    );
  });
});
