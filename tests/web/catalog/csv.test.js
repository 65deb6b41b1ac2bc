// SPDX-License-Identifier: MIT
/**
 * @file The catalog as comma-separated values: another reader gets every number back to the last digit.
 */
import { expect, test } from '@jest/globals';
import { catalogCsv } from '../../../web/pages/catalog/csv.js';
import { catalog, catalogWithHole, entry } from './small.js';

/** RFC 4180, as a state machine. @param {string} text @returns {string[][]} */
function parse(text) {
  const lines = [[/** @type {string} */ ('')]];
  let quoted = false;
  for (let i = 0; i < text.length; i++) {
    const line = lines[lines.length - 1];
    if (quoted && text[i] === '"' && text[i + 1] === '"') line[line.length - 1] += text[++i];
    else if (text[i] === '"') quoted = !quoted;
    else if (!quoted && text[i] === ',') line.push('');
    else if (!quoted && text.startsWith('\r\n', i)) i = (lines.push(['']), i + 1);
    else line[line.length - 1] += text[i];
  }
  expect(lines.pop()).toEqual(['']);
  return lines;
}

test('a line per entry, all of one length, with the names of the columns first', () => {
  const [head, ...lines] = parse(catalogCsv(catalog));
  expect(new Set(head).size).toBe(head.length);
  expect(lines).toHaveLength(catalog.entries.length);
  for (const line of lines) expect(line).toHaveLength(head.length);
});

test('the sides of a hole and what its boundary holds are columns, empty for closed shapes', () => {
  const [head, ...lines] = parse(catalogCsv(catalogWithHole));
  const of = (/** @type {string[]} */ line) => ['sides', 'boundary'].map((name) => line[head.indexOf(name)]);
  expect(of(lines[0])).toEqual(['', '']);
  expect(of(lines[lines.length - 1])).toEqual(['5', 'curvature']);
});

test('numbers come back to the last digit, what is not there is empty, and texts keep their quotes', () => {
  const [head, ...lines] = parse(catalogCsv(catalog));
  lines.forEach((line, i) => {
    const record = Object.fromEntries(head.map((name, column) => [name, line[column]]));
    const source = catalog.entries[i];
    expect(record.energy === '' ? null : Number(record.energy)).toBe(source.energy);
    expect(record.error === '' ? null : Number(record.error)).toBe(source.error);
    expect(Number(record.gaussian)).toBe(source.energies.gaussian);
    expect(record.second_form_variation).toBe('');
    expect(record.exact_source).toBe(source.exact_source ?? '');
    expect(record.status).toBe(source.status);
    expect(record.version).toBe('0.1.0');
  });
});

test('commas, quotes and line breaks in a text do not end a field', () => {
  const reason = 'It "thins", level\r\nby level';
  const [head, line] = parse(catalogCsv({ ...catalog, entries: [entry('two-3', 'mvs', { reason })] }));
  expect(line[head.indexOf('reason')]).toBe(reason);
});
