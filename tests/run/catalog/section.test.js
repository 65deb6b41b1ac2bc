// SPDX-License-Identifier: MIT
/**
 * @file The catalog's tables, for a small catalog with known numbers.
 */
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { energyWords } from '../../../web/words/catalog_tables.js';
import { root } from '../process.js';
import { catalogSection } from './section.js';

const shapes = [
  { name: 'two-4', genus: 3, junctions: 2, arms: 4 },
  { name: 'tetrahedron-frame', genus: 3, junctions: 4, arms: 3 },
];
/** @param {string} shape @param {string} functional @param {number} energy @param {object} [more] */
const entry = (shape, functional, energy, more) => ({
  shape,
  functional,
  status: 'converged',
  energy,
  error: energy / 100,
  paper: null,
  exact: null,
  group: { name: 'D4h' },
  certificate: null,
  second_family: null,
  ...more,
});
const catalog = {
  shapes,
  functionals: [{ name: 'bending' }, { name: 'mvs_cross' }],
  entries: [
    entry('two-4', 'bending', 142, { paper: 142, exact: 141.5466, certificate: { level: 2, negative: 0 } }),
    entry('two-4', 'mvs_cross', 9000, { paper: 6000, second_family: { energy: 9090, error: 90, agrees: true } }),
    entry('tetrahedron-frame', 'mvs_cross', 8000, { paper: 4000, energies: { mvs: 2000, mvs_cross: 8100 } }),
  ],
  starts: [0.5, 1, 1.5].map((thickness) => ({ shape: 'two-4', functional: 'mvs_cross', thickness, energy: 9000 + thickness, level: 3, stop: 'converged' })), // prettier-ignore
};

describe('the energy of an entry', () => {
  const words = (/** @type {object} */ more) => energyWords(entry('two-4', 'bending', 1234.5, more));
  test('has two digits of its error', () => {
    expect(words({ error: 0.123 })).toBe('1234.50 ± 0.12');
    expect(words({ error: 12 })).toBe('1235 ± 12');
    expect(words({ error: 0.0096 })).toBe('1234.5000 ± 0.0096');
    expect(words({ error: 123 })).toBe('1230 ± 120');
  });
  test('says what else it is', () => {
    expect(words({ status: 'upper_bound', error: null })).toBe('≤ 1235');
    expect(words({ status: 'upper_bound', error: null, energy: 834.13 })).toBe('≤ 834.2');
    expect(words({ status: 'infimum_not_attained', error: null, energy: 779.27 })).toBe('→ 779.3');
    expect(words({ status: 'zero_attained', error: null, energy: 0 })).toBe('0');
  });
});

