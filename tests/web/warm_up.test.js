// SPDX-License-Identifier: MIT
/**
 * @file The warm-up lets messages through between its units and ends with a core that works as before.
 */
import { beforeAll, expect, test } from '@jest/globals';
import { Cage, Minimizer, load } from '../../wasm/umbilic.js';
import { warmUp } from '../../web/worker/warm_up.js';

beforeAll(() => load());

test('the warm-up evaluates energies, one unit between two messages, and changes nothing', async () => {
  const energy = () => {
    const cage = Cage.generate('cube');
    const minimizer = new Minimizer(cage, { weights: { bending: 1 }, levels: [1, 1], maxIterations: 0 });
    while (!minimizer.step(1));
    const { bending } = minimizer.energies;
    minimizer.dispose();
    cage.dispose();
    return bending;
  };
  const before = energy();
  let yields = 0;
  await new Promise((resolve) => {
    warmUp(
      { Cage, Minimizer },
      (task) => {
        yields++;
        setImmediate(task);
      },
      () => resolve(undefined),
    );
  });
  expect(yields).toBeGreaterThan(10);
  expect(energy()).toBe(before);
});
