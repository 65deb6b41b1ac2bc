// SPDX-License-Identifier: MIT
/**
 * @file Keys for the camera of a picture: arrows turn it, plus and minus zoom, F fits the surface.
 */

const TURN = Math.PI / 24;
const ZOOM = 0.85;

/**
 * The methods of OrbitControls that the keys use.
 * @typedef {Record<'rotateLeft' | 'rotateUp' | 'dollyIn' | 'dollyOut', (amount: number) => void>} Controls
 */

/**
 * @param {HTMLElement} element receives the keys while it has the focus
 * @param {Controls | undefined} controls
 * @param {() => void} fit
 * @param {AbortSignal} signal
 * @param {Record<string, () => void>} [more] other keys, and what they do
 */
export function listenToKeys(element, controls, fit, signal, more = {}) {
  /** @type {Record<string, () => void>} */
  const keys = {
    ArrowLeft: () => controls?.rotateLeft(TURN),
    ArrowRight: () => controls?.rotateLeft(-TURN),
    ArrowUp: () => controls?.rotateUp(TURN),
    ArrowDown: () => controls?.rotateUp(-TURN),
    '+': () => controls?.dollyIn(ZOOM),
    '=': () => controls?.dollyIn(ZOOM),
    '-': () => controls?.dollyOut(ZOOM),
    f: fit,
    ...more,
  };
  element.addEventListener(
    'keydown',
    (event) => {
      const work = keys[event.key];
      if (!work || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      work();
    },
    { signal },
  );
}
