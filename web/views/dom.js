// SPDX-License-Identifier: MIT
/**
 * @file The few things that every view does with the document.
 */

/**
 * The element that the selector names; the page's own HTML has it.
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
  for (const [name, value] of Object.entries(attributes)) created.setAttribute(name, value);
  created.append(...children);
  return created;
}

/**
 * Changes nothing when the text is the same, so that screen readers stay calm.
 * @param {Element} target
 * @param {string} text
 */
export function setText(target, text) {
  if (target.textContent !== text) target.textContent = text;
}

/**
 * A button that is switched off stays in the tab order and keeps the focus; its presses do nothing.
 * @param {HTMLButtonElement} button
 * @param {boolean} enabled
 */
export function setEnabled(button, enabled) {
  button.setAttribute('aria-disabled', String(!enabled));
}

/**
 * Calls `press` for presses while the button is enabled.
 * @param {HTMLButtonElement} button
 * @param {() => void} press
 * @param {AbortSignal} signal
 */
export function onPress(button, press, signal) {
  button.addEventListener('click', () => button.getAttribute('aria-disabled') !== 'true' && press(), { signal });
}

/**
 * Remembers what it was last called with, and calls `work` only when one of them is another.
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
