// SPDX-License-Identifier: MIT
/**
 * @file When the worker's session asks for all processors.
 */
import { expect, test } from '@jest/globals';
import { all, open, session, useSession, work } from './session_harness.js';

useSession();

test('a run is busy until it rests, and a surface at rest is not', () => {
  open(1, { terms: { mvs_cross: 1 } });
  work();
  expect(session.busy).toBe(false);
  session.obey({ type: 'optimize', run: 1 });
  expect(session.busy).toBe(true);
  work(3);
  session.obey({ type: 'pause', run: 1 });
  expect(session.busy).toBe(false);
  session.obey({ type: 'optimize', run: 1 });
  work();
  expect(all('ended')).toHaveLength(1);
  expect(session.busy).toBe(false);
});

test('a run behind the screen leaves the processors to others, until it is in front again', () => {
  open(1, { terms: { mvs_cross: 1 } }, { then: 'run' });
  expect(session.busy).toBe(true);
  session.obey({ type: 'stand', behind: true });
  expect(session.busy).toBe(false);
  work(3);
  expect(session.busy).toBe(false);
  session.obey({ type: 'stand', behind: false });
  expect(session.busy).toBe(true);
});

test('a certificate is busy until it is ready', () => {
  open(1, {}, { then: 'run' });
  work();
  session.obey({ type: 'certify', run: 1 });
  expect(session.busy).toBe(true);
  work();
  expect(all('certified')).toHaveLength(1);
  expect(session.busy).toBe(false);
});
