// SPDX-License-Identifier: MIT
/**
 * @file What actions cause: commands to the worker, and files.
 */
import { beforeEach, describe, expect, test } from '@jest/globals';
import { parseStudioAddress } from '../../../web/address/studio.js';
import { createEffects } from '../../../web/pages/studio/effects.js';
import { fileName } from '../../../web/pages/studio/names.js';
import { initialState, reduce } from '../../../web/pages/studio/state/reduce.js';
import { withDocument, withView } from '../../../web/pages/studio/state/parts.js';
import { computedValues } from '../../../web/pages/studio/state/wish.js';
import { answered, ended, mesh, openedMessages, resting, running } from './state.js';

/** @typedef {import('../../../web/pages/studio/state/types.js').Action} Action */
/** @typedef {import('../../../web/pages/studio/state/types.js').State} State */

/** @type {any[]} */
let sent;
/** @type {Array<[string, string | ArrayBuffer, string]>} */
let saved;
/** @type {any[]} */
let loads;
/** @type {any[]} */
let pictures;
/** @type {string[]} */
let addresses;
let abandoned = 0;
let restarted = 0;
/** @type {ReturnType<typeof createEffects>} */
let effects;

beforeEach(() => {
  sent = [];
  saved = [];
  loads = [];
  pictures = [];
  addresses = [];
  abandoned = 0;
  restarted = 0;
  effects = createEffects({
    client: { send: (command) => sent.push(command), abandon: () => abandoned++, restart: () => restarted++ },
    save: (...file) => saved.push(file),
    takePicture: (state, options) => pictures.push(options),
    load: (name) => loads.push(name),
    setAddress: (search) => addresses.push(search),
  });
});

/** @param {State} state @param {...Action} actions @returns {State} */
function run(state, ...actions) {
  return actions.reduce((before, action) => {
    const next = reduce(before, action);
    effects(action, before, next);
    return next;
  }, state);
}

/** @param {boolean} original @returns {Action} */
const showsOriginal = (original) => ({ type: 'viewChanged', change: { original } });

const types = () => sent.map(({ type }) => type);

