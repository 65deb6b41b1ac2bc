// SPDX-License-Identifier: MIT
/**
 * @file What a run says beyond its energies: the symmetry that it keeps, its metric, the limit of its levels and its
 * certificate.
 */
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { jsonOf, outputOf, scratchFolder, start, umbilic } from './program.js';

const scratch = scratchFolder();
afterAll(scratch.dispose);

beforeAll(() => {
  outputOf(['cage', 'two-3', '-o', 'frame.obj'], scratch);
  outputOf(['cage', 'torus', '-o', 'torus.obj'], scratch);
  outputOf(['cage', 'tetrahedron-frame', '-o', 'tetrahedron.obj'], scratch);
  outputOf(['cage', 'dodecahedron-frame', '-o', 'large.obj'], scratch);
});

/** @param {string} line @returns {any} the report of a run */
const reportOf = (line) => jsonOf(`optimize ${line} -q --report -`.split(' '), scratch);

/** @param {string} line @returns {string} the table of a run */
const tableOf = (line) => outputOf(`optimize ${line} -q`.split(' '), scratch);

describe('symmetry', () => {
  test('is kept and named, and leaves few unknowns', () => {
    const { group, levels } = reportOf('frame.obj --functional bending --levels 0..1');
    expect(group).toEqual({ name: 'D3h', order: 12 });
    expect(levels.map((/** @type {any} */ l) => l.unknowns)).toEqual([8, 29]);
  });

  test('is given up with --no-symmetry, which changes no energy of a minimizer that has it', () => {
    const line = 'torus.obj --functional bending --levels 1';
    const kept = reportOf(line);
    const free = reportOf(`${line} --no-symmetry`);
    expect(kept.group).toEqual({ name: 'D6h', order: 24 });
    expect(free.group).toEqual({ name: 'C1', order: 1 });
    expect(free.levels[0].unknowns).toBe(3 * 192);
    for (const { energies } of [kept, free]) {
      expect(Math.abs(energies.bending / (8 * Math.PI ** 2) - 1)).toBeLessThan(1e-4); // of splines with 192 patches
    }
  });
});

describe('--metric', () => {
  test.each([
    ['auto', 'hessian'],
    ['hessian', 'hessian'],
    ['newton', 'newton'],
    ['sobolev', 'sobolev'],
    ['identity', 'identity'],
  ])('%s is reported as %s', (option, name) => {
    const line = `frame.obj --functional bending --levels 0 --max-iterations 30 --metric ${option}`;
    const [level] = reportOf(line).levels;
    expect(level.metric).toBe(name);
    if (name === 'identity') expect(level.metrics).toBe(0);
    else expect(level.metrics).toBeGreaterThan(0);
    expect(tableOf(line)).toMatch(new RegExp(`^ +0 .*  ${name} +\\w+$`, 'm'));
  });
});

describe('the limit', () => {
  test('of levels that converge is their energy with an error that holds the true one', () => {
    const line = 'torus.obj --functional bending --levels 0..2';
    const { limit } = reportOf(line);
    expect(limit).toEqual({
      status: 'converging',
      energy: expect.any(Number),
      order: expect.any(Number),
      error: expect.any(Number),
      lower: expect.any(Number),
      caps_included: true,
    });
    expect(Math.abs(limit.energy - 8 * Math.PI ** 2)).toBeLessThan(limit.error);
    expect(limit.lower).toBeCloseTo(8 * Math.PI ** 2, 12); // where the bar is cut
    const [, energy, error, order, bound] =
      /^extrapolated (\S+) \+- (\S+) \(observed order (\S+)\), but not below (\S+), as no surface is$/m.exec(
        tableOf(line),
      ) ?? [];
    expect(Number(bound)).toBeCloseTo(8 * Math.PI ** 2, 4);
    expect(Number(bound)).toBeLessThanOrEqual(8 * Math.PI ** 2); // rounded downwards
    expect(Math.abs(Number(energy) - limit.energy)).toBeLessThan(limit.error / 10);
    expect(Math.abs(Number(error) / limit.error - 1)).toBeLessThan(0.1);
    expect(Number(order)).toBeCloseTo(limit.order, 1);
  });

  test.each([
    ['frame.obj --functional bending --levels 0..1', 'too_few_levels', 'too few levels; three are needed'],
    [
      'frame.obj --functional bending --levels 0..2 --max-iterations 3',
      'not_minimized',
      'one of the last three levels did not converge',
    ],
    [
      'frame.obj --functional bending --levels 0..2 --within 0.05',
      'not_comparable',
      'each level has its own weight with which it stays within the distance, so that their energies do not compare',
    ],
    [
      'frame.obj --functional mvs --levels 0..2',
      'not_converging',
      /not extrapolated: [\d.]+ is an upper bound, the levels do not converge/,
    ],
  ])('of "%s" is %s', (line, status, words) => {
    const { limit, levels } = reportOf(line);
    expect(limit).toMatchObject({ status, energy: levels.at(-1).energy_reported, error: null });
    const table = tableOf(line);
    if (typeof words === 'string') expect(table).toContain(`\nnot extrapolated: ${words}\n`);
    else expect(table).toMatch(words);
  });
});

