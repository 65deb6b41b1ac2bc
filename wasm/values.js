// SPDX-License-Identifier: MIT
/**
 * @file What both sides of a worker know of the core's input and output, without the module itself: the error for bad
 * input, and how the core's JSON is read.
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
