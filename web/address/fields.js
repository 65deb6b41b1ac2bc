// SPDX-License-Identifier: MIT
/**
 * @file Addresses as lists of fields. A field knows how to read its text, how to write its value, and what holds if its
 * text is missing or invalid. Pure.
 */

/**
 * One parameter of an address.
 * @template T
 * @typedef {object} Field
 * @property {T} fallback the value if the address does not contain the parameter
 * @property {(text: string) => T | undefined} read undefined for invalid text
 * @property {(value: T) => string} write
 * @property {string} expected describes valid text, for the notice
 * @property {boolean} [always] written even if it equals the fallback
 */

/** The longest part of an invalid value that a notice repeats, in characters. */
const QUOTED = 40;

/** @param {string} name @param {string} text @param {string} expected */
function notice(name, text, expected) {
  const quoted = text.length > QUOTED ? `${text.slice(0, QUOTED)} …` : text;
  return `“${name}=${quoted}” in the address is not understood; it may be ${expected}.`;
}

/**
 * @template {Record<string, any>} A
 * @param {{[K in keyof A]: Field<A[K]>}} fields
 * @param {string} search the address from its question mark on
 * @returns {{address: A, notices: string[]}} a sentence for each field whose text is invalid; it gets the fallback
 */
export function parseAddress(fields, search) {
  const parameters = new URLSearchParams(search);
  /** @type {string[]} */
  const notices = [];
  const entries = Object.entries(fields).map(([name, field]) => {
    const text = parameters.get(name);
    const value = text === null ? undefined : field.read(text);
    if (text !== null && value === undefined) notices.push(notice(name, text, field.expected));
    return [name, value ?? field.fallback];
  });
  return { address: Object.fromEntries(entries), notices };
}

/**
 * The inverse of `parseAddress`. Writes the fields in their order, leaving out those that equal their fallback.
 * @template {Record<string, any>} A
 * @param {{[K in keyof A]: Field<A[K]>}} fields
 * @param {A} address
 * @returns {string} empty, or the address from its question mark on
 */
export function formatAddress(fields, address) {
  const parts = Object.entries(fields).flatMap(([name, { write, fallback, always }]) => {
    const text = write(address[name]);
    return text === '' || (!always && text === write(fallback)) ? [] : [`${name}=${readable(text)}`];
  });
  return parts.length ? `?${parts.join('&')}` : '';
}

/** Encodes all but commas and colons, which are allowed in an address. @param {string} text */
const readable = (text) => encodeURIComponent(text).replaceAll('%2C', ',').replaceAll('%3A', ':');

/**
 * A field whose value is one of some words.
 * @template {string} T
 * @param {readonly T[]} words
 * @param {T} fallback
 * @returns {Field<T>}
 */
export function choice(words, fallback) {
  return {
    fallback,
    read: (text) => words.find((word) => word === text),
    write: (value) => value,
    expected: `${words.slice(0, -1).join(', ')} or ${words[words.length - 1]}`,
  };
}

/** A plain decimal number, as `String` writes it. @param {string} text */
export function numberIn(text) {
  return /^-?\d+(\.\d+)?(e[-+]?\d+)?$/.test(text) ? Number(text) : NaN;
}

/**
 * A field whose value is a number from `low` to `high`.
 * @param {number} fallback
 * @param {number} low
 * @param {number} high
 * @returns {Field<number>}
 */
export function number(fallback, low, high) {
  return {
    fallback,
    read(text) {
      const value = numberIn(text);
      return value >= low && value <= high ? value : undefined;
    },
    write: String,
    expected: `a number from ${low} to ${high}`,
  };
}

/** @param {string} text */
export const isShape = (text) => /^[a-z0-9]+(-[a-z0-9]+)*$/.test(text);
/** @param {string} text */
export const isFunctional = (text) => /^[a-z0-9]+(_[a-z0-9]+)*$/.test(text);
