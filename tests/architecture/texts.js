// SPDX-License-Identifier: MIT
/**
 * @file What every text of the project keeps to: how a source file opens, and no word of the machines that it was written on. Every check
 * returns the problems that it finds, one line each.
 */
import { matching } from './tree.js';

/** @typedef {import('./tree.js').Files} Files */

/**
 * A source file opens with its licence and a sentence on what it owns.
 * @param {Files} files
 * @returns {string[]}
 */
export function openings(files) {
  const licence = /^(\/\/ SPDX-License-Identifier: MIT|\/\* SPDX-License-Identifier: MIT \*\/)\n/;
  const sentence = /^\/\/\/ \\file\n\/\/\/ [^\s*]|^\/\*\*(\n \*)? [\\@]file(\n \*)? [^\s*]/;
  const comment = /^# SPDX-License-Identifier: MIT\n# \S/;
  const problems = [];
  for (const [file, text] of matching(files, /\.(h|cpp|m?js)$/)) {
    if (!licence.test(text)) problems.push(`${file} does not open with the SPDX line`);
    else if (!sentence.test(text.replace(licence, ''))) problems.push(`${file} does not say what it owns`);
  }
  for (const [file, text] of matching(files, /(^|\/)CMakeLists\.txt$/)) {
    if (!comment.test(text)) problems.push(`${file} does not open with the SPDX line and what it owns`);
  }
  return problems;
}

/**
 * No absolute paths of a machine and no host of a package registry; the lock file leaves the registry to whoever installs.
 * @param {Files} files
 * @returns {string[]}
 */
export function machines(files) {
  const machinePath = /(?<![\w.*-])\/(home|root|work|workspace|Users)\/\w/;
  const registryHost = /\b(registry|deb|ftp|security|mirrors?|npm|pypi|proxy)\.[a-z-]+\.(org|com|net|io|dev)\b/;
  const problems = [];
  for (const [file, text] of files) {
    for (const pattern of [machinePath, registryHost]) {
      const found = pattern.exec(text);
      if (found) problems.push(`${file} names ${found[0]}`);
    }
  }
  if (/"resolved":/.test(files.get('package-lock.json') ?? ''))
    problems.push('package-lock.json names where it downloads from');
  return problems;
}
