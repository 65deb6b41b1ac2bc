// SPDX-License-Identifier: MIT
/**
 * @file The committed catalog in the studio: a minimizer of each shape, opened from its file by the worker's session, has the energies, the
 * symmetry and the address that the catalog says.
 */
import { readFileSync } from 'node:fs';
import { beforeAll, expect, test } from '@jest/globals';
import { Cage, InputError, Minimizer, load, parseReport } from '../../wasm/umbilic.js';
import { formatStudioAddress, parseStudioAddress } from '../../web/address/studio.js';
import { addressOf } from '../../web/pages/studio/state/address.js';
import { findEntry, showsEntry } from '../../web/pages/studio/state/entry.js';
import { initialState } from '../../web/pages/studio/state/reduce.js';
import { problemOf } from '../../web/pages/studio/state/settings.js';
import { createSession } from '../../web/worker/session.js';
import { after, answered } from './studio/state.js';

/** @typedef {import('../../web/files/catalog.js').Catalog} Catalog */
/** @typedef {import('../../web/worker/protocol.js').Message} Message */

/** @param {string} name */
const text = (name) => readFileSync(new URL(`../../web/catalog/${name}`, import.meta.url), 'utf8');
/** @type {Catalog} */
const catalog = JSON.parse(text('catalog.json'));
const functionals = catalog.functionals.map(({ name }) => name);

beforeAll(() => load());

/** @param {import('../../web/pages/studio/state/types.js').Opening} opening @returns {Message[]} the session's answers */
function open({ run, source, settings, start }) {
  /** @type {Message[]} */
  const messages = [];
  /** @type {Array<() => void>} */
  const waiting = [];
  const obey = createSession({
    core: { Cage, InputError, Minimizer, parseReport },
    post: (message) => messages.push(message),
    yieldThen: (task) => waiting.push(task),
    now: () => 0,
  });
  obey({ type: 'open', run, problem: problemOf(source, settings, start), look: true });
  for (const task of waiting) task();
  obey({ type: 'detail', run });
  return messages;
}

/** The functionals under which the catalog has the shape. @param {string} shape */
const functionalsOf = (shape) =>
  functionals.filter((functional) => catalog.entries.some((e) => e.shape === shape && e.functional === functional));

// Another functional for each shape, so that all of both are met.
test.each(
  catalog.shapes.map(({ name }, i) => {
    const had = functionalsOf(name);
    return [name, had[i % had.length]];
  }),
)('%s minimizing %s is the surface that the catalog tells of', (shape, functional) => {
  const search = `?shape=${shape}&functional=${functional}`;
  const waiting = initialState('system', parseStudioAddress(search));
  const name = { shape, functional };
  const found = findEntry(catalog, name);
  if ('missing' in found) {
    expect(catalog.entries.find((one) => one.shape === shape && one.functional === functional)?.minimizer).toBe(null);
    return;
  }
  const { entry } = found;
  const report = parseReport(text(`${shape}.${functional}.json`));
  const opening = after(waiting, { type: 'entryLoaded', name: waiting.session.wanted ?? name, entry, report });
  if (!opening.session.opening) throw new Error('nothing is opened');
  const messages = open(opening.session.opening);
  const shown = after(opening, ...messages.map(answered));
  expect(showsEntry(shown)).toBe(true);
  expect(shown.document.result.group).toEqual(entry.group);
  const { constraints } = catalog.shapes.find((one) => one.name === shape) ?? {};
  expect(shown.document.settings.constraints).toEqual(constraints ?? {});
  const { source, settings } = opening.session.opening;
  expect(problemOf(source, settings, null)).toMatchObject({
    cage: report.problem.cage,
    ...(constraints && { constraints }),
  });
  expect(formatStudioAddress(addressOf(shown))).toBe(search);
  const measured = messages.find(({ type }) => type === 'measured');
  if (measured?.type !== 'measured') throw new Error('nothing is measured');
  for (const [key, value] of Object.entries(entry.energies)) {
    // Native code and WebAssembly add in other orders: 1.5e-10 at most was seen over all entries.
    const energy = Number(measured.energies[/** @type {keyof import('../../wasm/types.js').Energies} */ (key)]);
    if (typeof value === 'number' && key !== 'quadrature_error')
      expect(Math.abs(energy - value)).toBeLessThanOrEqual(1e-9 * Math.max(1, Math.abs(value)));
  }
});
