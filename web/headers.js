// SPDX-License-Identifier: MIT
/**
 * @file What a server is best to say of the pages: `npm start` does, any other may.
 */

/**
 * What a built page may load and do: nothing that is not served beside it, and no code or style in the HTML. Workers get
 * theirs from a server's headers alone, and the core is WebAssembly.
 */
export const policy = [
  "default-src 'self'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "img-src 'self' data: blob:",
  "object-src 'none'",
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

/** A page whose memory nobody else can read, and which may therefore share it with its workers: the core then has threads. */
export const isolation = {
  'Cross-Origin-Opener-Policy': 'same-origin',
  'Cross-Origin-Embedder-Policy': 'require-corp',
};

export const headers = {
  'Content-Security-Policy': `${policy}; frame-ancestors 'none'`,
  'X-Content-Type-Options': 'nosniff',
  ...isolation,
};
