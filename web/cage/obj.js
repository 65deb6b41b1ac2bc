// SPDX-License-Identifier: MIT
/**
 * @file Polygon cages as OBJ text, with all digits: points, faces and groups. Of what the format has besides, nothing is read;
 * which cages a file may hold is the core's to say (core/cage/read.h).
 */
import { problemOfCage, refuse } from './polygons.js';

/** @import {Point, PolygonCage, Refused} from './polygons.js' */

/** The number from 0 of a point that a corner of a face names, such as 3/1/2 or -1. @param {string} word @param {number} count */
function cornerOf(word, count) {
  const index = Number(word.split('/')[0]);
  if (!Number.isInteger(index) || index === 0) return -1;
  const v = index > 0 ? index - 1 : count + index;
  return v < count ? v : -1;
}

/** Lines without comments, those that a backslash continues joined. @param {string} text @returns {Array<[line: number, words: string[]]>} */
function statements(text) {
  /** @type {Array<[number, string[]]>} */
  const found = [];
  let begun = '';
  text.split(/\r\n|\n|\r/).forEach((line, i) => {
    if (line.endsWith('\\')) {
      begun += `${line.slice(0, -1)} `;
      return;
    }
    const words = (begun + line).replace(/#.*/, '').split(/\s+/).filter(Boolean);
    begun = '';
    if (words.length) found.push([i + 1, words]);
  });
  return found;
}

/**
 * @param {string} text
 * @returns {PolygonCage | Refused}
 */
export function parseObj(text) {
  /** @type {PolygonCage} */
  const cage = { points: [], faces: [], groups: [] };
  /** @type {Map<string, number[]>} */
  const groups = new Map();
  /** @type {string[]} */
  let current = [];
  for (const [line, [keyword, ...words]] of statements(text)) {
    if (keyword === 'v') {
      const [x, y, z] = words.map(Number);
      if (![x, y, z].every(Number.isFinite)) return refuse(`Line ${line}: a vertex has three numbers.`);
      cage.points.push([x, y, z]);
    } else if (keyword === 'g') {
      current = words;
    } else if (keyword === 'f') {
      const face = words.map((word) => cornerOf(word, cage.points.length));
      const wrong = face.findIndex((v) => v < 0);
      if (wrong >= 0) return refuse(`Line ${line}: there is no vertex ${words[wrong]}.`);
      for (const name of new Set(current)) groups.set(name, [...(groups.get(name) ?? []), cage.faces.length]);
      cage.faces.push(face);
    }
  }
  cage.groups = [...groups].map(([name, faces]) => ({ name, faces }));
  const problem = problemOfCage(cage);
  return problem ? refuse(problem) : cage;
}

/** With the sign of zero, which the core keeps too. @param {number} x */
const digits = (x) => (Object.is(x, -0) ? '-0' : String(x));

/** @param {PolygonCage} cage @returns {string} which reads back as the same cage */
export function formatObj({ points, faces, groups }) {
  const lines = points.map((point) => `v ${point.map(digits).join(' ')}`);
  /** @type {string[][]} */
  const names = faces.map(() => []);
  for (const { name, faces: members } of groups) for (const f of members) names[f].push(name);
  let last = '';
  faces.forEach((face, f) => {
    const statement = ['g', ...names[f]].join(' ');
    // A backslash at the end would join the next line.
    if (names[f].join(' ') !== last) lines.push(statement.endsWith('\\') ? `${statement} ` : statement);
    last = names[f].join(' ');
    lines.push(`f ${face.map((v) => v + 1).join(' ')}`);
  });
  return `${lines.join('\n')}\n`;
}
