// SPDX-License-Identifier: MIT
/**
 * @file Changes of the parts of the studio's state, and fields that only some phases have. Pure.
 */

/** @import {Certifying, Document, Phase, Result, Session, Settings, State, View} from './types.js' */

/** @param {State} state @param {Partial<Document>} change @returns {State} */
export const withDocument = (state, change) => ({ ...state, document: { ...state.document, ...change } });

/** @param {State} state @param {Partial<Result>} change @returns {State} */
export const withResult = (state, change) => withDocument(state, { result: { ...state.document.result, ...change } });

/** @param {State} state @param {Partial<Settings>} change @returns {State} */
export const withSettings = (state, change) =>
  withDocument(state, { settings: { ...state.document.settings, ...change } });

/** @param {State} state @param {Partial<Session>} change @returns {State} */
export const withSession = (state, change) => ({ ...state, session: { ...state.session, ...change } });

/** @param {State} state @param {Partial<View>} change @returns {State} */
export const withView = (state, change) => ({ ...state, view: { ...state.view, ...change } });

/** The result of a run that has not begun. @param {Settings} settings @returns {Result} */
export const noResult = (settings) => ({
  settings,
  group: null,
  taken: null,
  held: null,
  catalogs: false,
  progress: null,
  stop: null,
  samples: [],
  levels: [],
  limit: null,
  first: null,
  latest: null,
  saved: null,
  start: null,
  certificate: null,
  constrained: null,
});

/** @type {Record<'resting' | 'running' | 'ended' | 'unavailable', Phase>} */
export const phases = {
  resting: { name: 'resting' },
  running: { name: 'running', asked: null },
  ended: { name: 'ended', certifying: null },
  unavailable: { name: 'unavailable' },
};

/** The command that the worker has not answered yet. @param {Phase} phase */
export const askedOf = (phase) => ('asked' in phase ? phase.asked : null);

/** The certificate that the worker computes. @param {Phase} phase @returns {Certifying | null} */
export const certifyingOf = (phase) => ('certifying' in phase ? phase.certifying : null);

/** The evaluations of the run on the screen. @param {State} state */
export const evaluationsOf = ({ document }) => document.result.samples.at(-1)?.evaluation ?? 0;
