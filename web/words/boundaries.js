// SPDX-License-Identifier: MIT
/**
 * @file The conditions at a boundary, in words.
 */

/** @import {BoundaryCondition} from '../../wasm/types.js' */

/** In the order in which each holds what the one before it holds, too. @type {Record<BoundaryCondition, {name: string, words: string}>} */
export const conditionWords = {
  free: { name: 'Free', words: 'Free: nothing is held at the boundary.' },
  position: { name: 'Position', words: 'Position: the boundary curve is held.' },
  tangent: { name: 'Tangent', words: 'Tangent: the boundary curve is held, and the slope across it.' },
  curvature: { name: 'Curvature', words: 'Curvature: curve, slope and curvature across it are held.' },
};
