// SPDX-License-Identifier: MIT
/**
 * @file The comparison page's side effects: surfaces to load, and the page's address.
 */
import { entryName, formatCompareAddress } from '../../address/compare.js';
import { spreadCurvatures, withUnitArea } from './equal_area.js';
import { entryOf } from './reduce.js';

/** @import {EntryName} from '../../address/compare.js' */
/** @import {Report} from '../../../wasm/types.js' */
/** @import {MakeSurface} from '../../worker/surfaces.js' */
/** @import {Action, Shown, State} from './types.js' */

/** About the largest number of quads of all surfaces together, since they turn together. */
const QUADS = 160_000;

/**
 * @param {object} surroundings
 * @param {(action: Action) => void} surroundings.dispatch
 * @param {(name: string) => Promise<Report>} surroundings.loadReport
 * @param {MakeSurface} surroundings.makeSurface
 * @param {(search: string) => void} surroundings.setAddress
 * @returns {(after: State) => void}
 */
export function createEffects({ dispatch, loadReport, makeSurface, setAddress }) {
  /** @type {Set<string>} */
  const asked = new Set();
  let address = '';

  /** @param {State} state @param {EntryName} wanted @returns {Promise<Shown>} */
  async function surfaceOf({ catalog, entries }, wanted) {
    const entry = entryOf(catalog, wanted);
    if (!entry) return { problem: 'The catalog has no such entry.' };
    if (!entry.minimizer) return { problem: entry.reason ?? 'No minimizer was found.' };
    try {
      const report = await loadReport(entry.minimizer);
      const mesh = await makeSurface({ what: 'mesh', report, quads: QUADS / entries.length });
      if (typeof mesh === 'string' || mesh instanceof ArrayBuffer) return { problem: '' };
      const shown = withUnitArea(mesh);
      return { ...shown, spread: spreadCurvatures(shown) };
    } catch (error) {
      return { problem: error instanceof Error ? error.message : String(error) };
    }
  }

  /** @param {State} state @param {EntryName} wanted */
  async function load(state, wanted) {
    const name = entryName(wanted);
    if (name in state.surfaces || asked.has(name)) return;
    asked.add(name);
    const surface = await surfaceOf(state, wanted);
    asked.delete(name);
    dispatch({ type: 'surfaceLoaded', name, surface });
  }

  return (after) => {
    const { entries, shading, camera } = after;
    const next = formatCompareAddress({ entries, shading, camera });
    if (next !== address) setAddress((address = next));
    if (after.catalog) for (const entry of entries) load(after, entry);
  };
}