describe('a surface that folds flat', () => {
  // A square from both sides: the curvature of its rim is a fold that no sample sees.
  const square = (/** @type {number} */ size) =>
    [-size, size].flatMap((x) => [-size, size].map((y) => `v ${x} ${y} 0`)).join('\n');
  const faces = ['1 2 4 3', '5 7 8 6', '1 5 6 2', '3 4 8 7', '1 3 7 5', '2 6 8 4'].map((f) => `f ${f}`).join('\n');
  const input = `${square(1)}\n${square(0.9)}\n${faces}\n`;
  const warning = 'warning: the Gaussian curvature does not add up to 2 pi times the Euler characteristic';

  test('has energies that are not believed', () => {
    const evaluated = umbilic(['evaluate', '-'], { input });
    expect(evaluated).toMatchObject({ code: 5, out: expect.stringContaining(warning) });
    const { code, out } = umbilic('optimize - --functional bending --levels 0..2 -q'.split(' '), { input });
    expect(code).toBe(5);
    expect(out).toContain("\nnot extrapolated: the last level's energy is not the surface's\n");
    expect(out).toContain(warning);
    expect(out).toContain('warning: no closed surface of this genus has so little bending or Willmore energy');
    expect(out.match(/ below_bound$/gm)).toHaveLength(3);
    expect(outputOf(['evaluate', 'frame.obj'], scratch)).not.toContain('warning');
  });

  test('is written all the same, with what it violates', () => {
    const { code } = umbilic('optimize - --functional mvs --levels 0 -q --report flat.json'.split(' '), {
      input,
      folder: scratch.folder,
    });
    expect(code).toBe(5);
    const report = JSON.parse(scratch.read('flat.json'));
    expect(report.energies).toMatchObject({ resolved: false, below_bound: true, embedded: false });
    expect(report.levels[0]).toMatchObject({ stop: 'below_bound', credible: false });
  });
});

describe('a thin plate', () => {
  const corners = [-1, 1].flatMap((z) => [-1, 1].flatMap((y) => [-1, 1].map((x) => `v ${x} ${y} ${0.003 * z}`)));
  const faces = ['1 3 4 2', '5 6 8 7', '1 2 6 5', '2 4 8 6', '4 3 7 8', '3 1 5 7'].map((f) => `f ${f}`);
  const input = [...corners, ...faces, ''].join('\n');

  test('becomes a sphere, and is told to have begun thicker', () => {
    const { code, out } = umbilic('optimize - --functional bending --levels 0..2 -q'.split(' '), { input });
    expect(code).toBe(0);
    expect(out).toContain('level 0 began thicker than it was: its samples missed curvature of its rims');
    expect(Number(/bending +(\S+)/.exec(out.split('energies of')[1])?.[1]) / (8 * Math.PI)).toBeCloseTo(1, 3);
  });

  test('as it is has energies that are not its own', () => {
    expect(umbilic(['evaluate', '-'], { input }).code).toBe(5);
    expect(umbilic('optimize - --functional bending --max-iterations 0 -q'.split(' '), { input }).code).toBe(5);
  });
});

describe('noise as long as the edges', () => {
  test('ends with the best of its levels, which is named', () => {
    const torus = outputOf(['cage', 'torus'], scratch);
    let state = 1;
    const noise = () => (state = (state * 16807) % 2147483647) / 2147483647 - 0.5;
    const input = torus.replace(/^v .*$/gm, (line) =>
      line.replace(/-?\d[\d.e-]*/g, (number) => String(Number(number) + noise())),
    );
    const line = 'optimize - --functional bending --levels 0..2 --max-iterations 3 -q -o best.obj';
    const run = (/** @type {string} */ more) => umbilic(`${line}${more}`.split(' '), { input, folder: scratch.folder });
    const { levels, surface, energies } = JSON.parse(run(' --report -').out);
    const resultLevel = surface.level;
    const candidates = levels.filter((/** @type {any} */ l) => l.credible !== false);
    const least = Math.min(
      ...(candidates.length ? candidates : levels).map((/** @type {any} */ l) => l.energy_reported),
    );
    expect(energies.bending).toBe(least);
    expect(levels[resultLevel].energy_reported).toBe(least);
    if (resultLevel < 2)
      expect(run('').out).toContain(`energies of level ${resultLevel}, which is better than the last`);
    const again = JSON.parse(umbilic(['evaluate', 'best.obj', '--json'], scratch).out);
    expect(Math.abs(again.energies.bending / least - 1)).toBeLessThan(1e-12);
  });
});

