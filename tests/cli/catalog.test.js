// SPDX-License-Identifier: MIT
/**
 * @file The catalog's command: computed, resumed, compared; and the committed catalog, whose cheap entries are computed anew.
 */
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { readFileSync, readdirSync, statSync } from 'node:fs';
import path from 'node:path';
import { root, scratchFolder, shell, umbilic } from './program.js';

const scratch = scratchFolder();
afterAll(scratch.dispose);

const few = [
  '--last-level',
  '1',
  '--shape',
  'two-3',
  '--functional',
  'bending',
  '--functional',
  'mvs_cross',
  '--quiet',
];
/** @param {string} folder @param {...string} args */
const catalog = (folder, ...args) => umbilic(['catalog', '--out', folder, ...few, ...args], { folder: scratch.folder });
const stored = () => JSON.parse(scratch.read('a/catalog.json'));

beforeAll(() => expect(catalog('a', '--threads', '2')).toMatchObject({ code: 0, out: '', err: '' }));

describe('a catalog', () => {
  test('has an entry for each shape and functional, a file with its report, and the thin and fat starts', () => {
    const { shapes, functionals, entries, starts } = stored();
    expect([shapes.length, functionals.length]).toEqual([24, 6]);
    expect(entries.map((/** @type {any} */ e) => [e.shape, e.functional, e.status])).toEqual([
      ['two-3', 'bending', 'upper_bound'],
      ['two-3', 'mvs_cross', 'upper_bound'],
    ]);
    for (const entry of entries) {
      const { group, levels, energies, limit, second_opinion: opinion } = entry;
      const report = JSON.parse(scratch.read(`a/${entry.minimizer}`));
      expect(report).toMatchObject({ umbilic: 'report', version: 1, group, levels, energies, limit });
      expect(report.problem).toMatchObject({
        cage: { generator: 'two-3', family: 'flag', thickness: 1 },
        terms: { [entry.functional]: 1 },
        options: { levels: [0, 1] },
      });
      expect(report.surface.level).toBe(1);
      expect(opinion.energy).toBe(report.second_opinion.values[entry.functional]);
      expect(opinion.difference).toBeCloseTo(report.second_opinion.differences[entry.functional] / opinion.energy, 14);
      expect(Math.abs(opinion.difference)).toBeLessThan(1e-3);
      expect(levels.map((/** @type {any} */ level) => level.seconds)).toEqual([null, null]);
      expect(entry.energies.gaussian).toBeCloseTo(-4 * Math.PI, 1);
    }
    expect(starts.map((/** @type {any} */ s) => `${s.functional} ${s.thickness} ${s.level}`)).toEqual(
      ['bending', 'mvs_cross'].flatMap((name) => [0.5, 1, 1.5].map((thickness) => `${name} ${thickness} 1`)),
    );
  });

  test('has the same bytes from one thread and from two', () => {
    expect(catalog('b', '--threads', '1').code).toBe(0);
    const names = readdirSync(scratch.path('a'));
    expect(readdirSync(scratch.path('b'))).toEqual(names);
    for (const name of names) expect(scratch.read(`b/${name}`)).toBe(scratch.read(`a/${name}`));
  });

  test('is not computed again but for what is missing', () => {
    const time = (/** @type {string} */ name) => statSync(scratch.path(`a/${name}`)).mtimeMs;
    const before = [time('catalog.json'), time('two-3.bending.json')];
    expect(catalog('a').code).toBe(0);
    expect([time('catalog.json'), time('two-3.bending.json')]).toEqual(before);
    scratch.write('a/two-3.mvs_cross.json', '{');
    expect(catalog('a').code).toBe(0);
    expect(scratch.read('a/two-3.mvs_cross.json')).toBe(scratch.read('b/two-3.mvs_cross.json'));
    expect(time('two-3.bending.json')).toBe(before[1]);
    const older = stored();
    delete older.entries[1].second_opinion;
    scratch.write('a/catalog.json', JSON.stringify(older));
    expect(catalog('a').code).toBe(0);
    expect(stored()).toEqual(JSON.parse(scratch.read('b/catalog.json')));
  });

  test('agrees with itself, and not with numbers that were changed', () => {
    expect(catalog('a', '--check')).toMatchObject({ code: 0, out: '8 compared, 0 differ\n' });
    const changed = stored();
    changed.entries[0].levels[1].energy_reported *= 1.001;
    scratch.write('b/catalog.json', JSON.stringify(changed));
    const { code, out } = catalog('b', '--check', '--functional', 'bending');
    expect(code).toBe(1);
    expect(out).toMatch(/^two-3\.bending: \S+ was \S+, 1\.0e-03 off, more than 1e-05$/m);
    expect(out).toMatch(/ compared, 1 differ\n$/);
  });

  test('compares what other kernels stored to its error bars, and says so', () => {
    const report = JSON.parse(scratch.read('a/two-3.bending.json'));
    scratch.write('b/two-3.bending.json', JSON.stringify({ ...report, instruction_set: 'another' }));
    const changed = stored();
    changed.entries[0].levels[1].energy_reported *= 1.0005;
    scratch.write('b/catalog.json', JSON.stringify(changed));
    expect(catalog('b', '--check')).toMatchObject({
      code: 0,
      out: '8 compared, 0 differ\n1 of these was stored with the kernels of another instruction set: compared to error bars, to 1e-3 where there are none\n',
    });
  });

  test('has what the commands of a hole’s details compute', () => {
    const run = (/** @type {string} */ line) => umbilic(line.split(' '), { folder: scratch.folder });
    expect(catalog('d', '--shape', 'hole-5').code).toBe(0);
    const { entries } = JSON.parse(scratch.read('d/catalog.json'));
    const { levels } = entries.find((/** @type {any} */ entry) => entry.shape === 'hole-5');
    expect(run('cage n-sided --sides 5 --rise 0.25 -o hole.obj').code).toBe(0);
    const optimize = 'optimize hole.obj --functional mvs_cross --boundary curvature --holes hole --levels 0..1 --quiet';
    expect(run(`${optimize} --report hole.json`).code).toBe(0);
    const report = JSON.parse(scratch.read('hole.json'));
    const energies = (/** @type {any[]} */ list) => list.map(({ energy_reported }) => energy_reported);
    expect(energies(report.levels)).toEqual(energies(levels));
  });

  test('refuses names that it does not know, and a catalog that is no JSON', () => {
    const unknown = umbilic(['catalog', '--out', 'c', '--shape', 'two-13'], { folder: scratch.folder });
    expect(unknown.code).toBe(2);
    expect(unknown.err).toContain("'two-13' is none of two-3, two-4, tetrahedron-frame");
    scratch.write('b/catalog.json', '{');
    const broken = catalog('b');
    expect(broken.code).toBe(3);
    expect(broken.err).toContain('catalog.json is not JSON');
  });
});

