// SPDX-License-Identifier: MIT
/**
 * @file Numbers and names as the page prints them.
 */
import { existsSync } from 'node:fs';
import { describe, expect, test } from '@jest/globals';
import { cageWords, stemOf } from '../../web/words/cages.js';
import { energyWarnings, roundingWords } from '../../web/words/energies.js';
import { SHAPES } from '../../web/pages/studio/views/examples.js';
import { blendWords, caps, functionals, functionalWords } from '../../web/words/functionals.js';
import {
  certificateDetails,
  certificateWords,
  groupWords,
  limitWords,
  metricWords,
  repairWords,
  schoenflies,
  thickenedWords,
} from '../../web/words/results.js';
import {
  compact,
  counted,
  duration,
  integer,
  lowerBound,
  significant,
  tickText,
  upperBound,
  withError,
} from '../../web/words/numbers.js';

import { certificate, energies, levelReport, noLimit } from './studio/state.js';

/** The narrow space between groups of digits does not break. @param {string} text */
const narrow = (text) => text.replaceAll(' ', '\u202f');

describe('a number', () => {
  test.each([
    [112.7668123, 6, '112.767'],
    [-12.566370614, 6, '−12.5664'],
    [4227.3, 6, '4227.30'],
    [26500.123, 6, '26 500.1'],
    [0.00012345678, 4, '0.0001235'],
    [1.3e-7, 2, '1.3 × 10⁻⁷'],
    [2.5e12, 3, '2.50 × 10¹²'],
    [0, 6, '0'],
    [999999.96, 6, '1 000 000'],
    [NaN, 6, '–'],
    [Infinity, 6, '∞'],
    [-Infinity, 6, '−∞'],
  ])('%p to %p digits is %p', (value, digits, text) => expect(significant(value, digits)).toBe(narrow(text)));

  test.each([
    [0.5, '0.5'],
    [-2, '−2'],
    [1.25, '1.25'],
    [1000, '1000'],
    [0, '0'],
    [1e-6, '1 × 10⁻⁶'],
  ])('%p is short as %p', (value, text) => expect(compact(value)).toBe(narrow(text)));

  test.each([
    [112.76693, 0.00031, '112.7669', '0.0003'],
    [112.76693, 0.0000962, '112.76693', '0.00010'],
    [3936.04, 0.0213, '3936.040', '0.021'],
    [3936.04, 12.3, '3936', '12'],
    [-12.566, 0.5, '−12.6', '0.5'],
    [3936.04, 123, '3940', '120'],
    [112.7668, 1e-13, '112.7668000', '1 × 10⁻¹³'],
  ])('%p ± %p has the digits that its error justifies', (value, error, text, bar) => {
    expect(withError(value, error)).toEqual({ value: text, error: narrow(bar) });
  });

  test.each([
    [2000, '2000'],
    [-0.5, '−0.5'],
    [0, '0'],
    [1e5, '10⁵'],
    [1.5e7, '1.5 × 10⁷'],
    [1e-9, '10⁻⁹'],
    [-2e6, '−2 × 10⁶'],
  ])('%p is %p on an axis', (value, text) => expect(tickText(value)).toBe(narrow(text)));

  test.each([
    [3917.4, 36.2, '3917', '36'],
    [3917.4, 3.62, '3917.4', '3.6'],
    [78.956794, 0.0034013, '78.9568', '0.0034'],
    [112.76693, 0.0000962, '112.766930', '0.000096'],
    [112.7, 9.96, '113', '10'],
    [3936.04, 123, '3940', '120'],
  ])('%p ± %p with two digits of its error', (value, error, text, bar) => {
    expect(withError(value, error, 2)).toEqual({ value: text, error: bar });
  });

  test('that is a bound remains one when it is rounded', () => {
    const energy = 8 * Math.PI ** 2; // 78.956835…
    expect(upperBound(energy, 7)).toBe('78.95684');
    expect(lowerBound(energy, 7)).toBe('78.95683');
    expect([upperBound(8 * Math.PI), lowerBound(8 * Math.PI)]).toEqual(['25.14', '25.13']);
    expect([upperBound(0.25, 2), lowerBound(0.25, 2), lowerBound(0)]).toEqual(['0.25', '0.25', '0']);
  });

  test('without an error has no error bar', () => {
    expect(withError(112.7668, 0).error).toBe('');
    expect(withError(NaN, 0.1)).toEqual({ value: '–', error: '' });
    expect(withError(1, NaN).error).toBe('');
  });

  test('of things, of thousands and of seconds', () => {
    expect(counted(1, 'face')).toBe('1 face');
    expect(counted(12288, 'face')).toBe(`${narrow('12 288')} faces`);
    expect(integer(-3)).toBe('−3');
    expect(duration(0.42)).toBe('0.4 s');
    expect(duration(59.6)).toBe('1 min 0 s');
    expect(duration(200)).toBe('3 min 20 s');
  });
});

