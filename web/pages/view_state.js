// SPDX-License-Identifier: MIT
/**
 * @file The state that all pages with fixed surfaces share: how the surfaces are viewed, and notices to the reader.
 * Pure.
 */

/** @import {Camera} from '../address/camera.js' */
/** @import {Shading} from '../colour/quantities.js' */
/** @import {Theme} from '../files/theme.js' */

/**
 * @typedef {object} ViewState
 * @property {Shading} shading
 * @property {Camera} camera the common camera of all surfaces
 * @property {number} fits how often the user asked to fit the surfaces into the view
 * @property {Theme} theme
 * @property {string[]} notices sentences that the user has not dismissed
 */

/**
 * @typedef {{type: 'shadingChosen', shading: Shading}
 *   | {type: 'cameraMoved', camera: Camera}
 *   | {type: 'fitPressed'}
 *   | {type: 'themeChosen', theme: Theme}
 *   | {type: 'noticesDismissed'}} ViewAction
 */

/**
 * @template {ViewState} State
 * @param {State} state
 * @param {ViewAction} action
 * @returns {State}
 */
export function reduceView(state, action) {
  switch (action.type) {
    case 'shadingChosen':
      return { ...state, shading: action.shading };
    case 'cameraMoved':
      return { ...state, camera: action.camera };
    case 'fitPressed':
      return { ...state, fits: state.fits + 1 };
    case 'themeChosen':
      return { ...state, theme: action.theme };
    case 'noticesDismissed':
      return { ...state, notices: [] };
  }
}
