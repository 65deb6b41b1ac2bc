// SPDX-License-Identifier: MIT
/**
 * @file What a row of the tables of hostile inputs is: an input, how the programs end with it, and a piece of what they say.
 */

/**
 * How a program ends: with energies that it stands for, with energies that it says are not the surface's, or with a refusal
 * of the input or of the command line.
 * @typedef {'minimized' | 'doubtful' | 'refused' | 'usage'} Outcome
 */

/**
 * `says` is part of the message of a refusal, or else of what the report says of the cage (`"genus":0`, a repair, a note).
 * @typedef {object} Expectation
 * @property {string} name
 * @property {Outcome} outcome
 * @property {string} says
 */

/** @typedef {string | Uint8Array} Content of a file */

/** @typedef {Expectation & {kind: 'cage', content: () => Content}} CageRow minimized for some steps */
/** @typedef {Expectation & {kind: 'problem', content: () => string}} ProblemRow */
/** @typedef {Expectation & {kind: 'command', args: string[], input: string}} CommandRow */
/** @typedef {CageRow | ProblemRow | CommandRow} Row */

/** The exit code of the command line. @type {Record<Outcome, number>} */
export const exitCodes = { minimized: 0, usage: 2, refused: 3, doubtful: 5 };

/** What every row must keep to; the seconds are those of the processor. */
export const limits = { seconds: 10, megabytes: 1024 };

/** What is done with a cage. @type {{ terms: { bending: number }, options: { levels: [number, number], max_iterations: number } }} */
export const stepsOfCage = { terms: { bending: 1 }, options: { levels: [0, 0], max_iterations: 3 } };

/** A value, or what makes it where it is long. @template T @typedef {T | (() => T)} Lazy */

/** @template T @param {Lazy<T>} value @returns {() => T} */
const lazily = (value) => (typeof value === 'function' ? /** @type {() => T} */ (value) : () => value);

/** @param {string} name @param {Lazy<Content>} content @param {Outcome} outcome @param {string} says @returns {CageRow} */
export const cage = (name, content, outcome, says) => ({
  kind: 'cage',
  name,
  content: lazily(content),
  outcome,
  says,
});

/** @param {string} name @param {Lazy<string>} content @param {Outcome} outcome @param {string} says @returns {ProblemRow} */
export const problem = (name, content, outcome, says) => ({
  kind: 'problem',
  name,
  content: lazily(content),
  outcome,
  says,
});

const MOST_OF_LINE = 120;

/**
 * @param {string} line of the command, with blanks between the arguments
 * @param {Outcome} outcome @param {string} says @param {string} [input] standard input
 * @returns {CommandRow}
 */
export const command = (line, outcome, says, input = '') => ({
  kind: 'command',
  name: line.length > MOST_OF_LINE ? `${line.slice(0, MOST_OF_LINE)}…` : line,
  args: line === '' ? [] : line.split(' '),
  input,
  outcome,
  says,
});