describe('the section', () => {
  const lines = catalogSection(catalog).split('\n');
  test.each([
    ['the paper beside ours, and what is exact', '| 3 | two-4 | D4h | 142.0 ± 1.4 | 142 | 1.0000 | 141.5466 |'],
    ['twice the paper over ours', '| 3 | tetrahedron-frame | D4h | 8000 ± 80 | 4000 | 2.0000 | 1.000 |'],
    [
      'other sums of our minimizers over the paper',
      '| 3 | tetrahedron-frame | 4000 | 8100 (2.025) | 4050 (1.012) | 6100 (1.525) | 3050 (0.762) | 2000 (0.500) | 1000 (0.250) |',
    ],
    ['the cost of a junction', '| tetrahedron-frame | 4 | 2000 ± 20 | 1000 |'],
    ['what is preferred', '| 3 | 2 × 4-way, two-4 | 9000 | 4 × 3-way, tetrahedron-frame | 8000 | yes |'],
    ['the other family', '| two-4 | mvs_cross | 9000 ± 90 | 9090 ± 90 | +1.0 % | yes |'],
    ['the starts', '| two-4 | mvs_cross | 3 | 9000.5000 | 9001.0000 | 9001.5000 | 1.1e-4 |'],
    ['certificates', '| two-4 | 0 (2) |  |'],
  ])('has %s', (_, line) => expect(lines).toContain(line));

  test('judges the claims by the costs of junctions', () => {
    const frames = [['two-3', 2, 10], ['tetrahedron-frame', 4, 11], ['hexagonal-prism-frame', 12, 12], ['dodecahedron-frame', 20, 20]]; // prettier-ignore
    const costs = (/** @type {number} */ prism) =>
      catalogSection({
        shapes: frames.map(([name, junctions]) => ({
          name: String(name),
          genus: 2,
          junctions: Number(junctions),
          arms: 3,
        })),
        functionals: catalog.functionals,
        entries: frames.map(([name, junctions, cost]) =>
          entry(
            String(name),
            'mvs_cross',
            Number(junctions) * (name === 'hexagonal-prism-frame' ? prism : Number(cost)),
          ),
        ),
        starts: [],
      });
    expect(costs(12)).toContain(
      'within a factor of 1.10 for two junctions, tetrahedron and cube, and of 2.00 over all',
    );
    expect(costs(12)).toContain('cheaper holds for its shapes: 10 to 11 against 12 to 12');
    expect(costs(12)).toContain(
      'It does not extend to the dodecahedron, whose junctions are as symmetric and cost 20.',
    );
    expect(costs(10.5)).toContain('cheaper does not hold');
  });
});

test("the catalog's README has the tables of its numbers: `npm run catalog -- readme` writes them", () => {
  const read = (/** @type {string} */ name) => readFileSync(path.join(root, 'web/catalog', name), 'utf8');
  expect(read('README.md')).toContain(catalogSection(JSON.parse(read('catalog.json'))));
});

test('the largest difference of what was computed another way is in a sentence, once entries have that', () => {
  const opinions = [1e-9, -3e-6, 2e-9, null, 5e-2];
  const entries = opinions.map((difference, i) => {
    const status = difference === 5e-2 ? 'zero_attained' : 'converged';
    return entry('two-4', `f${i}`, 142, { status, second_opinion: { energy: 142, difference } });
  });
  const sentence =
    'Computed another way, the minimized energies of these 3 surfaces differ by 3.0e-6 of themselves at most (`two-4`, `f1`), half of them by no more than 2.0e-9.';
  expect(catalogSection({ ...catalog, entries: [...catalog.entries, ...entries] }).split('\n')).toContain(sentence);
  expect(catalogSection(catalog)).not.toContain('Computed another way');
});

test('holes stand in a table of their own, and not among closed surfaces', () => {
  const hole = { name: 'hole-5', genus: 0, junctions: 0, arms: 0, sides: 5, cage: { rise: 0.25 } };
  const found = entry('hole-5', 'mvs_cross', 178, { group: { name: 'C5v' }, certificate: { level: 3, negative: 5 } });
  const all = { ...catalog, shapes: [...shapes, hole], entries: [...catalog.entries, found] };
  const lines = catalogSection(all).split('\n');
  expect(lines.filter((line) => line.includes('hole-5'))).toEqual([
    '| 5 | hole-5 | 0.25 | C5v | 178.0 ± 1.8 | 5 (3) |',
  ]);
  expect(catalogSection(catalog)).not.toContain('Holes');
});

test('what a minimizer descends to stands beside the surface with two junctions', () => {
  const below = { energy: 141.5482128, group: { name: 'D2' }, level: 3, certificate: { level: 3, negative: 0 } };
  const more = { group: { name: 'Td' }, certificate: { level: 3, negative: 2 }, below };
  const entries = [...catalog.entries, entry('tetrahedron-frame', 'bending', 144, more)];
  expect(catalogSection({ ...catalog, entries }).split('\n')).toContain(
    '| 3 | tetrahedron-frame | bending | 144.0 ± 1.4, Td | 141.54821 (level 3), D2 | 0 | 142.0 ± 1.4, two-4 |',
  );
});
