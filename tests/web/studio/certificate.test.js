// SPDX-License-Identifier: MIT
/**
 * @file What actions and the worker's messages make of the certificate in the page's state.
 */
import { beforeAll, describe, expect, test } from '@jest/globals';
import { load } from '../../../wasm/umbilic.js';
import { undoName } from '../../../web/pages/studio/state/history.js';
import { initialState, reduce } from '../../../web/pages/studio/state/reduce.js';
import { certificateButton } from '../../../web/pages/studio/state/select.js';
import { createStudio } from './real.js';
import {
  after,
  answered,
  certificate,
  ended,
  leaves,
  openedMessages,
  resting,
  running,
  surfaceState,
} from './state.js';

describe('a certificate', () => {
  const press = /** @type {const} */ ({ type: 'certifyPressed' });
  const cancel = /** @type {const} */ ({ type: 'certificateCancelPressed' });
  /** @param {number} amount */
  const advanced = (amount) => answered({ type: 'certificateAdvanced', run: 1, progress: amount });
  const answer = answered({ type: 'certified', run: 1, report: certificate() });

  test('is offered when a run has ended, and at no other time', () => {
    for (const state of [initialState(), resting(), running()]) {
      expect(certificateButton(state).enabled).toBe(false);
      expect(reduce(state, press)).toBe(state);
    }
    expect(certificateButton(ended())).toEqual({ label: 'Check', action: 'certifyPressed', enabled: true });
    expect(certificateButton(after(ended(), { type: 'startPressed' })).enabled).toBe(false);
  });

  test('advances, is answered, and is not asked for again', () => {
    const begun = after(ended(), press, advanced(0.4));
    expect(leaves(begun).certifying).toEqual({ progress: 0.4, abandoning: false });
    expect(certificateButton(begun)).toEqual({ label: 'Cancel', action: 'certificateCancelPressed', enabled: true });
    const certified = after(begun, advanced(1), answer);
    expect(leaves(certified)).toMatchObject({ certifying: null, certificate: certificate() });
    expect(certificateButton(certified).action).toBe('descendPressed');
    const minimum = answered({ type: 'certified', run: 1, report: { ...certificate(), negative: 0 } });
    expect(certificateButton(after(begun, minimum)).enabled).toBe(false);
  });

  test('is cancelled once, and can be asked for again', () => {
    const asked = after(ended(), press, cancel);
    expect(leaves(asked).certifying?.abandoning).toBe(true);
    expect(certificateButton(asked).enabled).toBe(false);
    const abandoned = reduce(asked, answered({ type: 'certificateAbandoned', run: 1 }));
    expect(leaves(abandoned)).toMatchObject({ certifying: null, certificate: null, alert: null });
    expect(certificateButton(abandoned).enabled).toBe(true);
  });

  test('that cannot be given says why', () => {
    const refused = after(ended(), press, answered({ type: 'failed', run: 1, kind: 'input', message: 'cap flat' }));
    expect(leaves(refused)).toMatchObject({
      certifying: null,
      certificate: null,
      alert: { title: 'Whether it is a minimum cannot be told', message: 'cap flat' },
    });
  });

  test('is gone with the next run', () => {
    const state = after(ended(), press, answer, { type: 'startPressed' }, ...openedMessages(2));
    expect(leaves(state)).toMatchObject({ certificate: null, certifying: null, limit: null });
    const begun = after(ended(), press, { type: 'startPressed' }, ...openedMessages(2));
    expect(leaves(begun).certifying).toBeNull();
    expect(reduce(begun, answer)).toBe(begun);
  });

  test('whose worker was given up leaves the run as it ended, without an alert where the user wanted it', () => {
    const loss = /** @type {const} */ ({ type: 'workerLost', loss: 'silent', detail: '' });
    const wanted = after(ended(), press, cancel, loss);
    expect(leaves(wanted)).toMatchObject({ status: 'ended', stop: 'converged', certifying: null, alert: null });
    expect(wanted.session.opening).toMatchObject({ purpose: 'recovery', start: surfaceState(2, 9) });
    const broken = after(ended(), press, { ...loss, loss: 'broken', detail: 'not enough memory' });
    expect(broken.view.alert).toEqual({
      title: 'The search for lower surfaces broke off',
      message: 'not enough memory',
    });
    expect(leaves(after(broken, ...openedMessages(2)))).toMatchObject({ status: 'ended', stop: 'converged', run: 2 });
  });
});

describe('a certificate that counts directions down', () => {
  beforeAll(() => load());

  test('offers to descend: a new run begins with a lower surface, and undo leads back', () => {
    const studio = createStudio('?shape=tetrahedron-frame');
    studio.do(
      { type: 'settingsChanged', change: { functional: 'bending', levels: [0, 1] } },
      { type: 'startPressed' },
      { type: 'certifyPressed' },
    );
    const energy = () => Number(studio.state.document.result.levels.at(-1)?.energy);
    const [before, { negative } = { negative: 0 }] = [energy(), studio.state.document.result.certificate ?? undefined];
    expect(negative).toBeGreaterThan(0);
    expect(certificateButton(studio.state)).toEqual({ label: 'Descend', action: 'descendPressed', enabled: true });
    studio.do({ type: 'descendPressed' });
    expect(leaves(studio.state)).toMatchObject({ status: 'ended', certificate: null });
    expect(energy()).toBeLessThan(0.995 * before);
    expect(studio.state.document.result.group?.name).not.toBe('Td');
    expect(undoName(studio.state)).toBe('descend');
    studio.do({ type: 'undoPressed' });
    expect(energy()).toBe(before);
    expect(studio.state.document.result.certificate?.negative).toBe(negative);
    // The worker has forgotten the certificate, and computes it again.
    studio.do({ type: 'descendPressed' });
    expect(energy()).toBeLessThan(0.995 * before);
  });
});
