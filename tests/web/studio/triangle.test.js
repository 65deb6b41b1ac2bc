// SPDX-License-Identifier: MIT
/**
 * @file The triangle of a blend in the studio's state: its corners, the weights of its point, and how a run, undo, the
 * address, a project and a problem take them, on the real core.
 */
import { beforeAll, describe, expect, test } from '@jest/globals';
import { load } from '../../../wasm/umbilic.js';
import { formatStudioAddress, parseStudioAddress } from '../../../web/address/studio.js';
import { formatProject, parseProject } from '../../../web/pages/studio/project.js';
import { addressOf, whatIsAsked } from '../../../web/pages/studio/state/address.js';
import {
  cornersOf,
  defaultCorners,
  fittedCorners,
  pointOf,
  roundedShares,
  weightsAt,
  withCorner,
} from '../../../web/pages/studio/state/corners.js';
import { undoName } from '../../../web/pages/studio/state/history.js';
import { keptFrom } from '../../../web/pages/studio/state/kept.js';
import { activeWeights, defaultSettings, settingsFrom } from '../../../web/pages/studio/state/settings.js';
import { createStudio } from './real.js';
import { leaves } from './state.js';

/** @typedef {import('../../../web/pages/studio/state/types.js').Action} Action */
/** @typedef {import('../../../web/pages/studio/state/types.js').Settings} Settings */
/** @typedef {import('../../../web/plot/triangle.js').Shares} Shares */

beforeAll(() => load());

const [J2, J1, BENDING] = defaultCorners;
const undo = /** @type {const} */ ({ type: 'undoPressed' });

/** @param {Partial<Settings['weights']>} some @returns {Settings['weights']} */
const weightsOf = (some) => ({ ...defaultSettings.weights, bending: 0, mvs_cross: 0, ...some });

/** Moves the point of the settings' triangle. @param {Settings} settings @param {Shares} shares @param {boolean} [moving] @returns {Action} */
const move = (settings, shares, moving = false) => ({
  type: 'weightsChanged',
  weights: weightsAt(cornersOf(settings), settings.weights, shares),
  moving,
});

/** A studio with a blend of this point on a frame, of which one level is asked. @param {Shares} shares */
function blending(shares) {
  const studio = createStudio('?shape=two-3');
  studio.do({ type: 'settingsChanged', change: { functional: 'blend', levels: [1, 1] } });
  studio.do(move(studio.state.document.settings, shares));
  return studio;
}

describe('the point of a blend', () => {
  test('are the shares of its corners, whatever their sum, and gives them back as weights', () => {
    expect(defaultCorners).toEqual(['mean_curvature_variation', 'second_form_variation', 'bending']);
    const weights = weightsOf({ [J2]: 1, [J1]: 2, [BENDING]: 5 });
    const { shares, parts, outside } = pointOf(defaultCorners, weights);
    expect(shares).toEqual([0.125, 0.25, 0.625]);
    expect(parts).toEqual(shares);
    expect(outside).toEqual([]);
    expect(weightsAt(defaultCorners, weights, parts)).toEqual(weightsOf({ [J2]: 0.125, [J1]: 0.25, [BENDING]: 0.625 }));
  });

  test('says what weighs at no corner; moved, it leaves that out', () => {
    const weights = weightsOf({ [BENDING]: 1, mvs: 3 });
    expect(pointOf(defaultCorners, weights)).toEqual({ shares: [0, 0, 1], parts: [0, 0, 0.25], outside: ['mvs'] });
    expect(pointOf(defaultCorners, weightsOf({ mvs: 3 })).shares).toBeNull();
    expect(weightsAt(defaultCorners, weights, [0.5, 0, 0.5])).toEqual(weightsOf({ [J2]: 0.5, [BENDING]: 0.5 }));
    expect(pointOf(defaultCorners, weightsOf({ [J1]: NaN, [BENDING]: 1 })).shares).toEqual([0, 0, 1]);
  });
});

test('rounded shares are thousandths of sum 1, none below 0', () => {
  expect(roundedShares([1 / 3, 1 / 3, 1 / 3])).toEqual([0.333, 0.333, 0.334]);
  expect(roundedShares([0.9996, 0.0004, 0])).toEqual([1, 0, 0]);
  expect(roundedShares([0.4995, 0.5005, 0])).toEqual([0.5, 0.5, 0]);
  expect(roundedShares([0, 0, 1])).toEqual([0, 0, 1]);
});

