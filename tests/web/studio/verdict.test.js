// SPDX-License-Identifier: MIT
/**
 * @file What the studio says of a result: one sentence and at most one thing to do next, in every state that a document can
 * be in; nothing else on the page says otherwise.
 */
import { describe, expect, test } from '@jest/globals';
import { MAX_LEVEL } from '../../../web/pages/studio/state/settings.js';
import { nextButton } from '../../../web/pages/studio/state/next.js';
import { energyNotes, errorsOf, runButtons, statusSentence } from '../../../web/pages/studio/state/select.js';
import { certificateWords, limitWords } from '../../../web/words/results.js';
import { bound, folded, levelsOf, limit, none, over, three } from './outcomes.js';
import {
  after,
  answered,
  certificate,
  energies,
  levelReport,
  noLimit,
  openedMessages,
  progress,
  resting,
  running,
  withCage,
} from './state.js';

/** @typedef {import('../../../wasm/types.js').StopReason} StopReason */
/** @typedef {import('../../../web/pages/studio/state/types.js').State} State */

/** A catalog's minimizer. @param {string} status @param {import('../../../wasm/types.js').CertificateReport} [report] */
function ofCatalog(status, report = none) {
  const state = over({ certificate: report });
  const { result, settings } = state.document;
  const entry = /** @type {any} */ ({ shape: 'two-3', functional: 'bending', status });
  const document = { ...state.document, minimizer: { entry, settings }, result: { ...result, catalogs: true } };
  return { ...state, document };
}

/** @param {State} state */
const open = (state) => withCage(state, (cage) => ({ ...cage, counts: { ...cage.counts, boundaries: [boundary] } }));
const boundary = { number: 1, vertices: 8, first_vertex: 1, component: 1 };

const paused = after(
  running(),
  { type: 'pausePressed' },
  answered({ type: 'paused', run: 1, progress: progress(0, 5) }),
);
const lost = after(running(), { type: 'workerLost', loss: 'broken', detail: '' }, ...openedMessages(2));

