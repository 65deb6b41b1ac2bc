// SPDX-License-Identifier: MIT
/**
 * @file The warm-up lets messages through between its units and ends with a core that works as before.
 */
import { beforeAll, expect, test } from '@jest/globals';
import { Minimizer, load } from '../../wasm/umbilic.js';
import { warmUp } from '../../web/worker/warm_up.js';

beforeAll(() => load());

test('the warm-up evaluates energies, one unit between two messages, and changes nothing', async () => {
  const energy = () => {
    const minimizer = new Minimizer({
      cage: { generator: 'cube' },
      terms: { bending: 1 },
      options: { levels: [1, 1], max_iterations: 0 },
    });
    while (!minimizer.step(1));
    const { bending } = minimizer.energies;
    minimizer.dispose();
    return bending;
  };
  const before = energy();
  let yields = 0;
  await new Promise((resolve) => {
    warmUp(
      { Minimizer },
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
