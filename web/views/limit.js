// SPDX-License-Identifier: MIT
/**
 * @file The limit of the levels' energies with its error bar, or the reason why there is none.
 */
import { limitWords } from '../words/results.js';
import { element, whenChanged } from './dom.js';

/** @import {State} from '../state/types.js' */

/** @param {string} words */
const sentence = (words) => `${words[0].toUpperCase()}${words.slice(1)}.`;

/** @param {HTMLElement} root */
export function createLimitView(root) {
  const show = whenChanged(
    (
      /** @type {State['limit']} */ limit,
      /** @type {State['levels']} */ levels,
      /** @type {number | null} */ accuracy,
    ) => {
      root.hidden = !limit;
      if (!limit) return root.replaceChildren();
      const { value, error, words } = limitWords(limit, levels, accuracy);
      root.classList.toggle('note', !value);
      root.replaceChildren(
        ...(error ? ['Limit '] : []),
        ...(value ? [element('strong', {}, error ? `${value} ± ${error}` : value), ', '] : []),
        value ? words : sentence(words),
      );
    },
  );
  return {
    /** Shows nothing while a run goes on, because its limit is not final. @param {State} state */
    update: ({ status, limit, levels, runSettings }) =>
      show(status === 'running' ? null : limit, levels, runSettings.accuracy),
    dispose: () => root.replaceChildren(),
  };
}
