// SPDX-License-Identifier: MIT
/**
 * @file The catalog's explanations: what is minimized, what each status means, and how to cite the catalog.
 */
import { statuses } from '../../../address/catalog.js';
import { element, find, setText, whenChanged } from '../../../views/dom.js';
import { capitalized, citation, columnWords, statusWords } from '../../../words/entries.js';

/** @import {Catalog} from '../../../files/catalog.js' */
/** @import {State} from '../types.js' */

/** @param {HTMLElement} root */
export function createReadingView(root) {
  const columns = find(root, '#columns');
  const cite = find(root, '#cite');
  find(root, '#statuses').replaceChildren(
    ...statuses.flatMap((status) => {
      const { name, meaning } = statusWords[status];
      return [element('dt', {}, capitalized(name)), element('dd', {}, meaning)];
    }),
  );
  const fill = whenChanged((/** @type {Catalog} */ catalog) => {
    columns.replaceChildren(
      ...catalog.functionals.flatMap((functional) => {
        const { name, formula, taste } = columnWords(functional);
        return [
          element('dt', {}, name),
          element('dd', {}, element('span', { class: 'formula' }, formula), ` ${taste}`),
        ];
      }),
    );
    const { origin, pathname } = location;
    setText(cite, citation(catalog.version, `${origin}${pathname.replace(/index\.html$/, '')}`));
  });
  return {
    /** @param {State} state */
    update: ({ catalog }) => catalog && fill(catalog),
    dispose: () => columns.replaceChildren(),
  };
}
