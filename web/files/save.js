// SPDX-License-Identifier: MIT
/**
 * @file Hands a text to the browser as a file to save.
 */

/**
 * @param {string} name
 * @param {string} text
 * @param {string} type MIME
 */
export function saveText(name, text, type) {
  const url = URL.createObjectURL(new Blob([text], { type }));
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  // The browser reads the object after this task.
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
