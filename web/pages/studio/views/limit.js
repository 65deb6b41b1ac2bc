// SPDX-License-Identifier: MIT
/**
 * @file The limit of the levels' energies with its error bar, or the reason why there is none.
 */
import { limitWords } from '../../../words/results.js';
import { element, whenChanged } from '../../../views/dom.js';

/** @import {Result, State} from '../state/types.js' */

/** @param {string} words */
const sentence = (words) => `${words[0].toUpperCase()}${words.slice(1)}.`;

/** @param {HTMLElement} root */
export function createLimitView(root) {
  const show = whenChanged(
    (
      /** @type {Result['limit']} */ limit,
      /** @type {Result['levels']} */ levels,
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
    update: ({ document: { result }, session: { phase } }) =>
      show(phase.name === 'running' ? null : result.limit, result.levels, result.settings.accuracy),
    dispose: () => root.replaceChildren(),
  };
}
