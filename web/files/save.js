// SPDX-License-Identifier: MIT
/**
 * @file Offers a text or bytes to the user as a file to save.
 */

/**
 * @param {string} name
 * @param {string | ArrayBuffer} content
 * @param {string} type MIME
 */
export function saveFile(name, content, type) {
  const url = URL.createObjectURL(new Blob([content], { type }));
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  // The browser reads the object only after this task, so its address must stay valid for a while.
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
