// SPDX-License-Identifier: MIT
/**
 * @file The README's picture of what holding is for: a fish's head that is faired and a five-sided hole that is filled, before and after,
 * under reflection stripes.
 */
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { dropFile, measured, minimized, openAddress, status } from '../../browser/page.js';
import { surfacePicture } from '../../browser/pictures.js';
import { root } from '../process.js';

/** @typedef {import('playwright-core').Browser} Browser */

/** The two samples as the README's commands minimize them, and from where they are seen. */
const examples = [
  {
    sample: 'fish.obj',
    camera: '70,25,0.4',
    enlarged: 2,
    change: { terms: { bending: 1 }, constraints: { hold: { groups: ['body'] }, closeness: { within: 0.05 } } },
    options: { levels: [1, 3] },
  },
  {
    sample: 'five-sided.obj',
    camera: '36,45,0.7',
    enlarged: 1.1,
    change: { terms: { mvs_cross: 1 }, fill: { loops: [1] } },
    options: { levels: [1, 2] },
  },
];

/** @param {Browser} browser @param {string} url @param {string} file */
export async function holdingPicture(browser, url, file) {
  /** @type {string[]} */
  const figures = [];
  for (const { sample, camera, enlarged, change, options } of examples) {
    const text = readFileSync(path.join(root, 'web/samples', sample), 'utf8');
    const problem = { umbilic: 'problem', version: 1, cage: { name: sample, text }, ...change, options };
    const address = `${url}studio.html?shading=stripes&camera=${camera}`;
    const { page } = await openAddress(browser, address, {
      colorScheme: 'light',
      viewport: { width: 1240, height: 700 },
      deviceScaleFactor: 2,
      bypassCSP: true, // pictures are taken with a style of their own
    });
    await measured(page);
    await dropFile(page, `${sample}.json`, JSON.stringify(problem));
    await page.locator('.facts').filter({ hasText: sample }).waitFor();
    await measured(page);
    const shoot = async (/** @type {string} */ caption) => {
      const picture = await surfacePicture(page);
      figures.push(
        `<figure><div><img style="scale:${enlarged}" src="data:image/png;base64,${picture}"></div><figcaption>${caption}</figcaption></figure>`,
      );
    };
    await shoot('before');
    await page.locator('#primary').click();
    await status(page, minimized, 600_000);
    await shoot('after');
    await page.context().close();
  }
  const sheet = await browser.newPage();
  await sheet.setContent(
    `<style>body{margin:0}main{display:grid;grid-template-columns:1fr 1fr;gap:8px;background:#fff;color:#222;font:18px system-ui;width:1000px}
    figure{margin:0;text-align:center}div{overflow:hidden}img{display:block;width:496px;height:360px;object-fit:cover}</style><main>${figures.join('')}</main>`,
  );
  await sheet.locator('main').screenshot({ path: file });
  await sheet.close();
}
