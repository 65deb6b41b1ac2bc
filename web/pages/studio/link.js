// SPDX-License-Identifier: MIT
/**
 * @file The link to a document. What has a name, a generated cage or an entry of the catalog, is named by the address; any
 * other problem is in the link itself, in the part of the address that stays in the browser: `studio.html#p=…`.
 */
import { formatStudioAddress, parseStudioAddress } from '../../address/studio.js';
import { packed, unpacked } from '../../files/packed.js';
import { fileSize } from '../../words/numbers.js';
import { addressOf, whatIsAsked } from './state/address.js';
import { defaultSettings, problemOf } from './state/settings.js';

/** @import {Document, State} from './state/types.js' */

/** The longest link, in letters: programs that pass on messages cut off longer ones. */
export const LONGEST_LINK = 16_384;

const BEGINNING = '#p=';

/** What is asked of the document, as the core reads it. @param {Pick<Document, 'cage' | 'settings'>} document @returns {string} */
export function problemText({ cage, settings }) {
  if (!cage) throw new Error('no cage is open');
  const problem = problemOf(cage.source, settings, null);
  if (typeof problem === 'string') return problem;
  const { text } = /** @type {{text?: string | Uint8Array}} */ (problem.cage);
  const decoded = text instanceof Uint8Array ? new TextDecoder().decode(text) : text;
  const own = decoded === undefined ? problem.cage : { ...problem.cage, text: decoded };
  return JSON.stringify({ umbilic: 'problem', version: 1, ...problem, cage: own });
}

/** Whether who follows the document's address is asked the same. @param {State} state @param {string} search */
function addressSaysAll({ document: { cage, settings } }, search) {
  if (!cage) return true;
  const { address } = parseStudioAddress(search);
  const { settings: asked, wanted } = whatIsAsked(address, defaultSettings);
  if (wanted) return true;
  if (cage.source.kind === 'text') return false;
  const { shape, family, thickness } = address;
  const source = /** @type {const} */ ({ kind: 'generated', name: shape, family, thickness });
  return problemText({ cage: { ...cage, source }, settings: asked }) === problemText({ cage, settings });
}

/**
 * @param {State} state
 * @returns {Promise<{link: string} | {refused: string}>} the address from its question mark on, or why there is none
 */
export async function linkOf(state) {
  const address = formatStudioAddress(addressOf(state));
  if (addressSaysAll(state, address)) return { link: address };
  const { shading, camera } = state.view;
  const search = formatStudioAddress({ ...parseStudioAddress('').address, shape: '', shading, camera });
  const link = `${search}${BEGINNING}${await packed(problemText(state.document))}`;
  if (link.length <= LONGEST_LINK) return { link };
  const sizes = `${fileSize(link.length)} long; no more than ${fileSize(LONGEST_LINK)} can be passed on`;
  return { refused: `A link that holds this cage would be ${sizes}. Save the project as a file instead.` };
}

/**
 * The problem that an address holds.
 * @param {string} hash the address from its # on
 * @returns {Promise<{name: string, text: Uint8Array} | {name: string, refused: string} | null>} null if it holds none
 */
export async function problemIn(hash) {
  if (!hash.startsWith(BEGINNING)) return null;
  const name = 'The link';
  const text = await unpacked(hash.slice(BEGINNING.length));
  if (text === null) return { name, refused: 'It is not whole: a part of it was cut off or changed.' };
  return { name, text: new TextEncoder().encode(text) };
}