describe('the worker is told', () => {
  test('whether the deviation is shown, at once and with each run that it opens', () => {
    const shade = (/** @type {import('../../../web/colour/quantities.js').Shading} */ shading) =>
      /** @type {Action} */ ({ type: 'viewChanged', change: { shading } });
    const shown = run(resting(), shade('gaussian'), shade('deviation'), shade('deviation'));
    expect(sent).toEqual([{ type: 'compute', wish: { of: 'deviation' } }]);
    sent = [];
    const opening = run(shown, { type: 'generatorChanged', change: { name: 'cube' } });
    expect(sent).toMatchObject([{ type: 'open', wish: { of: 'deviation' } }]);
    run(opening, shade('plain'));
    expect(sent.at(-1)).toEqual({ type: 'compute', wish: null });
    run(resting(), { type: 'generatorChanged', change: { name: 'cube' } });
    expect(sent.at(-1)).not.toHaveProperty('wish');
  });

  test('of which energy the density is shown, whenever another one is chosen', () => {
    const shown = run(ended(), { type: 'viewChanged', change: { shading: 'energy' } });
    run(shown, { type: 'settingsChanged', change: { functional: 'bending' } });
    expect(sent).toEqual([
      { type: 'compute', wish: { of: 'energy', terms: { mvs_cross: 1 } } },
      { type: 'compute', wish: { of: 'energy', terms: { bending: 1 } } },
    ]);
    // Until the worker has answered, the surface has the values of something else.
    const values = Float32Array.of(1);
    const old = { wish: /** @type {any} */ (sent[0].wish), values };
    const late = withView(shown, { surface: { .../** @type {any} */ (shown.view.surface), computed: old } });
    expect(computedValues(late)).toBe(values);
    expect(computedValues(run(late, { type: 'settingsChanged', change: { functional: 'bending' } }))).toBeNull();
  });

  test('once in each run to say where it began, when that is shown', () => {
    const shown = run(resting(), ...[true, false, true].map(showsOriginal));
    expect(sent).toEqual([{ type: 'recall', run: 1 }]);
    const recalled = run(shown, answered({ type: 'recalled', run: 1, limit: mesh(), density: 1, cage: mesh() }));
    expect(recalled.view.start).toMatchObject({ run: 1, cage: mesh() });
    const next = run(recalled, { type: 'generatorChanged', change: { name: 'cube' } });
    expect(types()).toEqual(['recall', 'open']); // not while it opens
    run(next, ...openedMessages(2));
    expect(sent.at(-1)).toEqual({ type: 'recall', run: 2 });
    sent = [];
    run(
      resting(),
      ...[true, false, true].map((before) => /** @type {Action} */ ({ type: 'viewChanged', change: { before } })),
    );
    expect(sent).toEqual([{ type: 'recall', run: 1 }]);
  });

  test('to open the first cage', () => {
    const state = initialState();
    effects(null, null, state);
    expect(sent).toEqual([
      {
        type: 'open',
        run: 1,
        problem: {
          cage: { generator: 'two-3', family: 'flag', thickness: 1 },
          terms: { mvs_cross: 1 },
          options: {
            cap: 'smooth',
            cap_rings: 4,
            symmetry: true,
            levels: [0, 2],
            tolerance: 1e-6,
            max_iterations: 1000,
          },
        },
      },
    ]);
  });

  test('to go on with a coarse surface once it has been drawn, and nothing after other pictures', () => {
    const surfaced = {
      type: /** @type {const} */ ('surfaced'),
      run: 1,
      evaluations: 0,
      patches: 24,
      limit: mesh(),
      density: 1,
      control: mesh(),
    };
    const coarse = run(resting(), answered({ ...surfaced, coarse: true }), { type: 'surfaceDrawn' });
    expect(sent).toEqual([{ type: 'detail', run: 1 }]);
    run(coarse, { type: 'surfaceDrawn' }, answered(surfaced), { type: 'surfaceDrawn' });
    expect(sent).toHaveLength(1);
  });

  test('to optimize, pause, step and cancel the run that is open', () => {
    run(
      resting(),
      { type: 'startPressed' },
      { type: 'pausePressed' },
      { type: 'pausePressed' },
      { type: 'cancelPressed' },
    );
    expect(types()).toEqual(['optimize', 'pause', 'cancel']);
    run(resting(), { type: 'stepPressed' });
    expect(sent.at(-1)).toEqual({ type: 'step', run: 1 });
  });

  test('to open and to go on at once, when a run or a step starts anew', () => {
    run(ended(), { type: 'startPressed' });
    expect(sent).toEqual([expect.objectContaining({ type: 'open', run: 2, then: 'run' })]);
    run(ended(), { type: 'stepPressed' });
    expect(sent.slice(1)).toEqual([expect.objectContaining({ type: 'open', run: 2, then: 'step' })]);
  });

  test('which run to expect, once the minimizer that can be minimized again has been drawn', () => {
    const rested = ended();
    const entry = /** @type {any} */ ({});
    const settings = { ...rested.document.settings, functional: /** @type {const} */ ('willmore') };
    const shown = withView(withDocument(rested, { minimizer: { entry, settings } }), { coarse: true });
    const state = run(shown, { type: 'surfaceDrawn' });
    expect(types()).toEqual(['detail', 'expect']);
    run(state, { type: 'againPressed' });
    const [, { problem }, again] = sent;
    expect(problem.terms).toEqual({ willmore: 1 });
    expect(again).toEqual({ type: 'open', run: 2, problem, then: 'run' });
  });

  test('to run what it is still opening', () => {
    const state = run(resting(), { type: 'settingsChanged', change: { cap: 'flat' } }, { type: 'startPressed' });
    expect(types()).toEqual(['open', 'optimize']);
    run(state, ...openedMessages(2));
    expect(types()).toEqual(['open', 'optimize']);
  });

  test('to certify the surface that a run has ended with, once, and to abandon that once', () => {
    run(ended(), { type: 'certifyPressed' }, { type: 'certifyPressed' });
    expect(sent).toEqual([{ type: 'certify', run: 1 }]);
    run(
      ended(),
      { type: 'certificateCancelPressed' },
      { type: 'certifyPressed' },
      { type: 'certificateCancelPressed' },
      { type: 'certificateCancelPressed' },
    );
    expect(types()).toEqual(['certify', 'certify', 'abandonCertificate']);
    run(running(), { type: 'certifyPressed' });
    expect(sent).toHaveLength(3);
  });

  test('nothing by what only changes the view', () => {
    run(
      running(),
      { type: 'viewChanged', change: { shading: 'gaussian' } },
      { type: 'fitPressed' },
      { type: 'alertDismissed' },
    );
    expect(sent).toEqual([]);
  });

  test('nothing when a file is being opened and the user gives up: it is replaced', () => {
    run(resting(), { type: 'fileChosen', name: 'huge.obj', text: new Uint8Array(1) }, { type: 'cancelPressed' });
    expect(types()).toEqual(['open']);
    expect(abandoned).toBe(1);
  });
});

describe('another try', () => {
  test('starts the worker anew that could not be loaded, and then opens what was to be opened', () => {
    const lost = run(resting(), { type: 'workerLost', loss: 'unloadable', detail: '' });
    expect([restarted, types()]).toEqual([0, []]);
    run(lost, { type: 'retryPressed' });
    expect([restarted, types()]).toEqual([1, ['open']]);
  });

  test('loads the entry of the catalog again that was not loaded, instead of the cage in its place', () => {
    const name = /** @type {const} */ ({ shape: 'two-3', functional: 'mvs' });
    const begun = initialState('system', parseStudioAddress('?shape=two-3&functional=mvs'));
    effects(null, null, begun);
    const { wanted } = begun.session;
    if (!wanted) throw new Error('no entry is wanted');
    const failed = run(begun, { type: 'entryMissing', name: wanted, message: 'no network', retry: true });
    expect(failed.view.alert).toMatchObject({ message: 'no network', retry: name });
    const again = run(failed, { type: 'retryPressed' });
    expect(again.session).toMatchObject({ wanted: name, opening: null });
    expect(loads).toEqual([name, name]);
  });
});

