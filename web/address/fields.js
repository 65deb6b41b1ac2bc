// SPDX-License-Identifier: MIT
/**
 * @file Addresses as lists of fields: what each field's text means, what holds where it is missing or means nothing, and
 * how it is written. Pure.
 */

/**
 * One parameter of an address.
 * @template T
 * @typedef {object} Field
 * @property {T} fallback where the address does not say
 * @property {(text: string) => T | undefined} read undefined for text that means nothing
 * @property {(value: T) => string} write
 * @property {string} expected what its text may be, for the notice
 * @property {boolean} [always] whether it is written where it is the fallback
 */

/** Most characters of a broken value that a notice repeats. */
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
 * @returns {{address: A, notices: string[]}} a sentence for each field that fell back because its text means nothing
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
 * The inverse of `parseAddress`: fields in their order, without those that say what holds anyway.
 * @template {Record<string, any>} A
 * @param {{[K in keyof A]: Field<A[K]>}} fields
 * @param {A} address
 * @returns {string} empty or from the question mark on
 */
export function formatAddress(fields, address) {
  const parts = Object.entries(fields).flatMap(([name, { write, fallback, always }]) => {
    const text = write(address[name]);
    return text === '' || (!always && text === write(fallback)) ? [] : [`${name}=${readable(text)}`];
  });
  return parts.length ? `?${parts.join('&')}` : '';
}

/** Commas and colons may stand in an address as they are. @param {string} text */
const readable = (text) => encodeURIComponent(text).replaceAll('%2C', ',').replaceAll('%3A', ':');

/**
 * One of some words.
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
 * A number from `low` to `high`.
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
