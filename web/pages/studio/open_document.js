// SPDX-License-Identifier: MIT
/**
 * @file One document that is open: its state, and its worker, which it has only while it is on the screen or runs.
 */
import { createEffects } from './effects.js';
import { isBusy } from './state/kept.js';
import { withView } from './state/parts.js';
import { reduce } from './state/reduce.js';

/** @import {EntryName} from '../../address/compare.js' */
/** @import {Client, Loss} from '../../worker/client.js' */
/** @import {Message} from '../../worker/protocol.js' */
/** @import {Action, DownloadOptions, State} from './state/types.js' */

/**
 * @typedef {object} Surroundings
 * @property {(hear: Hear) => Client} connect starts a worker
 * @property {(name: string, content: string | ArrayBuffer, type: string) => void} save offers a file
 * @property {(state: State, options: DownloadOptions) => Promise<Action>} takePicture of the surface, and offers it as a file
 * @property {(name: EntryName) => Promise<Action>} load finds an entry of the catalog
 * @property {(search: string) => void} setAddress
 * @property {(before: State, after: State) => void} changed
 */

/** What is told of a worker. @typedef {{onMessage: (message: Message) => void, onLost: (loss: Loss, detail: string) => void}} Hear */

/** @typedef {ReturnType<typeof createOpenDocument>} OpenDocument */

/** A file, or what took its place, that could be read or not. @typedef {{name: string} & ({text: Uint8Array} | {refused: string})} OfferedFile */

/** A state that begins with a file. @param {State} begun @param {OfferedFile} file @returns {State} */
export const withFile = (begun, file) =>
  reduce(
    begun,
    'text' in file
      ? { type: 'fileChosen', name: file.name, text: file.text }
      : { type: 'fileRefused', name: file.name, message: file.refused },
  );

/**
 * @param {State} begun
 * @param {Surroundings} surroundings
 */
export function createOpenDocument(begun, { connect, save, takePicture, load, setAddress, changed }) {
  let state = begun;
  /** @type {Client | null} */
  let client = null;
  let behind = false;

  function awake() {
    if (client) return client;
    client = connect({
      onMessage: (message) => dispatch({ type: 'answered', message }),
      onLost: (loss, detail) => dispatch({ type: 'workerLost', loss, detail }),
    });
    if (behind) client.send({ type: 'stand', behind });
    return client;
  }

  /** @param {boolean} isBehind */
  function stand(isBehind) {
    if (isBehind === behind) return;
    behind = isBehind;
    client?.send({ type: 'stand', behind });
  }
  const effects = createEffects({
    client: {
      send: (command) => awake().send(command),
      abandon: () => awake().abandon(),
      restart: () => awake().restart(),
    },
    save,
    takePicture: async (shown, options) => dispatch(await takePicture(shown, options)),
    load: async (name) => dispatch(await load(name)),
    setAddress,
  });

  /** @param {Action} action */
  function dispatch(action) {
    const before = state;
    state = reduce(before, action);
    effects(action, before, state);
    changed(before, state);
  }

  return {
    get state() {
      return state;
    },
    dispatch,

    /** Does what the state that it began with asks for. */
    begin() {
      awake(); // the core loads while the catalog does
      effects(null, null, state);
    },

    /** Brings the surface back if there is no worker that has it. @param {boolean} [isBehind] whether another document is on the screen */
    wake(isBehind = false) {
      stand(isBehind);
      if (!client) dispatch({ type: 'wakened' });
    },

    /**
     * Another document is on the screen: ends the worker, unless that has something to do; the surface will be brought back.
     * @returns {boolean} whether it sleeps
     */
    sleep() {
      if (isBusy(state)) {
        stand(true);
        return false;
      }
      client?.dispose();
      client = null;
      state = withView(state, { surface: null, start: null });
      return true;
    },

    /** Ends the worker in any case. */
    dispose() {
      client?.dispose();
      client = null;
    },
  };
}
