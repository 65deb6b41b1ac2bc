// SPDX-License-Identifier: MIT
/**
 * @file What is said in the place of the surface while it cannot be drawn, although the browser could.
 */
import { element, find } from '../../../views/dom.js';

const sentences = {
  lost: 'The graphics card has taken the picture back. It appears again as soon as the browser may draw; runs go on.',
  unloaded: 'The part of this page that draws was not loaded. Everything else works, and your documents are kept.',
};

/** @param {HTMLElement} root */
export function createUndrawnView(root) {
  const words = find(root, '.undrawn');
  return {
    /** @param {keyof typeof sentences | null} why null if it is drawn */
    tell(why) {
      if (!why) return words.replaceChildren();
      const again = element('button', { type: 'button' }, 'Load the page again');
      again.addEventListener('click', () => location.reload());
      words.replaceChildren(element('span', {}, sentences[why]), ...(why === 'unloaded' ? [again] : []));
    },
  };
}
