// SPDX-License-Identifier: MIT
/**
 * @file The surface follows the slider of a weight while the hand still moves. Prints how soon, which depends on the
 * machine; asserts that each new weight leads to another surface, and that one undo takes the whole movement back.
 */
import { readFileSync } from 'node:fs';
import { expect, test } from '@jest/globals';
import { dropFile, evaluated, openAddress, measured, recordEvents, settled, status } from './page.js';
import { servedPage } from './served.js';

const served = servedPage();
const MOVES = 20;
/** A surface of genus 2 without symmetry. */
const text = readFileSync(new URL('../core/reference/g2.obj', import.meta.url), 'utf8');

test('follows the slider of a weight while it runs, and prints how soon', async () => {
  const { page, errors } = await openAddress(served.browser, `${served.url}studio.html`, {}, recordEvents);
  await measured(page);
  await dropFile(page, 'cage.obj', text);
  await page.locator('#cage').filter({ hasText: 'cage.obj' }).waitFor();
  await page.locator('[name=functional]').selectOption('blend');
  for (const name of ['last', 'first']) await page.locator(`[name=${name}]`).selectOption('2');
  await settled(page);
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  await evaluated(page, 3);

  const slider = page.locator('#weights [name=slide-mvs_cross]');
  const times = await slider.evaluate(async (element, moves) => {
    const input = /** @type {HTMLInputElement} */ (element);
    const events = /** @type {() => import('./page.js').PageEvent[]} */ (/** @type {any} */ (window).recordedEvents);
    /** @type {number[]} */
    const times = [];
    for (let i = 0; i < moves; i++) {
      const before = events().length;
      const start = performance.now();
      input.value = String(0.5 - 0.02 * (i + 1));
      input.dispatchEvent(new Event('input', { bubbles: true }));
      const follows = () => {
        const since = events()
          .slice(before)
          .map(({ name }) => name);
        return since.lastIndexOf('surfaced') > since.indexOf('retargeted') && since.includes('retargeted');
      };
      while (!follows()) {
        await new Promise((resolve) => {
          setTimeout(resolve, 1);
        });
      }
      times.push(performance.now() - start);
    }
    input.dispatchEvent(new Event('change', { bubbles: true }));
    return times;
  }, MOVES);
  const sorted = times.map(Math.round).sort((a, b) => a - b);
  console.log(
    `New geometry after a move of a weight: ${sorted[MOVES / 2]} ms (median of ${MOVES}), ${sorted.at(-1)} ms at most`,
  );

  const weight = page.locator('[name=weight-mvs_cross]');
  expect(await weight.inputValue()).toBe('0.1');
  await page.getByRole('button', { name: 'Cancel' }).click();
  await status(page, /^Stopped/);
  await page.locator('#undo').click();
  expect(await weight.inputValue()).toBe('0.5');
  await status(page, /^Minimizing/);
  expect(errors).toEqual([]);
  await page.context().close();
}, 120_000);
