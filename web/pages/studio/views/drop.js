// SPDX-License-Identifier: MIT
/**
 * @file Reads the first of the files that the user drops on the page or chooses, and dispatches it.
 */

/** @import {Action} from '../state/types.js' */

/** Larger cage files are refused: they have more faces than can be minimized. */
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
      // A folder, or a file that no longer exists.
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
  /**
   * How many nested elements the pointer is in. Entering a child leaves its parent, but `dragenter` of the child comes
   * first, so the depth stays positive.
   */
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