describe('a download', () => {
  test.each(
    /** @type {Array<['control' | 'quads' | 'limit' | 'ply' | 'stl' | 'glb' | 'report' | 'problem', string, string]>} */ ([
      ['control', 'two-3-mvs_cross-level2.obj', 'model/obj'],
      ['quads', 'two-3-mvs_cross-level2-refined2.obj', 'model/obj'],
      ['limit', 'two-3-mvs_cross-level2-limit.obj', 'model/obj'],
      ['ply', 'two-3-mvs_cross-level2-limit.ply', 'application/octet-stream'],
      ['stl', 'two-3-mvs_cross-level2-limit.stl', 'model/stl'],
      ['glb', 'two-3-mvs_cross-level2-limit.glb', 'model/gltf-binary'],
      ['report', 'two-3-mvs_cross.json', 'application/json'],
      ['problem', 'two-3-mvs_cross-problem.json', 'application/json'],
    ]),
  )('of the %s is asked of the worker, and saved under a name that says what it is', (what, name, type) => {
    const options = { steps: 2 };
    const state = run(ended(), { type: 'downloadPressed', what, options });
    expect(sent).toEqual([{ type: 'export', run: 1, what, options }]);
    expect(state.session.exporting).toBe(true);
    const done = run(state, answered({ type: 'exported', run: 1, what, options, content: 'its text' }));
    expect(saved).toEqual([[name, 'its text', type]]);
    expect(done.session.exporting).toBe(false);
  });

  test('of the history has a line with all digits for each evaluation, and needs no worker', () => {
    const state = run(ended(), { type: 'downloadPressed', what: 'history' });
    expect([sent, state.session.exporting]).toEqual([[], false]);
    const [[name, text, type]] = saved;
    expect([name, type]).toEqual(['two-3-mvs_cross-history.csv', 'text/csv;charset=utf-8']);
    const lines = String(text).split('\r\n');
    expect(lines.slice(0, 4)).toEqual([
      'evaluation,level,energy,gradient_norm',
      '1,0,150,10',
      '2,0,149,5',
      '3,0,148,3.3333333333333335',
    ]);
    expect(lines).toHaveLength(7);
  });

  test('of a picture waits for it, and says why there is none', () => {
    const options = { size: /** @type {[number, number]} */ ([640, 480]), background: true };
    const state = run(ended(), { type: 'downloadPressed', what: 'picture', options });
    expect([pictures, sent, state.session.exporting]).toEqual([[options], [], true]);
    expect(fileName(state, 'picture', options)).toBe('two-3-mvs_cross-level2-mean-640x480.png');
    const failed = run(state, { type: 'pictureTaken', failure: 'not drawn' });
    expect(failed.session.exporting).toBe(false);
    expect(failed.view.alert?.message).toBe('not drawn');
    expect(run(state, { type: 'pictureTaken', failure: null }).view.alert).toBeNull();
  });

  test('before a run is named by the cage alone, and with colours by these too', () => {
    expect(fileName(resting(), 'control')).toBe('two-3-level0.obj');
    const colouring = { shading: /** @type {const} */ ('gaussian'), low: -1, high: 1 };
    expect(fileName(resting(), 'glb', { colouring })).toBe('two-3-level0-gaussian-limit.glb');
  });
});

describe('the address', () => {
  test('is set once for each view that has another one, and for nothing else', () => {
    let state = run(resting(), { type: 'viewChanged', change: { theme: 'dark' } });
    expect(addresses).toEqual(['?shape=two-3']);
    state = run(state, { type: 'viewChanged', change: { shading: 'gaussian' } }, { type: 'fitPressed' });
    state = run(state, { type: 'settingsChanged', change: { functional: 'bending' } });
    state = run(state, ...openedMessages(2), { type: 'startPressed' });
    run(state, {
      type: 'viewChanged',
      change: { camera: { azimuth: 10, elevation: 0, distance: 1.5, target: [0, 0, 0] } },
    });
    const shaded = '?shape=two-3&shading=gaussian';
    const asked = '?shape=two-3&functional=bending&start=cage&shading=gaussian';
    expect(addresses.slice(1)).toEqual([shaded, asked, `${asked}&camera=10,0,1.5`]);
  });

  test('that names an entry has it loaded once', () => {
    const state = initialState('system', parseStudioAddress('?shape=two-3&functional=mvs'));
    effects(null, null, state);
    run(state, { type: 'viewChanged', change: { shading: 'kappa1' } });
    expect(loads).toEqual([{ shape: 'two-3', functional: 'mvs' }]);
    expect(sent).toEqual([]);
    expect(addresses.at(-1)).toBe('?shape=two-3&functional=mvs&shading=kappa1');
  });
});
