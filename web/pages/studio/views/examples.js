// SPDX-License-Identifier: MIT
/**
 * @file What the chosen functional prefers: a sentence, and the catalog's pictures of a few of its minimizers, each a link to
 * its entry.
 */
import { entryLink } from '../../../address/links.js';
import { catalogAddress } from '../../../files/catalog.js';
import { blendWords, functionals } from '../../../words/functionals.js';
import { shapeTitle } from '../../../words/entries.js';
import { element, find, setText, whenChanged } from '../../../views/dom.js';

/** @import {Settings, State} from '../state/types.js' */

/** Frames whose minimizers differ most between functionals. */
export const SHAPES = ['two-3', 'tetrahedron-frame', 'cube-frame'];

/** @param {string} shape @param {string} functional of the catalog */
function example(shape, functional) {
  const src = catalogAddress(`pictures/${shape}.${functional}.webp`);
  const title = shapeTitle(shape);
  return element(
    'a',
    { href: entryLink({ shape, functional }), title: `${title}: its minimizer in the catalog` },
    element('img', { src, alt: title, width: '240', height: '180', loading: 'lazy', decoding: 'async' }),
  );
}

/** @param {HTMLElement} root */
export function createExamplesView(root) {
  const words = find(root, '#functional-words');
  const pictures = find(root, '#examples');
  const formula = find(root, '#formula');
  const show = whenChanged((/** @type {Settings['functional']} */ id) => {
    const chosen = functionals.find((functional) => functional.id === id);
    const { prefers, taste, pictured } = chosen ?? blendWords;
    setText(words, prefers);
    setText(find(root, '#formula-words'), taste);
    setText(formula, chosen?.formula ?? '');
    pictures.hidden = pictured === null;
    pictures.replaceChildren(...(pictured === null ? [] : SHAPES.map((shape) => example(shape, pictured))));
  });
  return {
    /** @param {State} state */
    update: ({ document }) => show(document.settings.functional),
    dispose: () => pictures.replaceChildren(),
  };
}
