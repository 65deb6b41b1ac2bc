// SPDX-License-Identifier: MIT
/**
 * @file Checks on all texts of the project: how source files begin, and that nothing reveals the machine on which it
 * was written. Every check returns the problems that it finds, one line each.
 */
import { matching } from './tree.js';

/** @typedef {import('./tree.js').Files} Files */

/**
 * A source file begins with its licence and a sentence on its content.
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
 * No text contains absolute paths of a machine or hosts of a package registry. The lock file omits the registry, so
 * that it can be chosen at installation.
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
