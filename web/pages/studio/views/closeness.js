// SPDX-License-Identifier: MIT
/**
 * @file How near the surface stays to the cage's own: a largest distance, or the weight of what pulls it back. Either field
 * replaces the other.
 */
import { problemOfCloseness } from '../state/hold.js';
import { closenessWords } from '../../../words/holding.js';
import { find, setText, whenChanged } from '../../../views/dom.js';

/** @import {Constraints} from '../../../../wasm/types.js' */
/** @import {Action, OpenCage, State} from '../state/types.js' */

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createClosenessView(root, dispatch) {
  const listening = new AbortController();
  const words = find(root, '.note');
  const problem = find(root, '.problem');
  const fields = /** @type {const} */ (['within', 'weight']).map((name) => {
    const input = /** @type {HTMLInputElement} */ (find(root, `[name=${name}]`));
    input.addEventListener(
      'change',
      () => {
        const value = input.value.trim() ? Number(input.value) : null;
        const closeness = name === 'within' ? { within: value ?? NaN } : { weight: value ?? NaN };
        dispatch({ type: 'closenessChanged', closeness: value === null ? null : closeness });
      },
      { signal: listening.signal },
    );
    return { name, input };
  });

  const show = whenChanged((/** @type {Constraints} */ { closeness }, /** @type {OpenCage | null} */ cage) => {
    for (const { name, input } of fields) {
      const value = /** @type {Partial<Record<string, number>>} */ (closeness ?? {})[name];
      // What cannot be read stays as it was typed, for its writer to mend.
      if (value === undefined) input.value = '';
      else if (!Number.isNaN(value)) input.value = String(value);
    }
    setText(words, closenessWords(closeness, cage?.source.kind === 'text'));
  });

  return {
    /** @param {State} state */
    update({ document: { settings, cage }, session: { refused } }) {
      show(settings.constraints, cage);
      const refusal = refused?.place === 'closeness' ? refused.message : '';
      setText(problem, problemOfCloseness(settings.constraints) ?? refusal);
    },
    dispose: () => listening.abort(),
  };
}
