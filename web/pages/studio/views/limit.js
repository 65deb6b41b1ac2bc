// SPDX-License-Identifier: MIT
/**
 * @file Beside the levels: their limit with its error bar, or why there is none, and the error of the integration.
 */
import { errorsOf } from '../state/select.js';
import { compact } from '../../../words/numbers.js';
import { limitWords } from '../../../words/results.js';
import { element, whenChanged } from '../../../views/dom.js';
import { termButton } from '../../../views/glossary.js';

/** @import {State} from '../state/types.js' */

/** @param {HTMLElement} root */
export function createLimitView(root) {
  const show = whenChanged(
    (
      /** @type {ReturnType<typeof errorsOf>['limit']} */ limit,
      /** @type {ReturnType<typeof errorsOf>['integration']} */ integration,
    ) => {
      const lines = [];
      if (limit) {
        const { value, error, words } = limitWords(limit);
        const number = error ? `${value} ± ${error}` : value;
        lines.push(
          value
            ? [termButton('limit'), ' of the levels: ', element('strong', {}, number), `, ${words}.`]
            : [termButton('error-bar', 'No error bar'), `: ${words}.`],
        );
      }
      if (integration !== null)
        lines.push([
          `The last energy is `,
          termButton('integration', 'integrated'),
          ` to within ${compact(integration, 2)}.`,
        ]);
      root.replaceChildren(...lines.map((line) => element('p', { class: 'note' }, ...line)));
    },
  );
  return {
    /** @param {State} state */
    update(state) {
      const { limit, integration } = errorsOf(state);
      show(limit, integration);
    },
    dispose: () => root.replaceChildren(),
  };
}
