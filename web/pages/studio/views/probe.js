// SPDX-License-Identifier: MIT
/**
 * @file The values of the surface under the pointer, or at the middle of the picture when they are asked for by key. They are
 * read at most once in each frame.
 */
import { element, find, setText } from '../../../views/dom.js';
import { readingWords } from '../../../words/reading.js';

/** @import {Computed} from '../../../colour/quantities.js' */
/** @import {Reading} from '../../../scene/reading.js' */

/** The middle of the picture. @type {[number, number]} */
const MIDDLE = [0.5, 0.5];

/**
 * @param {HTMLElement} root
 * @param {HTMLCanvasElement} canvas
 * @param {object} surroundings
 * @param {(x: number, y: number) => Reading | null} surroundings.read at a fraction of the canvas
 * @param {() => Computed | null} surroundings.computed what is computed at each point
 * @param {(reading: Reading | null) => void} surroundings.pointed
 */
export function createProbe(root, canvas, { read, computed, pointed }) {
  const listening = new AbortController();
  const { signal } = listening;
  const line = find(root, '#reading');
  const [curvatures, place] = [element('span'), element('span')];
  line.append(curvatures, ' ', place);
  const cross = find(root, '.cross');
  /** Where the pointer is, as a fraction of the canvas. @type {[number, number] | null} */
  let pointer = null;
  /** Whether the middle is read while the pointer is elsewhere. */
  let middle = false;
  let frame = 0;

  function tell() {
    frame = 0;
    const at = pointer ?? (middle ? MIDDLE : null);
    const reading = at && read(...at);
    // Who asks by key is told; what the pointer passes is not read out.
    line.setAttribute('aria-live', middle && !pointer ? 'polite' : 'off');
    line.hidden = !reading && !(middle && !pointer);
    const words = reading
      ? readingWords(reading, computed())
      : { curvatures: 'There is no surface in the middle.', place: '' };
    setText(curvatures, words.curvatures);
    setText(place, words.place);
    cross.hidden = !middle || pointer !== null;
    pointed(reading);
  }

  function request() {
    frame ||= requestAnimationFrame(tell);
  }

  /** @param {[number, number] | null} next */
  function move(next) {
    if (!next && !pointer) return;
    pointer = next;
    request();
  }

  canvas.addEventListener(
    'pointermove',
    ({ clientX, clientY, buttons, pointerType }) => {
      if (buttons || pointerType === 'touch') return move(null);
      const { left, top, width, height } = canvas.getBoundingClientRect();
      move([(clientX - left) / width, (clientY - top) / height]);
    },
    { signal },
  );
  canvas.addEventListener('pointerleave', () => move(null), { signal });

  return {
    /** Begins or ends to tell of the middle of the picture. */
    toggle() {
      middle = !middle;
      request();
    },

    /** To be called when the surface or the camera has moved. */
    refresh() {
      if (pointer || middle) request();
    },

    dispose() {
      listening.abort();
      cancelAnimationFrame(frame);
    },
  };
}