/** @type {Array<[name: string, state: State, sentence: string | RegExp, next: string | null]>} */
const states = [
  ['fresh', resting(), 'Ready.', null],
  ['running', running(), 'Minimizing …', null],
  ['pausing', after(running(), { type: 'pausePressed' }), 'Pausing …', null],
  ['paused', paused, 'Paused at 146.0; it was still falling.', null],
  [
    'cancelled',
    over({ stop: 'cancelled', limit: limit({ status: 'not_minimized' }) }),
    'Stopped at 146.0; it was still falling.',
    'Go on',
  ],
  [
    'cancelled before the last level was any better',
    over({ stop: 'cancelled', levels: levelsOf(150, 130), limit: noLimit() }),
    'Stopped before the finest mesh was any better; a coarser one is the result, with 130.0.',
    'Go on',
  ],
  ['broken off', lost, 'Broken off at 146.0; its surface is kept.', 'Go on'],
  ['converged with a bar', over({}), 'Minimized: 3913, within 0.77 %.', 'Check that it is a minimum'],
  [
    'converged, but for rounding',
    over({ stop: 'round_off' }),
    'Minimized: 3913, within 0.77 %.',
    'Check that it is a minimum',
  ],
  [
    'within the accuracy that was asked for',
    over({ settings: { accuracy: 0.01 } }),
    'Minimized: 3913, within 0.77 %.',
    'Check that it is a minimum',
  ],
  [
    'not within it',
    over({ settings: { accuracy: 0.003 } }),
    'Minimized: 3913, within 0.77 %, not the 0.3 % asked for.',
    'Check that it is a minimum',
  ],
  [
    'with a bar as wide as the energy',
    over({ limit: limit({ status: 'converging', energy: 0.17, error: 0.17, lower: 0 }) }),
    'Minimized: between 0 and 0.3400.',
    'Check that it is a minimum',
  ],
  [
    'with a flat cap, which the core does not certify',
    over({ settings: { cap: 'flat' } }),
    'Minimized: 3913, within 0.77 %.',
    null,
  ],
  [
    'two levels',
    over({ levels: three.slice(0, 2), limit: noLimit() }),
    'Minimized on this mesh: 120.1; its accuracy takes a finer mesh to tell.',
    'Go one level finer',
  ],
  [
    'two levels, of which one only prepares',
    over({ levels: [levelReport(0, { evaluable: false }), levelReport(1)], limit: noLimit() }),
    'Minimized on this mesh: 120.1; its accuracy takes 2 finer meshes to tell.',
    'Go one level finer',
  ],
  [
    'one level, which only prepares',
    over({ levels: [levelReport(0, { evaluable: false })], limit: limit({ energy: NaN }) }),
    'Minimized on this mesh: 146.0; its accuracy takes 3 finer meshes to tell.',
    'Go one level finer',
  ],
  [
    'a part held on one level',
    over({
      levels: [levelReport(0)],
      limit: noLimit(),
      settings: { constraints: { hold: { faces: [1] } } },
    }),
    'Minimized on this mesh around what is held: 120.1; its accuracy takes 2 finer meshes to tell.',
    'Go one level finer',
  ],
  [
    'one level, the finest of all',
    over({ levels: [levelReport(MAX_LEVEL)], limit: noLimit() }),
    /^Minimized on this mesh: 120\.1; /,
    'Check that it is a minimum',
  ],
  [
    'a coarser level that ended early',
    over({ limit: limit({ status: 'not_minimized' }) }),
    'Minimized on this mesh: 120.1; its accuracy is not known, since a coarser mesh ended early.',
    'Go one level finer',
  ],
  [
    'an upper bound',
    over({ limit: bound }),
    'The energy keeps falling as the mesh is refined: 25.13 is an upper bound; a finer mesh may tell more.',
    'Go one level finer',
  ],
  [
    'an upper bound of many levels',
    over({ levels: levelsOf(40, 35, 31, 28, 25.13), limit: bound }),
    'The energy keeps falling as the mesh is refined: 25.13 is an upper bound; there may be no surface of least energy.',
    null,
  ],
  [
    'levels whose energies rise',
    over({ levels: levelsOf(25.13, 25.2, 25.4), limit: limit({ status: 'not_converging', energy: 25.13 }) }),
    'The energy does not settle as the mesh is refined: 25.13 is an upper bound; a finer mesh may tell more.',
    'Go one level finer',
  ],
  [
    'kept within a distance',
    over({ limit: limit({ status: 'not_comparable' }), settings: { constraints: { closeness: { within: 0.1 } } } }),
    'Minimized within the distance: 120.1; every mesh is pulled differently, so its accuracy is not known.',
    'Check that it is a minimum',
  ],
  [
    'an iteration limit',
    over({ stop: 'max_iterations', limit: limit({ status: 'not_minimized' }), settings: { max_iterations: 7 } }),
    'Stopped after 7 iterations, the most allowed, at 146.0; it was still falling.',
    'Go on',
  ],
  [
    'a line search that found nothing',
    over({ stop: 'line_search_stalled', limit: limit({ status: 'not_minimized' }) }),
    'Ended at 146.0: no step led lower, but that proves no minimum.',
    'Go one level finer',
  ],
  [
    'below the bound',
    over({
      stop: 'below_bound',
      levels: three.map((level) => ({ ...level, credible: false })),
      limit: limit({ status: 'not_resolved' }),
      energies: folded,
    }),
    'No minimum: it has less energy than any such surface can, so it must have folded.',
    null,
  ],
  [
    'one level that does not resolve its surface',
    over({
      stop: 'not_resolved',
      levels: [levelReport(0, { credible: false })],
      limit: limit({ status: 'not_resolved' }),
      energies: { ...energies(1), resolved: false },
    }),
    'No minimum: it has folds or necks too thin for its mesh, so its energy is not known.',
    'Go one level finer',
  ],
  [
    'a last level that folds',
    over({
      stop: 'not_resolved',
      levels: [three[0], three[1], { ...three[2], credible: false }],
      limit: limit({ status: 'not_resolved', energy: 270 }),
    }),
    'The surface folded on the finest mesh, so that a coarser one is the result, with 270.0.',
    null,
  ],
  [
    'not finite',
    over({ stop: 'not_finite', levels: [], limit: noLimit() }),
    'Nothing was minimized: the energy of this surface is not finite.',
    null,
  ],
  ['collapsed', over({ stop: 'degenerate', limit: limit({ status: 'not_minimized' }) }), /collapsed/, null],
  ['a minimum', over({ certificate: none }), 'A minimum: 3913, within 0.77 %.', null],
  [
    'a minimum whose levels do not settle',
    over({ limit: bound, certificate: none }),
    /25\.13 is an upper bound/,
    'Go one level finer',
  ],
  [
    'a minimum on too few levels',
    over({ levels: three.slice(0, 2), limit: noLimit(), certificate: none }),
    /^A minimum on this mesh: 120\.1; .* takes a finer mesh to tell\.$/,
    'Go one level finer',
  ],
  [
    'a saddle',
    over({ certificate: certificate() }),
    'Not a minimum: 3913, within 0.77 %; 6 directions lower the energy.',
    'Descend',
  ],
  [
    'a saddle on two levels',
    over({ levels: three.slice(0, 2), limit: noLimit(), certificate: { ...certificate(), negative: 1 } }),
    'Not a minimum: 120.1 on this mesh; 1 direction lowers the energy.',
    'Descend',
  ],
  [
    'a run that was stopped, and then checked',
    over({ stop: 'cancelled', limit: limit({ status: 'not_minimized' }), certificate: certificate() }),
    'Stopped at 146.0; it was still falling.',
    'Go on',
  ],
  [
    'being checked',
    after(over({}), { type: 'certifyPressed' }),
    'Looking for surfaces near it with less energy …',
    null,
  ],
  [
    'a part held',
    over({ settings: { constraints: { hold: { faces: [1] } } } }),
    'Minimized around what is held: 3913, within 0.77 %.',
    'Check that it is a minimum',
  ],
  [
    'a part held, a minimum',
    over({ settings: { constraints: { pins: [{ vertex: 1 }] } }, certificate: none }),
    'A minimum around what is held: 3913, within 0.77 %.',
    null,
  ],
  [
    'an open cage',
    open(over({})),
    'Minimized with its boundary kept: 3913, within 0.77 %.',
    'Check that it is a minimum',
  ],
  [
    'an open cage whose boundary is free',
    open(over({ settings: { constraints: { boundary: { condition: 'free' } } } })),
    'Minimized: 3913, within 0.77 %.',
    'Check that it is a minimum',
  ],
  ['the catalog’s', ofCatalog('converged'), 'The catalog’s minimizer: 3913, within 0.77 %.', null],
  [
    'the catalog’s, which is lower without its symmetry',
    ofCatalog('converged', certificate()),
    'The catalog’s minimizer with this symmetry: 3913, within 0.77 %; without it, 6 directions lower the energy.',
    'Descend',
  ],
  ['the catalog’s upper bound', ofCatalog('upper_bound'), /^The catalog’s best surface: .* an upper bound\.$/, null],
  ['the catalog’s zero', ofCatalog('zero_attained'), /none of this energy/, null],
  ['the catalog’s infimum', ofCatalog('infimum_not_attained'), /ever nearer to the least energy, which none has/, null],
  [
    'another functional asked for by now',
    after(over({}), { type: 'settingsChanged', change: { functional: 'bending' } }),
    'Minimized: 3913, within 0.77 %.',
    null,
  ],
];

