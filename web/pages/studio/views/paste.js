// SPDX-License-Identifier: MIT
/**
 * @file What is pasted outside of text fields: files are taken as if they were dropped, and a text as if it were a file.
 */
import { takesText } from '../../../views/dom.js';

/** The name of the file that a text would be, which tells the formats apart as the core does. @param {string} text */
export function nameOfPasted(text) {
  if (/^\s*\{/.test(text)) return 'pasted.json';
  if (/^ply[ \t]*[\r\n]/.test(text)) return 'pasted.ply';
  return /^(\s*#.*\n)*\s*(ST)?C?N?4?n?OFF\b/.test(text) ? 'pasted.off' : 'pasted.obj';
}

/** @param {(files: File[]) => void} takeFiles */
export function createPasteView(takeFiles) {
  const listening = new AbortController();
  document.addEventListener(
    'paste',
    (event) => {
      const { clipboardData, target } = event;
      if (!clipboardData || takesText(target)) return;
      const text = clipboardData.getData('text/plain');
      const files =
        clipboardData.files.length || !text.trim() ? [...clipboardData.files] : [new File([text], nameOfPasted(text))];
      if (!files.length) return;
      event.preventDefault();
      takeFiles(files);
    },
    { signal: listening.signal },
  );
  return { dispose: () => listening.abort() };
}
