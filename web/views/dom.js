// SPDX-License-Identifier: MIT
/**
 * @file Small functions for the document that all views use.
 */

/**
 * The element that the selector matches. It must exist in the page's HTML.
 * @template {Element} [T=HTMLElement]
 * @param {ParentNode} root
 * @param {string} selector
 * @returns {T}
 */
export function find(root, selector) {
  const element = root.querySelector(selector);
  if (!element) throw new Error(`the page has no ${selector}`);
  return /** @type {T} */ (element);
}

/**
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} tag
 * @param {Record<string, string>} [attributes]
 * @param {...(Node | string)} children
 * @returns {HTMLElementTagNameMap[K]}
 */
export function element(tag, attributes = {}, ...children) {
  const created = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    // The pages' security policy forbids to set the attribute, but not what it stands for.
    if (name === 'style') created.style.cssText = value;
    else created.setAttribute(name, value);
  }
  created.append(...children);
  return created;
}

/**
 * Sets the text only if it differs, so that screen readers do not repeat it.
 * @param {Element} target
 * @param {string} text
 */
export function setText(target, text) {
  if (target.textContent !== text) target.textContent = text;
}

/** Fields in which a user types, where keys and the clipboard are the browser's. */
const TYPED =
  'input:not([type]), input[type=text], input[type=number], input[type=search], textarea, [contenteditable]';

/** Whether keys that are pressed in it write text. @param {EventTarget | null} target */
export const takesText = (target) => target instanceof Element && target.matches(TYPED);

/**
 * Enables or disables a button. A disabled button stays in the tab order and keeps the focus, but ignores presses.
 * @param {HTMLButtonElement} button
 * @param {boolean} enabled
 */
export function setEnabled(button, enabled) {
  button.setAttribute('aria-disabled', String(!enabled));
}

/**
 * Calls `press` when an enabled button is pressed.
 * @param {HTMLButtonElement} button
 * @param {() => void} press
 * @param {AbortSignal} signal
 */
export function onPress(button, press, signal) {
  button.addEventListener('click', () => button.getAttribute('aria-disabled') !== 'true' && press(), { signal });
}

/**
 * Calls `work` only if some argument differs from the last call.
 * @template {unknown[]} T
 * @param {(...args: T) => void} work
 * @returns {(...args: T) => void}
 */
export function whenChanged(work) {
  /** @type {T | null} */
  let last = null;
  return (...args) => {
    if (last?.length === args.length && last.every((value, i) => Object.is(value, args[i]))) return;
    last = args;
    work(...args);
  };
}

/**
 * Shows short lines in an element, which stay as they are while their words do.
 * @param {HTMLElement} root
 * @returns {(lines: Array<{words: string, warning?: boolean}>) => void}
 */
export function createLines(root) {
  let shown = '';
  return (lines) => {
    const text = JSON.stringify(lines);
    if (text === shown) return;
    shown = text;
    root.replaceChildren(
      ...lines.map(({ words, warning }) => element('p', { class: warning ? 'problem' : 'note' }, words)),
    );
  };
}