/** @param {string | RegExp} text */
const narrow = (text) => (typeof text === 'string' ? text.replaceAll(' %', '\u202f%') : text);

/** The other texts beside the sentence. @param {State} state */
function otherTexts(state) {
  const { limit: told } = errorsOf(state);
  const { value, error, words } = told ? limitWords(told) : { value: '', error: '', words: '' };
  const { certificate: report, group, stop } = state.document.result;
  const minimum = report ? certificateWords(report, group, stop) : null;
  return {
    limit: [value, error && `± ${error}`, words].join(' '),
    minimum: minimum ? minimum.before + minimum.symbol + minimum.after : '',
    warnings: energyNotes(state).filter(({ warning }) => warning),
    buttons: Object.values(runButtons(state)).map(({ label }) => label),
  };
}

describe('a result', () => {
  test.each(states)('is one sentence and at most one thing to do: %s', (_, state, sentence, next) => {
    const said = statusSentence(state);
    if (typeof sentence === 'string') expect(said).toBe(narrow(sentence));
    else expect(said).toMatch(sentence);
    expect(said).toMatch(/^\p{Lu}[^.]*(\.\d+[^.]*)*( …|\.)$/u);
    expect(nextButton(state)?.label ?? null).toBe(next);
  });

  test.each(states)('is not said otherwise anywhere: %s', (_, state) => {
    const said = statusSentence(state);
    const { limit: told, minimum, warnings, buttons } = otherTexts(state);
    const known = /within \S*\d|between/.test(said);
    if (!said.endsWith('…')) expect(told.includes('±')).toBe(known);
    if (/upper bound|not known|falling|folded|collapsed/.test(said)) expect(told).not.toMatch(/±/);
    if (said.startsWith('A minimum')) expect(minimum).toMatch(/^Yes/);
    if (said.startsWith('Not a minimum')) expect(minimum).toMatch(/^No:/);
    if (minimum.startsWith('Yes'))
      expect(said).toMatch(/^A minimum|^The catalog|^From the catalog|as the mesh is refined/);
    if (minimum.startsWith('No:'))
      expect(said).toMatch(/^Not a minimum|without it, \d+ directions? lowers? the energy\.$/);
    expect(warnings.length > 0).toBe(/^No minimum/.test(said));
    expect([told, minimum, ...buttons].join(' ')).not.toMatch(/converge|upper bound|certif/i);
    expect(buttons).not.toContain(nextButton(state)?.label);
  });

  test('that is the core’s reason to end has a sentence for each', () => {
    /** @type {StopReason[]} */
    const stops = ['converged', 'max_iterations', 'line_search_stalled', 'round_off', 'not_finite', 'degenerate'];
    for (const stop of [...stops, /** @type {const} */ ('cancelled'), 'below_bound', 'not_resolved']) {
      const { result } = over({ stop: /** @type {StopReason} */ (stop) }).document;
      expect(result.stop).toBe(stop);
      expect(statusSentence(over({ stop: /** @type {StopReason} */ (stop) }))).toMatch(/\.$/);
    }
  });
});
