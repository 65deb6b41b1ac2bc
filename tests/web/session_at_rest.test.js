// SPDX-License-Identifier: MIT
/**
 * @file The worker's session while a surface rests: what it prepares before it is asked, and certificates.
 */
import { describe, expect, test } from '@jest/globals';
import { fish } from '../browser/fish.js';
import { all, open, problemOf, session, types, useSession, work } from './session_harness.js';

useSession();

describe('while a surface rests', () => {
  /** How many turns it takes until the first surface that has moved is told. @param {number} run */
  function turnsUntilMoved(run) {
    session.messages.length = 0;
    let turns = 0;
    for (; !all('surfaced').length; turns++) work(1);
    expect(all('surfaced')[0]).toMatchObject({ run });
    return turns;
  }

  test('its level is prepared, so that the first steps are evaluations', () => {
    open(1, { levels: [1, 2], terms: { mvs_cross: 1 } });
    session.obey({ type: 'optimize', run: 1 });
    const unprepared = turnsUntilMoved(1);
    open(2, { levels: [1, 2], terms: { mvs_cross: 1 } });
    work();
    expect(session.rests).toBe(1);
    session.obey({ type: 'optimize', run: 2 });
    const prepared = turnsUntilMoved(2);
    expect(prepared).toBeLessThanOrEqual(all('surfaced')[0].evaluations);
    expect(prepared).toBeLessThan(unprepared);
  });

  test('the run that is expected next is prepared as well, and no other is taken for it', () => {
    const asked = { cage: { generator: 'two-3' }, terms: { mvs_cross: 1 } };
    open(1);
    session.obey({ type: 'expect', run: 1, problem: problemOf(asked) });
    work();
    const energies = [];
    const turns = [];
    for (const [run, changed] of [asked, { ...asked, levels: /** @type {[number, number]} */ ([1, 2]) }].entries()) {
      open(run + 2, changed, { then: 'run' });
      turns.push(turnsUntilMoved(run + 2));
      energies.push(all('measured')[0].energies.mvs_cross);
    }
    expect(turns[0]).toBeLessThan(turns[1]);
    expect(energies[0] / energies[1]).toBeCloseTo(1, 12); // of the same cage
  });

  test('a run that could not be opened is not expected, without a word', () => {
    open(1);
    work();
    session.messages.length = 0;
    session.obey({ type: 'expect', run: 1, problem: problemOf({ cage: { generator: 'none' } }) });
    work();
    expect(session.messages).toEqual([]);
  });
});

describe('what is held', () => {
  const text = fish();
  const constraints = { hold: { groups: ['head'] } };
  const problem = { cage: { name: 'fish.obj', text }, terms: { bending: 1 }, constraints };

  test('is known by the groups of the cage, and the mesh says which face of the cage each triangle is over', () => {
    session.obey({ type: 'open', run: 1, problem });
    work();
    const { groups, cage } = all('opened')[0];
    expect(groups.map((/** @type {any} */ { name, faces }) => [name, faces.length])).toEqual([
      ['head', 32],
      ['body', 64],
    ]);
    const { limit, control } = all('surfaced')[0];
    for (const { faces, triangles } of [limit, control]) {
      expect(faces).toHaveLength(triangles.length / 3);
      const counts = new Map();
      for (const face of faces) counts.set(face, (counts.get(face) ?? 0) + 1);
      expect(counts.size).toBe(cage.faces);
      expect(new Set(counts.values()).size).toBe(1);
    }
    const ofHead = [...limit.triangles].filter((_, i) => limit.faces[Math.floor(i / 3)] < 32);
    const behind = ofHead.filter((v) => !(limit.positions[3 * v] + limit.centre[0] > 0));
    expect(behind).toEqual([]); // the head is at the front
    expect(all('measured')[0].energies.free.area).toBeLessThan(all('measured')[0].energies.area);
  });

  test('is in the problem that is saved, which opens again with it', () => {
    session.obey({ type: 'open', run: 1, problem });
    work();
    session.obey({ type: 'export', run: 1, what: 'problem' });
    const saved = all('exported')[0].content;
    expect(JSON.parse(saved)).toMatchObject({ umbilic: 'problem', constraints });
    session.obey({ type: 'open', run: 2, problem: saved });
    expect(all('opened')[1].asked.constraints).toMatchObject(constraints);
    work();
    expect(all('measured')[1].energies).toEqual(all('measured')[0].energies);
  });
});

describe('a certificate', () => {
  /** @param {number} run @param {any} [more] */
  function minimize(run, more) {
    open(run, more);
    session.obey({ type: 'optimize', run });
    work();
    session.messages.length = 0;
  }

  test('advances step by step and says whether the surface is a minimum', () => {
    minimize(1);
    session.obey({ type: 'certify', run: 1 });
    expect(session.messages).toEqual([]);
    work();
    const advances = all('certificateAdvanced').map(({ progress }) => progress);
    expect(advances.length).toBeGreaterThan(3);
    expect(advances).toEqual([...advances].sort((a, b) => a - b));
    expect(advances.at(-1)).toBe(1);
    expect(session.messages.at(-1)).toEqual({
      type: 'certified',
      run: 1,
      report: { level: 1, unknowns: 78, gauge: 10, tau: 1e-3, negative: 0 },
    });
  });

  test('is abandoned between two steps, and one that is ready is not', () => {
    minimize(1);
    session.obey({ type: 'certify', run: 1 });
    work(2);
    session.obey({ type: 'abandonCertificate', run: 1 });
    expect(types().at(-1)).toBe('certificateAbandoned');
    const count = session.messages.length;
    work();
    session.obey({ type: 'abandonCertificate', run: 1 });
    expect(session.messages).toHaveLength(count);
    session.obey({ type: 'certify', run: 1 });
    work();
    expect(all('certified')).toHaveLength(1);
  });

  test('is dropped when another run opens, and refused with the reason where there can be none', () => {
    minimize(1);
    session.obey({ type: 'certify', run: 1 });
    work(2);
    minimize(2, { cap: 'flat' });
    expect(all('certified')).toEqual([]);
    session.obey({ type: 'certify', run: 2 });
    work();
    expect(session.messages).toEqual([
      { type: 'failed', run: 2, kind: 'input', message: expect.stringMatching(/cap flat/) },
    ]);
  });

  test('is not begun while a run goes on', () => {
    open(1);
    session.obey({ type: 'optimize', run: 1 });
    session.obey({ type: 'certify', run: 1 });
    work();
    expect(types()).not.toContain('certified');
    expect(all('ended')).toHaveLength(1);
  });
});
