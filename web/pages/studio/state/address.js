// SPDX-License-Identifier: MIT
/**
 * @file Converts between the studio's address and its state. Pure.
 */
import { parseStudioAddress } from '../../../address/studio.js';
import { functionals } from '../../../words/functionals.js';
import { cornersOf } from './corners.js';
import { showsEntry } from './entry.js';
import { activeWeights, blendOf, defaultSettings } from './settings.js';

/** @import {EntryName} from '../../../address/compare.js' */
/** @import {StudioAddress} from '../../../address/studio.js' */
/** @import {Settings, State} from './types.js' */

/**
 * @param {StudioAddress} address
 * @param {Settings} settings defaults for what the address does not say
 * @returns {{settings: Settings, wanted: EntryName | null, notices: string[]}} `wanted` is the catalog entry to open
 */
export function whatIsAsked(address, settings) {
  const { shape, functional, start, weights, cap, symmetry, levels, accuracy } = address;
  if (functional && start === 'catalog') return { settings, wanted: { shape, functional }, notices: [] };
  /** @type {Settings} */
  const asked = { ...settings, cap, symmetry: symmetry === 'on', levels, accuracy: accuracy || null };
  if (functional === 'blend') {
    const none = Object.fromEntries(functionals.map(({ id }) => [id, 0]));
    const all = /** @type {Settings['weights']} */ ({ ...none, ...weights });
    const blend = Object.keys(weights).length ? blendOf(all, cornersOf(settings)) : null;
    return { settings: { ...asked, functional: 'blend', ...blend }, wanted: null, notices: [] };
  }
  const known = functionals.find(({ id }) => id === functional);
  if (known) return { settings: { ...asked, functional: known.id }, wanted: null, notices: [] };
  const notices = functional ? [`There is no functional “${functional}” to minimize.`] : [];
  return { settings: asked, wanted: null, notices };
}

/**
 * The address that opens what is on the screen. It cannot name a cage from a file, nor the sides and the rise of a polygon.
 * @param {State} state
 * @returns {StudioAddress}
 */
export function addressOf(state) {
  const { view, session, document } = state;
  const { wanted, opening } = session;
  const { minimizer, cage, generator, settings } = document;
  const { address: plain } = parseStudioAddress('');
  const looked = { ...plain, shading: view.shading, camera: view.camera };
  if (wanted) return { ...looked, ...wanted };
  const entry = opening?.entry ?? (showsEntry(state) ? minimizer?.entry : null);
  if (entry) return { ...looked, shape: entry.shape, functional: entry.functional };
  if (cage && (cage.source.kind === 'text' || cage.source.sides !== undefined)) return { ...looked, shape: '' };
  const { functional, cap, symmetry, levels, accuracy } = settings;
  const { name, family, thickness } = generator;
  /** @type {StudioAddress} */
  const asked = {
    ...looked,
    shape: name,
    family,
    thickness,
    cap,
    symmetry: symmetry ? 'on' : 'off',
    levels,
    accuracy: accuracy ?? 0,
  };
  if (functional === defaultSettings.functional) return asked;
  const weights = functional === 'blend' ? activeWeights(settings) : {};
  return { ...asked, functional, start: 'cage', weights };
}