describe('embeddedness', () => {
  test('is told where the Willmore energy proves it', () => {
    const line = 'optimize torus.obj --functional bending --levels 0 -q';
    expect(outputOf(line.split(' '), scratch)).toContain('\nembedded: with a Willmore energy below 8 pi no surface');
    expect(jsonOf(`${line} --report -`.split(' '), scratch).energies.embedded).toBe(true);
    expect(outputOf(['evaluate', 'large.obj'], scratch)).not.toContain('embedded');
  });
});

describe('--certify', () => {
  test('finds a minimum', () => {
    const line = 'frame.obj --functional bending --levels 0..2 --certify';
    const report = reportOf(line);
    expect(Object.keys(report).slice(-2)).toEqual(['certificate', 'surface']);
    expect(report.certificate).toEqual({ level: 2, unknowns: 1146, gauge: 10, tau: 0.001, negative: 0 });
    expect(tableOf(line)).toContain(
      '\ncertificate: a local minimum among all surfaces near it (level 2, 1146 unknowns, 10 gauge directions, tau 0.001)\n',
    );
  });

  test('finds directions that leave the symmetry', () => {
    const line = 'tetrahedron.obj --functional bending --levels 0..2 --certify';
    expect(reportOf(line).certificate).toMatchObject({ negative: 2, unknowns: 2292 });
    expect(tableOf(line)).toContain(
      '\ncertificate: 2 directions lower the energy: a minimum only within its symmetry Td (level 2, 2292 unknowns, ',
    );
  });

  test('with --descend, leads to a lower surface until there is a minimum, and tells what it left', () => {
    const line = 'tetrahedron.obj --functional bending --levels 0..2 --descend';
    const table = tableOf(line);
    expect(table).toMatch(
      /^left 143\.\d+ \(level 2, symmetry Td, order 24\): 2 directions lower the energy\nminimized bending, cap smooth, symmetry /m,
    );
    expect(table).toContain('\ncertificate: a local minimum among all surfaces near it');
    const { problem, levels, certificate } = reportOf(line);
    expect(problem.start.level).toBe(2);
    expect(levels).toHaveLength(1);
    // Lawson's surface of genus 3 with two junctions, at a coarse level.
    expect(levels[0].energy_reported).toBeGreaterThan(141.54);
    expect(levels[0].energy_reported).toBeLessThan(141.7);
    expect(certificate.negative).toBe(0);
  });

  test('tells one direction in the singular, and where there is no symmetry speaks of none', () => {
    const line = 'torus.obj --functional bending --levels 0..1 --certify';
    expect(tableOf(line)).toContain('\ncertificate: 1 direction lowers the energy: a minimum only within its symmetry');
    expect(tableOf(`${line} --no-symmetry --max-iterations 0`)).toMatch(
      /^certificate: \d+ directions lower the energy: no minimum \(level \d, 576 /m,
    );
  });

  test('removes no conformal maps where a functional is not invariant under them', () => {
    const { certificate } = reportOf('frame.obj --functional mvs_cross --levels 0 --certify');
    expect(certificate).toMatchObject({ gauge: 7, unknowns: 66 });
  });

  test('of flat caps ends with 3 after all results are written', () => {
    const line = 'optimize frame.obj --functional bending --levels 0 --cap flat -q --certify --report flat.json';
    const { code, out, err } = umbilic(line.split(' '), { folder: scratch.folder });
    expect(code).toBe(3);
    expect(err).toBe("umbilic: no certificate with cap flat: its second derivatives take the caps' normals as fixed\n");
    expect(out).toContain('energies of the last level');
    const report = JSON.parse(scratch.read('flat.json'));
    expect(report.certificate).toBeUndefined();
    expect(report.levels).toHaveLength(1);
  });

  test('is left out after Ctrl-C', async () => {
    const line = 'optimize large.obj --functional mvs_cross --levels 0..4 --certify --report cut.json';
    const running = start(line.split(' '), scratch.folder);
    await running.says(/^level 0: .*\n/);
    running.child.kill('SIGINT');
    expect(await running.ended).toEqual({ code: 130, signal: null });
    const report = JSON.parse(scratch.read('cut.json'));
    expect(report.levels.at(-1).stop).toBe('cancelled');
    expect(report.certificate).toBeUndefined();
  });
});
