// SPDX-License-Identifier: MIT
/**
 * @file The worker's session under a hand that changes weights and pins while a run goes on, rests or has ended.
 */
import { describe, expect, test } from '@jest/globals';
import { Minimizer } from '../../wasm/umbilic.js';
import { all, open, problemOf, session, types, useSession, work } from './session_harness.js';

useSession();

const blend = { terms: { bending: 1, mvs_cross: 0.01 }, cage: { generator: 'two-3' } };
const other = { bending: 1, mvs_cross: 0.1 };

/** @param {import('../../wasm/types.js').Terms} terms */
const retarget = (terms) => session.obey({ type: 'retarget', run: 1, targets: { terms } });

/** The energy of a run of its own. @param {import('../../wasm/types.js').Terms} terms */
function minimum(terms) {
  const minimizer = new Minimizer(problemOf({ ...blend, terms }));
  while (!minimizer.step(10));
  const { energy } = minimizer.levels[0];
  minimizer.dispose();
  return energy;
}

describe('a run that is told other weights', () => {
  test.each([
    ['while it goes on', 12],
    ['after it has ended', Infinity],
  ])('%s ends where a run of its own does, and tells only of that', (_, turns) => {
    open(1, blend, { then: 'run' });
    work(turns);
    session.messages = [];
    retarget(other);
    work();
    expect(types()[0]).toBe('retargeted');
    expect(session.messages[0]).toMatchObject({ run: 1, runs: true });
    const ended = all('levelEnded');
    expect(ended).toHaveLength(1);
    expect(ended[0].report.energy / minimum(other)).toBeCloseTo(1, 5);
    expect(all('ended')).toHaveLength(1);
    expect(all('stepped')[0].samples[0]).toBe(1);
    expect(types().indexOf('surfaced')).toBeLessThan(types().indexOf('ended'));
    // The page has the triangles, unless it has the finer ones of a surface at rest.
    expect('triangles' in all('surfaced')[0].limit).toBe(turns === Infinity);
  });

  test('many times between two steps takes the last', () => {
    open(1, blend, { then: 'run' });
    work(12);
    for (const weight of [1, 0.5, 0.1]) retarget({ ...other, mvs_cross: weight });
    work();
    expect(all('retargeted')).toHaveLength(1);
    expect(all('levelEnded').at(-1).report.energy / minimum(other)).toBeCloseTo(1, 5);
  });

  test('and other things between two steps takes the last of each kind', () => {
    open(1, blend, { then: 'run' });
    work(12);
    retarget(other);
    session.obey({ type: 'retarget', run: 1, targets: { points: [0] } });
    work();
    expect(all('failed')).toHaveLength(1);
    session.obey({ type: 'retarget', run: 1, targets: {} });
    retarget(other);
    session.obey({ type: 'retarget', run: 1, targets: { pins: [] } });
    work();
    expect(all('levelEnded').at(-1).report.energy / minimum(other)).toBeCloseTo(1, 5);
  });

  test('while it is paused stays so, and goes on with them', () => {
    open(1, blend, { then: 'run' });
    work(12);
    session.obey({ type: 'pause', run: 1 });
    work();
    session.messages = [];
    retarget(other);
    work();
    expect(types()).toEqual(['retargeted', 'surfaced', 'saved', 'measured']);
    expect(session.messages[0].runs).toBe(false);
    session.obey({ type: 'optimize', run: 1 });
    work();
    expect(all('levelEnded').at(-1).report.energy / minimum(other)).toBeCloseTo(1, 5);
  });

  test('that are none says so and goes on as it was', () => {
    open(1, blend, { then: 'run' });
    work(12);
    retarget({ bending: -1 });
    work();
    expect(all('retargeted')).toEqual([]);
    expect(all('failed')).toEqual([expect.objectContaining({ run: 1, kind: 'input' })]);
    expect(all('levelEnded').at(-1).report.energy / minimum(blend.terms)).toBeCloseTo(1, 5);
  });
});
