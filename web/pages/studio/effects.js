// SPDX-License-Identifier: MIT
/**
 * @file The studio's side effects: commands to the worker, entries of the catalog to load, files to save, and the
 * page's address. They follow from the states before and after an action.
 */
import { formatStudioAddress } from '../../address/studio.js';
import { fileName, typeOf } from './names.js';
import { historyCsv } from './history_csv.js';
import { needsCage } from './state/editing.js';
import { addressOf } from './state/address.js';
import { wantsSearch } from './state/crossing.js';
import { askedOf, certifyingOf } from './state/parts.js';
import { problemOf } from './state/settings.js';
import { sameWish, wishOf } from './state/wish.js';

/** @import {EntryName} from '../../address/compare.js' */
/** @import {Action, DownloadOptions, State} from './state/types.js' */
/** @import {Client} from '../../worker/client.js' */

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

/** Whether a run has been asked for. @param {State | null} before @param {State} after */
const opensAnother = (before, { session: { opening } }) =>
  opening !== null && opening.run !== before?.session.opening?.run;

/**
 * @param {object} surroundings
 * @param {Pick<Client, 'send' | 'abandon' | 'restart'>} surroundings.client
 * @param {(name: string, content: string | ArrayBuffer, type: string) => void} surroundings.save
 * @param {(state: State, options: DownloadOptions) => void} surroundings.takePicture saves a picture of the surface; ends in
 *   `pictureTaken`
 * @param {(name: EntryName) => void} surroundings.load finds an entry of the catalog; ends in `entryLoaded` or `entryMissing`
 * @param {(search: string) => void} surroundings.setAddress
 * @returns {(action: Action | null, before: State | null, after: State) => void} both null as the page begins
 */
export function createEffects({ client, save, takePicture, load, setAddress }) {
  const follow = onceEach(setAddress);

  /** @param {State | null} before @param {State} after */
  function open(before, after) {
    const { opening } = after.session;
    if (!opening) return;
    const isNew = opensAnother(before, after);
    const { run, source, settings, start, purpose, then } = opening;
    const goesOn = then !== 'hold' && { then };
    if (isNew) {
      const look = purpose === 'entry' && { look: true };
      const wish = wishOf(after);
      client.send({
        type: 'open',
        run,
        problem: problemOf(source, settings, start),
        ...look,
        ...goesOn,
        ...(wish && { wish }),
      });
    } else if (goesOn && then !== before?.session.opening?.then) {
      client.send({ type: then === 'run' ? 'optimize' : 'step', run });
    }
  }

  /** @param {State} state @param {Extract<Action, {type: 'downloadPressed'}>} action */
  function download(state, { what, options = {} }) {
    if (what === 'picture') takePicture(state, options);
    else if (what === 'history') save(fileName(state, what), historyCsv(state.document.result.samples), typeOf(what));
    else client.send({ type: 'export', run: state.session.run, what, options });
  }

  /** The run whose start was asked for. */
  let recalled = -1;
  /** Asks once where a run began, when that is to be shown. @param {State} after */
  function recall({ session: { run, opening }, view: { original, before, surface } }) {
    if (!(original || before) || !surface || opening || recalled === run) return;
    recalled = run;
    client.send({ type: 'recall', run });
  }

  /** The surface that is searched or has been. @type {State['view']['surface']} */
  let searched = null;
  /** Asks once for each surface where it crosses itself, when that is to be known. @param {State} after */
  function search(after) {
    if (!wantsSearch(after) || searched === after.view.surface) return;
    searched = after.view.surface;
    client.send({ type: 'search', run: after.session.run });
  }

  /** The run whose cage was asked for. */
  let told = -1;
  /** Asks once for the cage, when it is to be edited. @param {State} after */
  function tellCage(after) {
    const { run } = after.session;
    if (!needsCage(after) || told === run) return;
    told = run;
    client.send({ type: 'tellCage', run });
  }

  return (action, before, after) => {
    const tried = action?.type === 'retryPressed';
    if (tried && before?.session.phase.name === 'unavailable') client.restart();
    open(before, after);
    recall(after);
    search(after);
    tellCage(after);
    follow(formatStudioAddress(addressOf(after)));
    const { run, wanted } = after.session;
    if (wanted && (tried || wanted !== before?.session.wanted)) load(wanted);
    if (!action || !before) return;
    if (!opensAnother(before, after) && !sameWish(wishOf(before), wishOf(after))) {
      client.send({ type: 'compute', wish: wishOf(after) });
    }
    const { targets } = after.session;
    if (targets && targets !== before.session.targets) client.send({ type: 'retarget', run, targets });
    const [was, is] = [before.session.phase, after.session.phase];
    switch (action.type) {
      case 'startPressed':
      case 'stepPressed':
        if (is.name === 'running' && was.name !== 'running') {
          client.send({ type: action.type === 'startPressed' ? 'optimize' : 'step', run });
        }
        break;
      case 'pausePressed':
        if (askedOf(is) === 'pause' && askedOf(was) !== 'pause') client.send({ type: 'pause', run });
        break;
      case 'cancelPressed':
        if (before.session.opening) client.abandon();
        else if (askedOf(is) === 'cancel' && askedOf(was) !== 'cancel') client.send({ type: 'cancel', run });
        break;
      case 'certifyPressed':
        if (certifyingOf(is) && !certifyingOf(was)) client.send({ type: 'certify', run });
        break;
      case 'descendPressed':
        if (certifyingOf(is) && !certifyingOf(was)) client.send({ type: 'descend', run });
        break;
      case 'certificateCancelPressed':
        if (certifyingOf(is)?.abandoning && !certifyingOf(was)?.abandoning) {
          client.send({ type: 'abandonCertificate', run });
        }
        break;
      case 'downloadPressed':
        download(after, action);
        break;
      case 'surfaceDrawn':
        if (before.view.coarse) client.send({ type: 'detail', run });
        if (before.view.coarse && after.document.minimizer && after.document.cage?.source.kind === 'generated') {
          // The problem that the button "Minimize again" would open.
          const problem = problemOf(after.document.cage.source, after.document.minimizer.settings, null);
          if (typeof problem !== 'string') client.send({ type: 'expect', run, problem });
        }
        break;
      case 'answered':
        if (action.message.type === 'exported' && action.message.run === run) {
          const { what, options, content } = action.message;
          save(fileName(after, what, options), content, typeOf(what));
        }
        break;
    }
  };
}
