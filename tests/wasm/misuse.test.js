// SPDX-License-Identifier: MIT
/**
 * @file What the JavaScript face of the core says to callers who use it wrongly.
 */
import { beforeAll, describe, expect, test } from '@jest/globals';
import { InputError, Minimizer, load } from '../../wasm/umbilic.js';

beforeAll(() => load());

/** @param {import('../../wasm/types.js').Options & {terms?: import('../../wasm/types.js').Terms}} [asked] */
function cubeMinimizer({ terms = { bending: 1 }, ...options } = {}) {
  return new Minimizer({ cage: { generator: 'cube' }, terms, options: { levels: [1, 1], ...options } });
}

describe('misuse', () => {
  test('of a disposed handle is told by every method', () => {
    const minimizer = cubeMinimizer();
    const certificate = minimizer.certify();
    for (const handle of [minimizer, certificate]) handle.dispose();
    const calls = [
      () => minimizer.step(1),
      () => minimizer.cancel(),
      () => minimizer.progress,
      () => minimizer.problem,
      () => minimizer.cage,
      () => minimizer.group,
      () => minimizer.levels,
      () => minimizer.limit,
      () => minimizer.energies,
      () => minimizer.state,
      () => minimizer.report(),
      () => minimizer.certify(),
      () => minimizer.controlMesh(),
      () => minimizer.limitMesh(1),
      () => minimizer.controlObj(),
      () => minimizer.limitObj(1),
      () => certificate.step(1),
      () => certificate.progress,
      () => certificate.report,
    ];
    for (const use of calls) expect(use).toThrow(/^this (minimizer|certificate) has been disposed$/);
  });

  test.each(/** @type {any[]} */ ([undefined, null, 7, 'nothing', {}, { cage: 'cube' }, { cage: { text: 7 } }, []]))(
    'of %j as a problem is told in words',
    (problem) => {
      expect(() => new Minimizer(problem)).toThrow(InputError);
      expect(() => new Minimizer(problem)).toThrow(/\w/);
    },
  );

  test('of numbers is told with the number', () => {
    const minimizer = cubeMinimizer();
    for (const density of /** @type {any[]} */ ([0, -1, 1.5, NaN, 2 ** 31, '3'])) {
      expect(() => minimizer.limitMesh(density)).toThrow(`the density is ${density}, not a whole number of at least 1`);
    }
    expect(() => minimizer.step(-1)).toThrow('the number of units is -1');
    minimizer.dispose();
  });

  test('of a density that memory cannot hold is refused before memory is taken, and the run goes on', () => {
    const minimizer = cubeMinimizer({ levels: [6, 6] });
    const words = /density 512 would take \S+ GB; at most \d+ fits in 0.5 GB/;
    expect(() => minimizer.limitMesh(512)).toThrow(words);
    expect(() => minimizer.limitMesh(2 ** 31 - 1)).toThrow(/density 2147483647/);
    expect(minimizer.limitMesh(1).triangles).toHaveLength(6 * 24576);
    minimizer.dispose();
  });

  test('of a certificate that is not ready is told', () => {
    const minimizer = cubeMinimizer();
    const certificate = minimizer.certify();
    expect(() => certificate.report).toThrow('the certificate is not ready');
    expect(() => minimizer.report(certificate)).toThrow('the certificate is not ready');
    for (const handle of [minimizer, certificate]) handle.dispose();
  });
});
