// SPDX-License-Identifier: MIT
/**
 * @file Texts packed into the letters that an address may have: the text compressed (deflate, RFC 1951), after a checksum of that
 * of 4 bytes, in base64url.
 */

const CHECKSUM = 4;
/** A packed text that unpacks to more bytes than this is refused, whatever it says. */
const MOST_BYTES = 4e6;

/** FNV-1a, which tells bytes that were cut off or changed from those that were packed. @param {Uint8Array} bytes */
function checksum(bytes) {
  let hash = 0x811c9dc5;
  for (const byte of bytes) hash = Math.imul(hash ^ byte, 0x01000193) >>> 0;
  return hash;
}

/**
 * @param {Uint8Array<ArrayBuffer>} bytes
 * @param {CompressionStream | DecompressionStream} transform
 * @param {number} [most] bytes of the result
 * @returns {Promise<Uint8Array<ArrayBuffer>>}
 */
async function through(bytes, transform, most = Infinity) {
  const reader = new Blob([bytes]).stream().pipeThrough(transform).getReader();
  /** @type {Uint8Array<ArrayBuffer>[]} */
  const parts = [];
  let length = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    parts.push(value);
    length += value.length;
    if (length > most) {
      await reader.cancel();
      throw new Error('it is too long');
    }
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}

/** @param {string} text @returns {Promise<string>} letters, digits, - and _ */
export async function packed(text) {
  const bytes = new TextEncoder().encode(text);
  const compressed = await through(bytes, new CompressionStream('deflate-raw'));
  const all = new Uint8Array(CHECKSUM + compressed.length);
  new DataView(all.buffer).setUint32(0, checksum(compressed));
  all.set(compressed, CHECKSUM);
  let letters = '';
  for (const byte of all) letters += String.fromCharCode(byte);
  return btoa(letters).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/**
 * @param {string} letters of a packed text
 * @returns {Promise<string | null>} null if they are not whole, or not those that were packed
 */
export async function unpacked(letters) {
  try {
    const plain = atob(letters.replaceAll('-', '+').replaceAll('_', '/'));
    const all = Uint8Array.from(plain, (letter) => letter.charCodeAt(0));
    const compressed = all.slice(CHECKSUM);
    if (new DataView(all.buffer).getUint32(0) !== checksum(compressed)) return null;
    const bytes = await through(compressed, new DecompressionStream('deflate-raw'), MOST_BYTES);
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    return null;
  }
}