describe('a corner', () => {
  test('keeps its weight when another functional is chosen for it, on top of what that had', () => {
    const weights = weightsOf({ [J2]: 0.2, [J1]: 0.3, [BENDING]: 0.5 });
    const { corners, weights: after } = withCorner(defaultCorners, weights, 0, 'curvedness_variation');
    expect(corners).toEqual(['curvedness_variation', J1, BENDING]);
    expect(after).toEqual(weightsOf({ curvedness_variation: 0.2, [J1]: 0.3, [BENDING]: 0.5 }));
    const outside = weightsOf({ [BENDING]: 0.5, mvs: 0.5 });
    expect(withCorner(defaultCorners, outside, 1, 'mvs')).toEqual({ corners: [J2, 'mvs', BENDING], weights: outside });
  });

  test('changes places with the corner that has the functional already, and the blend stays', () => {
    const weights = weightsOf({ [J2]: 0.2, [BENDING]: 0.8 });
    expect(withCorner(defaultCorners, weights, 0, BENDING)).toEqual({ corners: [BENDING, J1, J2], weights });
  });

  test('takes what weighs where a blend of three at most comes from elsewhere', () => {
    const two = weightsOf({ mvs: 1, [J1]: 1 });
    expect(fittedCorners(defaultCorners, two)).toEqual(['mvs', J1, BENDING]);
    const four = weightsOf({ mvs: 1, mvs_cross: 1, willmore: 1, [J1]: 1 });
    expect(fittedCorners(defaultCorners, four)).toBe(defaultCorners);
    const asked = settingsFrom(defaultSettings, { terms: { mvs: 2, curvedness_variation: 1 } });
    expect(asked.corners).toEqual(['mvs', 'curvedness_variation', BENDING]);
    expect(settingsFrom(defaultSettings, { terms: { mvs: 1 } }).corners).toEqual(defaultCorners);
  });
});

test('a run follows the point while it moves; the movement is one step, which undo takes back', () => {
  const studio = blending([0, 0.1, 0.9]);
  studio.work();
  studio.dispatch({ type: 'startPressed' });
  studio.work(12);
  const { length } = studio.state.history.past;
  const { settings } = studio.state.document;
  for (const top of [0.02, 0.05, 0.1]) {
    studio.dispatch(move(settings, [top, 0.1 - top / 2, 0.9 - top / 2], true));
    studio.work(3);
    expect(studio.state.session.phase.name).toBe('running');
  }
  studio.do(move(settings, [0.1, 0.05, 0.85]));
  expect(leaves(studio.state)).toMatchObject({ status: 'ended', stop: 'converged' });
  expect(activeWeights(studio.state.document.result.settings)).toEqual({ [J2]: 0.1, [J1]: 0.05, [BENDING]: 0.85 });
  expect(studio.state.history.past).toHaveLength(length + 1);
  expect(undoName(studio.state)).toBe('move the point of the blend');

  const fresh = blending([0.1, 0.05, 0.85]);
  fresh.do({ type: 'startPressed' });
  const energies = [studio, fresh].map(({ state }) => Number(state.document.result.levels.at(-1)?.energy));
  expect(energies[0] / energies[1]).toBeCloseTo(1, 4);

  studio.do(undo);
  expect(activeWeights(studio.state.document.settings)).toEqual({ [J1]: 0.1, [BENDING]: 0.9 });
}, 60_000);

test('choosing a corner is a step with a name, and undo brings the corner and the weights back', () => {
  const studio = blending([0.2, 0.3, 0.5]);
  const { corners, weights } = studio.state.document.settings;
  studio.do({ type: 'weightsChanged', ...withCorner(corners, weights, 0, 'mehlum_tarrou') });
  expect(studio.state.document.settings.corners).toEqual(['mehlum_tarrou', J1, BENDING]);
  expect(undoName(studio.state)).toBe('choose a corner');
  studio.do(undo);
  expect(studio.state.document.settings).toMatchObject({ corners, weights });
});

test('the address and a project keep the weights and the corners', () => {
  const studio = blending([0.2, 0.3, 0.5]);
  const { corners, weights } = studio.state.document.settings;
  studio.do({ type: 'weightsChanged', ...withCorner(corners, weights, 1, 'curvedness_variation') });
  const { settings } = studio.state.document;
  const { address } = parseStudioAddress(formatStudioAddress(addressOf(studio.state)));
  expect(address.weights).toEqual({ [J2]: 0.2, curvedness_variation: 0.3, bending: 0.5 });
  const asked = whatIsAsked(address, defaultSettings).settings;
  expect(asked).toMatchObject({ functional: 'blend', weights: settings.weights, corners: settings.corners });
  const { kept } = parseProject(formatProject(keptFrom(studio.state), 'blend'));
  expect(kept.document.settings).toEqual(settings);
});

test('a stored document that is older than the triangle has the usual corners', () => {
  const { corners, ...older } = defaultSettings;
  expect(cornersOf(/** @type {Settings} */ (older))).toEqual(corners);
});
