// SPDX-License-Identifier: MIT
/**
 * @file The studio's side effects: commands to the worker, entries of the catalog to load, files to save, and the
 * page's address. They follow from the states before and after an action.
 */
import { formatStudioAddress } from './address/studio.js';
import { fileName } from './files/names.js';
import { addressOf } from './state/address.js';
import { problemOf } from './state/settings.js';

/** @import {EntryName} from './address/compare.js' */
/** @import {Action, State} from './state/types.js' */
/** @import {Client} from './worker/client.js' */

/**
 * Calls `work` only if the text differs from the last one.
 * @param {(text: string) => void} work
 * @returns {(text: string) => void}
 */
function onceEach(work) {
  /** @type {string | null} */
  let last = null;
  return (text) => {
    if (text === last) return;
    last = text;
    work(text);
  };
}

/**
 * @param {object} surroundings
 * @param {Pick<Client, 'send' | 'abandon'>} surroundings.client
 * @param {(name: string, text: string, type: string) => void} surroundings.save
 * @param {(name: EntryName) => void} surroundings.load finds an entry of the catalog; ends in `entryLoaded` or `entryMissing`
 * @param {(search: string) => void} surroundings.setAddress
 * @returns {(action: Action, before: State, after: State) => void}
 */
export function createEffects({ client, save, load, setAddress }) {
  const follow = onceEach(setAddress);

  /** @param {State} before @param {State} after */
  function open(before, after) {
    const { opening } = after;
    if (!opening) return;
    const isNew = opening.run !== before.opening?.run;
    const { run, source, settings, start, purpose, then } = opening;
    const goesOn = then !== 'hold' && { then };
    if (isNew) {
      const look = purpose === 'entry' && { look: true };
      const deviation = after.view.shading === 'deviation' && { deviation: true };
      client.send({ type: 'open', run, problem: problemOf(source, settings, start), ...look, ...goesOn, ...deviation });
    } else if (goesOn && then !== before.opening?.then) {
      client.send({ type: then === 'run' ? 'optimize' : 'step', run });
    }
  }

  return (action, before, after) => {
    open(before, after);
    follow(formatStudioAddress(addressOf(after)));
    if (after.wanted && after.wanted !== before.wanted) load(after.wanted);
    const { run } = after;
    switch (action.type) {
      case 'startPressed':
      case 'stepPressed':
        if (after.status === 'running' && before.status !== 'running') {
          client.send({ type: action.type === 'startPressed' ? 'optimize' : 'step', run });
        }
        break;
      case 'pausePressed':
        if (after.asked === 'pause' && before.asked !== 'pause') client.send({ type: 'pause', run });
        break;
      case 'cancelPressed':
        if (before.opening) client.abandon();
        else if (after.asked === 'cancel' && before.asked !== 'cancel') client.send({ type: 'cancel', run });
        break;
      case 'certifyPressed':
        if (after.certifying && !before.certifying) client.send({ type: 'certify', run });
        break;
      case 'certificateCancelPressed':
        if (after.certifying?.abandoning && !before.certifying?.abandoning) {
          client.send({ type: 'abandonCertificate', run });
        }
        break;
      case 'viewChanged': {
        const [was, on] = [before, after].map(({ view }) => view.shading === 'deviation');
        if (on !== was) client.send({ type: 'deviate', on });
        break;
      }
      case 'downloadPressed':
        client.send({ type: 'export', run, what: action.what });
        break;
      case 'surfaceDrawn':
        if (before.coarse) client.send({ type: 'detail', run });
        if (before.coarse && after.minimizer && after.cage?.source.kind === 'generated') {
          // The problem that the button "Minimize again" would open.
          const problem = problemOf(after.cage.source, after.minimizer.settings, null);
          if (typeof problem !== 'string') client.send({ type: 'expect', run, problem });
        }
        break;
      case 'answered':
        if (action.message.type === 'exported' && action.message.run === run) {
          const { what, text } = action.message;
          save(fileName(after, what), text, what === 'report' || what === 'problem' ? 'application/json' : 'model/obj');
        }
        break;
    }
  };
}
