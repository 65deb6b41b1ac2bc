// SPDX-License-Identifier: MIT
/**
 * @file Reads the files that the user drops on the page or chooses, and passes them on.
 */

/** Larger cage files are refused: they have more faces than can be minimized. */
export const MAX_BYTES = 64 * 1024 * 1024;

/** So many files are opened at once; each has a document of its own, with a worker. */
export const MOST_FILES = 12;

/** A file that has been read, or why it was not. @typedef {{name: string} & ({text: Uint8Array} | {refused: string})} Taken */

/** @param {File} file @returns {Promise<Taken>} */
async function read(file) {
  const { name } = file;
  if (file.size > MAX_BYTES) return { name, refused: 'The file is larger than 64 MB.' };
  try {
    return { name, text: new Uint8Array(await file.arrayBuffer()) };
  } catch (error) {
    // A folder, or a file that no longer exists.
    return { name, refused: `It cannot be read: ${error instanceof Error ? error.message : error}` };
  }
}

/**
 * @param {object} takers
 * @param {(name: string, text: Uint8Array) => void} takers.open opens the only file
 * @param {(name: string, text: Uint8Array) => void} takers.openBeside opens one of several, as a document of its own
 * @param {(name: string, message: string) => void} takers.refuse
 * @returns {(files: File[]) => Promise<void>}
 */
export function createFileTaker({ open, openBeside, refuse }) {
  return async (files) => {
    for (const file of files.slice(0, MOST_FILES)) {
      const taken = await read(file);
      if ('refused' in taken) refuse(taken.name, taken.refused);
      else if (files.length === 1) open(taken.name, taken.text);
      else openBeside(taken.name, taken.text);
    }
    const next = files[MOST_FILES];
    if (next) refuse(next.name, `At most ${MOST_FILES} files are opened at once.`);
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
