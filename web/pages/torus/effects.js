// SPDX-License-Identifier: MIT
/**
 * @file The torus page's side effects: requests to the core, and the page's address.
 */
import { formatTorusAddress } from '../../address/torus.js';
import { functionals } from '../../words/functionals.js';
import { namedWeights, ratios, shares } from './family.js';

/** @import {TorusMinimizer} from '../../../wasm/types.js' */
/** @import {Weights} from '../../address/weights.js' */
/** @import {TorusEnergies} from '../../worker/tori.js' */
/** @import {Action, Blend, Family, State} from './types.js' */

/**
 * @param {object} surroundings
 * @param {(action: Action) => void} surroundings.dispatch
 * @param {(ratios: number[]) => Promise<TorusEnergies[]>} surroundings.energiesOf
 * @param {(weights: Weights[]) => Promise<TorusMinimizer[]>} surroundings.minimizersOf
 * @param {(search: string) => void} surroundings.setAddress
 * @returns {(after: State) => void}
 */
export function createEffects({ dispatch, energiesOf, minimizersOf, setAddress }) {
  /** @type {State | null} */
  let before = null;
  let address = '';

  /** @param {() => Promise<void>} work */
  function attempt(work) {
    work().catch((/** @type {unknown} */ error) => {
      const message = error instanceof Error ? error.message : String(error);
      dispatch({ type: 'computationFailed', message: `The energies could not be computed: ${message}` });
    });
  }

  async function findFamily() {
    const names = functionals.map(({ id }) => id);
    const [energies, alone] = await Promise.all([
      energiesOf(ratios),
      minimizersOf(names.map((name) => ({ [name]: 1 }))),
    ]);
    const byName = Object.fromEntries(names.map((name, i) => [name, alone[i]]));
    dispatch({ type: 'familyComputed', family: { energies, alone: /** @type {Family['alone']} */ (byName) } });
  }

  /** @param {Blend} blend */
  async function findLeast(blend) {
    const [minimizer] = await minimizersOf([namedWeights(blend)]);
    const [energies] = minimizer.ratio > 0 ? await energiesOf([minimizer.ratio]) : [null];
    dispatch({ type: 'leastComputed', blend, least: { minimizer, energies } });
  }

  /** @param {Blend['names']} names */
  async function findPath(names) {
    const path = await minimizersOf(shares.map((share) => namedWeights({ names, weights: [1 - share, share] })));
    dispatch({ type: 'pathComputed', names, path });
  }

  return (after) => {
    const { blend, shading, camera } = after;
    const next = formatTorusAddress({ weights: namedWeights(blend), shading, camera });
    if (next !== address) setAddress((address = next));
    const last = before;
    before = after;
    if (!last) attempt(findFamily);
    if (blend !== last?.blend) attempt(() => findLeast(blend));
    if (blend.names !== last?.blend.names) attempt(() => findPath(blend.names));
  };
}
