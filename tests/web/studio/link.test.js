// SPDX-License-Identifier: MIT
/**
 * @file Links to documents: they hold all that is asked, who follows one gets the same energies, and what is not whole is said.
 */
import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, test } from '@jest/globals';
import { load } from '../../../wasm/umbilic.js';
import { parseStudioAddress } from '../../../web/address/studio.js';
import { packed, unpacked } from '../../../web/files/packed.js';
import { LONGEST_LINK, linkOf, problemIn, problemText } from '../../../web/pages/studio/link.js';
import { withFile } from '../../../web/pages/studio/open_document.js';
import { isUntouched } from '../../../web/pages/studio/state/kept.js';
import { initialState } from '../../../web/pages/studio/state/reduce.js';
import { documentName } from '../../../web/pages/studio/state/select.js';
import { createStudio } from './real.js';

/** @typedef {import('../../../web/pages/studio/state/types.js').State} State */

beforeAll(() => load());

const fish = readFileSync(new URL('../../../web/samples/fish.obj', import.meta.url));

/** The link to a document. @param {State} state */
async function madeLink(state) {
  const made = await linkOf(state);
  return 'link' in made ? made.link : made.refused;
}

/** The studio after a link to it was followed. @param {string} link from the question mark on */
async function followed(link) {
  const { search, hash } = new URL(link, 'https://example.org/studio.html');
  const begun = initialState('system', parseStudioAddress(search));
  const problem = await problemIn(hash);
  const studio = createStudio('', problem ? withFile(begun, problem) : begun);
  studio.work();
  return studio;
}

/** The fish, of which a group and a point are held. */
function heldFish() {
  const studio = createStudio();
  studio.do(
    { type: 'fileChosen', name: 'fish.obj', text: fish },
    { type: 'groupHeld', name: 'body', held: true },
    { type: 'vertexPinned', vertex: 3 },
    { type: 'closenessChanged', closeness: { within: 0.05 } },
    { type: 'settingsChanged', change: { functional: 'blend', levels: [1, 1], tolerance: 1e-4, accuracy: null } },
    { type: 'weightsChanged', weights: { bending: 1 / 3 } },
    { type: 'viewChanged', change: { shading: 'gaussian' } },
  );
  return studio;
}

describe('a link to a cage from a file', () => {
  test('opens the same problem with the same energies, under its name, looked at in the same way', async () => {
    const { state } = heldFish();
    const link = await madeLink(state);
    expect(link).toMatch(/^\?shading=gaussian#p=[\w-]+$/);
    expect(link.length).toBeLessThan(4000);
    const { state: there } = await followed(link);
    expect(there.view.alert).toBeNull();
    expect(documentName(there)).toBe('fish.obj');
    expect(there.view.shading).toBe('gaussian');
    expect(there.document.settings).toMatchObject({
      functional: 'blend',
      weights: { bending: 1 / 3, mvs_cross: 0.5 },
      levels: [1, 1],
      tolerance: 1e-4,
      constraints: { closeness: { within: 0.05 }, pins: [{ vertex: 3 }] },
    });
    const [mine, theirs] = [state, there].map(({ document }) => document.result.latest?.energies);
    for (const name of /** @type {const} */ (['bending', 'willmore', 'mvs', 'mvs_cross', 'area'])) {
      expect(Math.abs(Number(theirs?.[name]) / Number(mine?.[name]) - 1)).toBeLessThan(1e-12);
    }
    // It can be passed on again.
    expect(await madeLink(there)).toMatch(/^\?shading=gaussian#p=/);
    // No address opens it again, so it is kept although nothing was done with it.
    expect(isUntouched(there)).toBe(false);
  });

  test('that is too long is refused with its length', async () => {
    const studio = createStudio();
    const random = Array.from({ length: 4000 }, (_, i) => `# ${Math.sin(i)}`).join('\n');
    studio.do({ type: 'fileChosen', name: 'long.obj', text: new TextEncoder().encode(`${fish}\n${random}`) });
    expect(studio.state.document.cage?.name).toBe('long.obj');
    const made = await linkOf(studio.state);
    expect(made).toEqual({
      refused: expect.stringMatching(/ 51\.4.kB long; no more than 16\.4.kB .* Save the project/),
    });
    const refused = withFile(studio.state, { name: 'The link', refused: 'why' });
    expect(refused.view.alert).toEqual({ title: 'The link was not opened', message: 'why' });
  });
});

describe('a link to a generated cage', () => {
  test('is its short address, until something is asked that an address cannot say', async () => {
    const studio = createStudio('?shape=two-3&functional=bending&start=cage&levels=0..1');
    studio.work();
    const short = '?shape=two-3&functional=bending&start=cage&levels=0..1';
    expect(await madeLink(studio.state)).toBe(short);
    studio.do({ type: 'settingsChanged', change: { tolerance: 1e-3 } });
    const link = await madeLink(studio.state);
    expect(link).toMatch(/^#p=/);
    expect(link.length).toBeLessThan(400);
    const { state } = await followed(link);
    expect(state.document.cage?.source).toMatchObject(studio.state.document.cage?.source ?? {});
    expect(state.document.settings).toEqual(studio.state.document.settings);
    studio.do({ type: 'settingsChanged', change: { tolerance: 1e-6 } });
    expect(await madeLink(studio.state)).toBe(short);
  });
});

describe('a link that is not whole', () => {
  test('is told by every letter that is missing or another', async () => {
    const letters = await packed(problemText(heldFish().state.document));
    expect(await unpacked(letters)).toContain('"fish.obj"');
    for (const broken of [
      letters.slice(0, -1),
      letters.slice(0, 100),
      letters.slice(1),
      `${letters}AAAA`,
      '',
      '%',
      'p',
    ]) {
      expect(await unpacked(broken)).toBeNull();
    }
    for (let i = 0; i < letters.length - 1; i += 97) {
      const other = letters[i] === 'A' ? 'Q' : 'A';
      expect(await unpacked(letters.slice(0, i) + other + letters.slice(i + 1))).toBeNull();
    }
  });

  test('opens the shape that the studio begins with, and says so in one sentence', async () => {
    const { state } = await followed(`#p=${'x'.repeat(50)}`);
    expect(state.document.cage?.name).toBe('two-3');
    expect(state.view.alert).toEqual({
      title: 'The link was not opened',
      message: 'It is not whole: a part of it was cut off or changed.',
    });
  });

  test('that holds no problem says what the core says', async () => {
    const { state } = await followed(`#p=${await packed('{"umbilic": "problem", "version": 1}')}`);
    expect(state.document.cage?.name).toBe('two-3');
    expect(state.view.alert).toMatchObject({
      title: 'The link was not opened',
      message: expect.stringMatching(/cage/),
    });
  });

  test('or no problem at all is left alone', async () => {
    expect(await problemIn('')).toBeNull();
    expect(await problemIn('#downloads')).toBeNull();
    expect(LONGEST_LINK).toBeLessThanOrEqual(16_384);
  });
});
