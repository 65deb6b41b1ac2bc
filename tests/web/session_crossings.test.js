// SPDX-License-Identifier: MIT
/**
 * @file The session, on the real core, tells where a surface at rest crosses itself.
 */
import { expect, test } from '@jest/globals';
import { cubes } from '../browser/cubes.js';
import { all, open, session, useSession, work } from './session_harness.js';

useSession();

test('a surface at rest is searched when that is asked, in the coordinates of the mesh that is shown', () => {
  open(1, { cage: { name: 'cubes.obj', text: cubes(0.9) } });
  work();
  expect(all('searched')).toEqual([]);
  session.obey({ type: 'search', run: 1 });
  const [{ crossings, evaluations, run }] = all('searched');
  expect({ places: crossings.places, evaluations, run }).toEqual({ places: 1, evaluations: 0, run: 1 });
  const { limit } = all('surfaced').at(-1);
  expect(crossings.triangles).toBe(
    all('surfaced').findLast((message) => message.limit.triangles).limit.triangles.length / 3,
  );
  // Half way between the cubes, which is the middle of the mesh.
  const xs = crossings.segments.filter((/** @type {number} */ _, /** @type {number} */ i) => i % 3 === 0);
  const extent = limit.positions.reduce((/** @type {number} */ most, /** @type {number} */ x) => Math.max(most, x), 0);
  for (const x of xs) expect(Math.abs(x)).toBeLessThan(0.01 * extent);
});

test('a surface that moves is not searched', () => {
  open(1, {}, { then: 'run' });
  work(3);
  session.obey({ type: 'search', run: 1 });
  expect(all('searched')).toEqual([]);
});
