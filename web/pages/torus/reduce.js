// SPDX-License-Identifier: MIT
/**
 * @file The torus page's initial state and reducer. Pure.
 */
import { parseTorusAddress } from '../../address/torus.js';
import { reduceView } from '../view_state.js';
import { blendOf, ratios, weightsOf } from './family.js';

/** @import {TorusAddress} from '../../address/torus.js' */
/** @import {Theme} from '../../files/theme.js' */
/** @import {Action, Blend, State} from './types.js' */

/**
 * @param {Theme} [theme]
 * @param {{address: TorusAddress, notices: string[]}} [said]
 * @returns {State}
 */
export function initialState(theme = 'system', { address, notices } = parseTorusAddress('')) {
  const { weights, shading, camera } = address;
  return {
    blend: blendOf(weights),
    family: null,
    least: null,
    path: [],
    pointed: null,
    shading,
    camera,
    fits: 0,
    theme,
    notices,
  };
}

/** Choosing the functional that the other menu already has exchanges the two. @param {Blend} blend @param {Extract<Action, {type: 'functionalChosen'}>} action @returns {Blend} */
function withFunctional({ names, weights }, { index, name }) {
  if (names[1 - index] === name) return { names: [names[1], names[0]], weights: [weights[1], weights[0]] };
  return { names: index ? [names[0], name] : [name, names[1]], weights };
}

/** @param {Blend['names']} a @param {Blend['names']} b */
const same = (a, b) => a[0] === b[0] && a[1] === b[1];

/**
 * @param {State} state
 * @param {Action} action
 * @returns {State}
 */
export function reduce(state, action) {
  const { blend } = state;
  switch (action.type) {
    case 'familyComputed':
      return { ...state, family: action.family };
    case 'leastComputed':
      // While the slider moves, the previous result is better than none.
      return same(blend.names, action.blend.names) ? { ...state, least: action.least } : state;
    case 'pathComputed':
      return same(blend.names, action.names) ? { ...state, path: action.path } : state;
    case 'computationFailed':
      return state.notices.includes(action.message) ? state : { ...state, notices: [...state.notices, action.message] };
    case 'shareChosen':
      return { ...state, blend: { ...blend, weights: weightsOf(action.share) } };
    case 'weightsChosen':
      return { ...state, blend: { ...blend, weights: action.weights } };
    case 'functionalChosen':
      return { ...state, blend: withFunctional(blend, action), least: null, path: [] };
    case 'ratioPointed': {
      const { index } = action;
      return { ...state, pointed: index === null ? null : Math.min(ratios.length - 1, Math.max(0, index)) };
    }
    default:
      return reduceView(state, action);
  }
}
