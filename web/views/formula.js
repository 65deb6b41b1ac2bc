// SPDX-License-Identifier: MIT
/**
 * @file A formula of text with subscripts and superscripts.
 */
import { element } from './dom.js';

/**
 * `A^{3/2} II_{ij}` as nodes.
 * @param {string} text
 * @returns {Array<Node | string>}
 */
export function formulaNodes(text) {
  const tags = /** @type {const} */ ({ _: 'sub', '^': 'sup' });
  return text.split(/([_^]\{[^}]*\})/).map((part) => {
    const raised = /^([_^])\{(.*)\}$/.exec(part);
    return raised ? element(tags[/** @type {'_' | '^'} */ (raised[1])], {}, raised[2]) : part;
  });
}