describe('a name', () => {
  test.each([
    ['two-3', 'Two junctions, 3 arms', 2],
    ['tetrahedron-frame', 'Tetrahedron frame', 3],
    ['cube-frame', 'Cube frame', 5],
    ['octahedron-frame', 'Octahedron frame', 7],
    ['hexagonal-prism-frame', 'Hexagonal prism frame', 7],
    ['truncated-tetrahedron-frame', 'Truncated tetrahedron frame', 7],
    ['dodecahedron-frame', 'Dodecahedron frame', 11],
    ['cube', 'Cube', 0],
    ['torus', 'Torus', 1],
    ['something-new', 'something-new', null],
  ])('of the cage %s is %s, of genus %p', (name, title, genus) => {
    expect(cageWords(name)).toMatchObject({ title, genus });
  });

  test('of a file is fit for another file', () => {
    expect(stemOf('spot_control_mesh.obj')).toBe('spot_control_mesh');
    expect(stemOf('C:\\cages\\my cage (1).OFF')).toBe('my-cage-1');
    expect(stemOf('scan.ply')).toBe('scan');
    expect(stemOf('/a/b/übung.obj')).toBe('übung');
    expect(stemOf('???')).toBe('cage');
  });

  test('of a functional comes with what it prefers, and with pictures that the catalog has', () => {
    const pictures = new URL('../../web/catalog/pictures/', import.meta.url);
    for (const { prefers, pictured } of [...functionals, blendWords]) {
      expect(prefers).toMatch(/^\p{Lu}.*\.$/u);
      for (const shape of pictured ? SHAPES : []) {
        expect(existsSync(new URL(`${shape}.${pictured}.webp`, pictures))).toBe(true);
      }
    }
  });

  test('and a formula belong to each functional, and a meaning to each cap', () => {
    expect(functionals).toHaveLength(8);
    for (const { id, formula, areaPower } of functionals) {
      expect(functionalWords(id).name.length).toBeGreaterThan(3);
      expect(/^(A²? )?∫/.exec(formula)?.[0]).toBe(['∫', 'A ∫', 'A² ∫'][areaPower]);
    }
    expect(caps.map(({ id }) => id).sort()).toEqual(['flat', 'none', 'smooth']);
  });
});

describe('the limit of the levels', () => {
  test('is a value with its error and the observed order, if there is one', () => {
    const limit = {
      status: /** @type {const} */ ('converging'),
      energy: 3917.4,
      order: 1.86,
      error: 36.2,
      lower: 3917.4 - 36.2,
      caps_included: true,
    };
    expect(limitWords(limit)).toEqual({ value: '3917', error: '36', words: 'observed order 1.9' });
    expect(limitWords({ ...limit, order: NaN }).words).toBe('the last levels agree');
    expect(limitWords({ ...limit, caps_included: false }).words).toBe(
      'observed order 1.9, without the caps’ own error',
    );
  });

  test('has a bar that ends where no surface is', () => {
    const limit = {
      status: /** @type {const} */ ('converging'),
      energy: 25.2,
      order: 2,
      error: 0.5,
      lower: 8 * Math.PI,
      caps_included: true,
    };
    expect(limitWords(limit)).toEqual({
      value: '25.20',
      error: '0.50',
      words: 'observed order 2.0, but not below 25.13274, as no surface is',
    });
    const { lower, caps_included: capsIncluded, ...earlier } = limit;
    expect(capsIncluded).toBe(true);
    expect(lower).toBeGreaterThan(limit.energy - limit.error);
    // The limit of a report that an earlier version wrote.
    expect(limitWords(/** @type {typeof limit} */ (earlier)).words).toBe('observed order 2.0');
  });

  test.each([
    ['too_few_levels', NaN, /three levels/],
    ['not_minimized', NaN, /ended early/],
    ['not_resolved', NaN, /not the surface’s/],
    ['not_comparable', NaN, /its own weight/],
    ['not_converging', 0.4, /do not settle \(observed order 0\.4\)$/],
    ['not_converging', NaN, /do not settle$/],
  ])('that there is none of says why: %s', (status, order, reason) => {
    const { value, error, words } = limitWords({ ...noLimit(), status: /** @type {any} */ (status), order });
    expect([value, error]).toEqual(['', '']);
    expect(words).toMatch(/^\p{Ll}.*[^.]$/u);
    expect(words).toMatch(reason);
  });
});

