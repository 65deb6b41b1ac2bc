// SPDX-License-Identifier: MIT
/**
 * @file The page of methods: its contents lead to its sections, it is as wide as the window, and it can be read without
 * JavaScript.
 */
import path from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { openAddress, screenshots } from './page.js';
import { servedPage } from './served.js';

const served = servedPage();
const address = () => `${served.url}methods.html`;

test('its contents list its sections in their order, and lead to each', async () => {
  const { page, errors } = await openAddress(served.browser, address());
  const links = page.locator('.contents a');
  const targets = await links.evaluateAll((all) => all.map((link) => link.getAttribute('href')));
  const sections = await page.locator('article > section').evaluateAll((all) => all.map(({ id }) => `#${id}`));
  expect(targets).toEqual(sections);
  expect(sections.length).toBeGreaterThanOrEqual(10);
  for (const id of ['#error', '#tables']) {
    await page.locator(`.contents a[href="${id}"]`).focus();
    await page.keyboard.press('Enter');
    await page.waitForFunction((selector) => {
      const { top = -1 } = document.querySelector(selector)?.getBoundingClientRect() ?? {};
      return top >= 0 && top < 200;
    }, id);
  }
  // Every link within the page leads somewhere.
  const dangling = await page
    .locator('a[href^="#"]')
    .evaluateAll((all) => all.filter((a) => !document.querySelector(a.getAttribute('href') ?? '')).length);
  expect(dangling).toBe(0);
  expect(errors).toEqual([]);
  await page.context().close();
});

describe.each([390, 1024, 1440])('in a window of %s pixels', (width) => {
  test('nothing but tables is wider than the page', async () => {
    const { page } = await openAddress(served.browser, address(), { viewport: { width, height: 900 } });
    const wider = await page.locator('body *').evaluateAll(
      (all, right) =>
        all
          .filter((element) => !element.closest('.scroll, .hidden'))
          .filter((element) => element.checkVisibility() && element.getBoundingClientRect().right > right)
          .map((element) => element.outerHTML.slice(0, 80)),
      width,
    );
    expect(wider).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
    // The navigation stays on one line.
    const lines = await page
      .locator('.top nav a')
      .evaluateAll((all) => new Set(all.map((link) => link.getBoundingClientRect().top)).size);
    expect(lines).toBe(1);
    await page.screenshot({ path: path.join(screenshots, `methods-${width}.png`) });
    await page.context().close();
  });
});

test('without JavaScript the text, the formulas and the tables are there', async () => {
  const { page } = await openAddress(served.browser, address(), { javaScriptEnabled: false });
  expect(await page.locator('article > section > h2').count()).toBeGreaterThanOrEqual(10);
  expect(await page.locator('math').count()).toBeGreaterThan(50);
  expect(await page.locator('#tables').innerText()).toMatch(/two-3\s+D3h\s+112\.7655 ± 0\.0019\s+113/);
  await page.context().close();
});
