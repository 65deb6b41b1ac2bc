// SPDX-License-Identifier: MIT
/**
 * @file What both sides of a worker know of the core's input and output, without the module itself: the error for bad
 * input, how the core's JSON is read, and which files only the core can read.
 */

/** Something is wrong with the user's cage or problem; `message` names the place. */
export class InputError extends Error {
  name = 'InputError';
}

/**
 * Parses JSON text of the core, in which null always stands for a number that is not finite.
 * @param {string} text
 * @returns {any}
 */
export const parse = (text) => JSON.parse(text, (_, value) => (value === null ? NaN : value));

/** Whether a cage file may be bytes that are no text: of the formats only PLY has such. @param {Uint8Array} file */
export const mayBeBinary = (file) => new TextDecoder('latin1').decode(file.subarray(0, 3)) === 'ply';