describe('its progress', () => {
  const command =
    'catalog --last-level 0 --shape sphere --shape torus --functional bending --functional mvs_cross --out';

  test('is a line for each entry that is done, where standard error is no terminal', () => {
    const { code, err } = umbilic([...command.split(' '), 'lines'], { folder: scratch.folder });
    expect(code).toBe(0);
    const counts = [...err.matchAll(/^(\d+) of 4 entries\n/gm)].map(([, done]) => Number(done));
    expect(err.split('\n')).toHaveLength(counts.length + 1);
    expect(counts.length).toBeGreaterThan(0);
    expect(counts).toEqual([...new Set(counts)].sort((a, b) => a - b));
  });

  test('is a bar on a terminal, gone when all is done', () => {
    const { code, out } = shell(`script -qec "$UMBILIC ${command} bar" /dev/null < /dev/null`, scratch.folder);
    expect(code).toBe(0);
    const [first, ...rest] = out.split('\x1b[K');
    expect(first).toMatch(/^\r\[=* *\] \d+ of 4 entries, \S.* level \d+$/);
    for (const [, bar] of out.matchAll(/\[(=* *)\]/g)) expect(bar).toHaveLength(30);
    expect(rest.slice(-2)).toEqual(['\r', '']);
  });
});

describe('the committed catalog', () => {
  const folder = path.join(root, 'web/catalog');
  const committed = JSON.parse(readFileSync(path.join(folder, 'catalog.json'), 'utf8'));

  test('has every entry, with its file', () => {
    const { shapes, functionals, entries } = committed;
    expect(entries.map((/** @type {any} */ e) => `${e.shape}.${e.functional}`)).toEqual(
      shapes.flatMap((/** @type {any} */ s) =>
        functionals
          .filter((/** @type {any} */ f) => !s.sides || f.name === 'mvs_cross')
          .map((/** @type {any} */ f) => `${s.name}.${f.name}`),
      ),
    );
    const files = readdirSync(folder).filter((name) => name.endsWith('.json') && name !== 'catalog.json');
    const named = entries.flatMap((/** @type {any} */ e) => [e.minimizer, e.below?.minimizer]).filter(Boolean);
    expect(files.sort()).toEqual(named.sort());
    const bytes = [...files, 'catalog.json'].reduce((sum, name) => sum + statSync(path.join(folder, name)).size, 0);
    expect(bytes).toBeLessThan(8.5e6);
  });

  test('is what the program computes: its cheap entries, from nothing', () => {
    for (const args of [
      ['--shape', 'sphere', '--functional', 'bending'],
      ['--shape', 'torus', '--functional', 'mvs_cross'],
      ['--shape', 'two-3', '--functional', 'bending'],
      ['--shape', 'hole-4'],
    ]) {
      const { code, out } = umbilic(['catalog', '--out', folder, '--check', '--quiet', ...args]);
      expect({ code, out }).toMatchObject({ code: 0, out: expect.stringMatching(/^\d+ compared, 0 differ\n/) });
    }
  });
});
