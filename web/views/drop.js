// SPDX-License-Identifier: MIT
/**
 * @file Files that are dropped anywhere on the page, or chosen: the first one is read and handed on.
 */

/** @import {Action} from '../state/types.js' */

/** A cage with so many bytes has more faces than can be minimized. */
export const MAX_BYTES = 64 * 1024 * 1024;

/**
 * @param {(action: Action) => void} dispatch
 * @returns {(files: File[]) => Promise<void>}
 */
export function createFileTaker(dispatch) {
  return async ([file]) => {
    if (!file) return;
    const { name } = file;
    if (file.size > MAX_BYTES) {
      dispatch({ type: 'fileRefused', name, message: 'The file is larger than 64 MB.' });
      return;
    }
    try {
      dispatch({ type: 'fileChosen', name, text: new Uint8Array(await file.arrayBuffer()) });
    } catch (error) {
      // A folder, or a file that went away.
      const message = error instanceof Error ? error.message : String(error);
      dispatch({ type: 'fileRefused', name, message: `It cannot be read: ${message}` });
    }
  };
}

/**
 * @param {HTMLElement} veil shown while files are over the page
 * @param {(files: File[]) => void} takeFiles
 */
export function createDropView(veil, takeFiles) {
  const listening = new AbortController();
  const options = { signal: listening.signal };
  /** Leaving an element for its child is no leaving: `dragenter` comes first. */
  let depth = 0;
  /** @param {DragEvent} event */
  const hasFiles = (event) => Boolean(event.dataTransfer?.types.includes('Files'));
  /** @param {number} change */
  const move = (change) => {
    depth = Math.max(0, depth + change);
    veil.hidden = depth === 0;
  };
  window.addEventListener('dragenter', (event) => hasFiles(event) && move(1), options);
  window.addEventListener('dragleave', (event) => hasFiles(event) && move(-1), options);
  window.addEventListener(
    'dragover',
    (event) => {
      if (!hasFiles(event)) return;
      event.preventDefault();
      if (event.dataTransfer) event.dataTransfer.dropEffect = 'copy';
    },
    options,
  );
  window.addEventListener(
    'drop',
    (event) => {
      if (!hasFiles(event)) return;
      event.preventDefault();
      move(-depth);
      takeFiles([...(event.dataTransfer?.files ?? [])]);
    },
    options,
  );
  return { dispose: () => listening.abort() };
}