describe('a symmetry', () => {
  test.each([
    ['D3h', 'D', '3h'],
    ['Oh', 'O', 'h'],
    ['C1', 'C', '1'],
    ['T', 'T', ''],
  ])('%s is the letter %s with the index %p', (name, letter, index) => {
    expect(schoenflies(name)).toEqual({ letter, index });
  });

  test('is named with its order where it is kept', () => {
    const group = { name: 'D3h', order: 12 };
    expect(groupWords(group, true)).toEqual({ symbol: 'D3h', words: ', order 12' });
    expect(groupWords({ name: 'C1', order: 1 }, true).words).toBe('the cage has none');
    expect(groupWords(group, false)).toEqual({ symbol: '', words: '' });
    expect(groupWords(null, true)).toEqual({ symbol: '', words: '' });
  });

  test('may be more than was found where the search was given up', () => {
    const incomplete = 'the search was given up';
    expect(groupWords({ name: 'D3h', order: 12, incomplete }, true).words).toBe(
      ', order 12 or more: the search was given up',
    );
    expect(groupWords({ name: 'C1', order: 1, incomplete }, true)).toEqual({
      symbol: '',
      words: 'none known: the search was given up',
    });
  });
});

describe('a certificate', () => {
  const group = { name: 'D3h', order: 12 };
  /** @param {number} negative @param {typeof group | null} kept @param {Parameters<typeof certificateWords>[2]} stop */
  function sentence(negative, kept = group, stop = 'converged') {
    const { before, symbol, after } = certificateWords({ ...certificate(), negative }, kept, stop);
    return before + symbol + after;
  }

  test('says whether the surface is a minimum, and which surfaces are lower', () => {
    expect(sentence(0)).toBe('Yes: on this mesh no surface near it has less energy.');
    expect(sentence(6)).toBe('No: 6 directions lower the energy, and break its symmetry (D3h).');
    expect(sentence(1)).toBe('No: 1 direction lowers the energy, and breaks its symmetry (D3h).');
    expect(sentence(2, { name: 'C1', order: 1 })).toBe('No: 2 directions lower the energy. It is a saddle.');
  });

  test('calls nothing a minimum that has not converged', () => {
    expect(sentence(0, group, 'cancelled')).toBe('Not known: the run ended too early to tell.');
    expect(sentence(6, group, 'max_iterations')).toBe('Not yet: 6 directions lower the energy.');
  });

  test('tells its unknowns and its threshold', () => {
    expect(certificateDetails(certificate())).toBe('1146 unknowns, τ\u00a0=\u00a00.001');
  });
});

describe('what is said where it applies', () => {
  test('names each repair of a cage, and then each note', () => {
    const counts = { vertices: 4, edges: 6, faces: 4, genus: 0 };
    const rest = { components: [{ ...counts, boundaries: 0 }], boundaries: [], groups: [], notes: [] };
    const report = { ...counts, ...rest, repairs: ['turned 4 faces', 'dropped 1 vertex'] };
    expect(repairWords(report)).toEqual(['Repaired: turned 4 faces.', 'Repaired: dropped 1 vertex.']);
    expect(repairWords({ ...report, repairs: [] })).toEqual([]);
    expect(repairWords({ ...report, repairs: ['a'], notes: ['ignored 1 tag'] })).toEqual([
      'Repaired: a.',
      'Note: ignored 1 tag.',
    ]);
  });

  test('names the levels that began thicker', () => {
    const levels = [levelReport(0, { thickened: true }), levelReport(1)];
    expect(thickenedWords(levels)).toEqual([
      'Level 0 began thicker than it was: its samples missed curvature of its rims.',
    ]);
  });

  test('warns of energies that no closed surface has', () => {
    expect(energyWarnings(energies(113))).toEqual([]);
    const [bound] = energyWarnings({ resolved: true, below_bound: true });
    expect(bound).toMatch(/^No closed surface .* not the surface’s\.$/);
    const [gauss] = energyWarnings({ resolved: false, below_bound: false });
    expect(gauss).toMatch(/^∫ K dA is not 2πχ: .* not the surface’s\.$/);
  });

  test('says what the rounding of a cage far away changes, unless it is less than the digits that are shown', () => {
    /** @param {number} second @param {number} third */
    const changes = (second, third) => ({
      ...{ bending: second, willmore: second / 2 },
      ...{ mvs: NaN, mvs_cross: third, mehlum_tarrou: third / 3, second_form_variation: third / 2 },
      ...{ mean_curvature_variation: third / 4, curvedness_variation: third / 5 },
    });
    expect(roundingWords(undefined)).toBe('');
    expect(roundingWords(changes(1e-14, 9e-13))).toBe('');
    expect(roundingWords(changes(2.5e-8, 0.0012))).toContain(narrow('2.5 × 10⁻⁸'));
    expect(roundingWords(changes(2.5e-8, 0.0012))).toMatch(/third-order ones by up to 0\.0012\.$/);
  });
});

test('every metric has a name', () => expect(Object.values(metricWords)).toHaveLength(4));
