// SPDX-License-Identifier: MIT
/**
 * @file The surfaces side by side, each below the menus that choose it, on one canvas with one camera.
 */
import { FEWEST, MOST, entryName } from '../../../address/compare.js';
import { patternOf, quantityOf } from '../../../colour/quantities.js';
import { catalogAddress } from '../../../files/catalog.js';
import { drawing } from '../../../scene/drawing.js';
import { createPanes } from '../../../scene/panes.js';
import { element, find, setEnabled, setText, whenChanged } from '../../../views/dom.js';
import { listenToKeys } from '../../../views/keys.js';
import { columnWords, shapeTitle } from '../../../words/entries.js';
import { functionalsOf } from '../reduce.js';

/** @import {Camera} from '../../../address/camera.js' */
/** @import {EntryName} from '../../../address/compare.js' */
/** @import {Pattern, Quantity} from '../../../colour/quantities.js' */
/** @import {Range} from '../../../colour/range.js' */
/** @import {Catalog} from '../../../files/catalog.js' */
/** @import {Action, State} from '../types.js' */

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createPanesView(root, dispatch) {
  const listening = new AbortController();
  const { signal } = listening;
  const canvas = /** @type {HTMLCanvasElement} */ (find(root, 'canvas'));
  const calm = matchMedia('(prefers-reduced-motion: reduce)').matches;
  const speed = drawing();
  /** @param {Camera} camera */
  const rested = (camera) => dispatch({ type: 'cameraMoved', camera });
  const scene = speed === 'never' ? null : createPanes(canvas, { calm, slow: speed === 'slow', rested });
  canvas.hidden = !scene;
  root.classList.toggle('pictures', !scene);
  listenToKeys(canvas, scene?.controls, () => dispatch({ type: 'fitPressed' }), signal);
  const panes = Array.from({ length: MOST }, (_, index) => createPane(index, dispatch, !scene));
  root.prepend(...panes.map((pane) => pane.figure));

  const setCamera = whenChanged((/** @type {Camera} */ camera) => scene?.setCamera(camera));
  const setSurfaces = whenChanged((/** @type {EntryName[]} */ entries, /** @type {State['surfaces']} */ surfaces) => {
    root.style.setProperty('--count', String(entries.length));
    root.dataset.count = String(entries.length);
    scene?.setPanes(
      entries.map((entry, i) => {
        const shown = surfaces[entryName(entry)];
        return { mesh: shown && !('problem' in shown) ? shown : null, place: panes[i].place };
      }),
    );
  });
  const shade = whenChanged(
    (
      /** @type {Quantity | null} */ quantity,
      /** @type {Range | null} */ range,
      /** @type {Pattern | null} */ pattern,
    ) => scene?.shade({ quantity, range, pattern }),
  );
  const fit = whenChanged((/** @type {number} */ fits) => fits && scene?.fit());

  return {
    /** Whether surfaces can be drawn. */
    draws: Boolean(scene),

    /** @param {State} state @param {Range | null} range of the quantity that the surfaces are shaded by */
    update(state, range) {
      panes.forEach((pane, i) => pane.update(state, state.entries[i] ?? null));
      setCamera(state.camera);
      setSurfaces(state.entries, state.surfaces);
      shade(quantityOf(state.shading), range, patternOf(state.shading));
      fit(state.fits);
    },

    dispose() {
      listening.abort();
      scene?.dispose();
      panes.forEach((pane) => pane.dispose());
    },
  };
}

/**
 * One surface's menus, and its place on the canvas.
 * @param {number} index
 * @param {(action: Action) => void} dispatch
 * @param {boolean} pictures whether it shows the catalog's picture, because the browser cannot draw the surface
 */
function createPane(index, dispatch, pictures) {
  const listening = new AbortController();
  const { signal } = listening;
  const shape = element('select', { 'aria-label': `Shape ${index + 1}` });
  const functional = element('select', { 'aria-label': `Functional ${index + 1}` });
  const remove = element('button', { type: 'button', class: 'quiet', 'aria-label': `Remove ${index + 1}` }, '✕');
  const words = element('p', { class: 'note' });
  const picture = element('img', { alt: '', loading: 'lazy', hidden: '' });
  const place = element('div', { class: 'place' }, picture, words);
  const figure = element(
    'figure',
    { class: 'pane' },
    element('figcaption', {}, element('div', {}, shape, remove), functional),
    place,
  );
  shape.addEventListener('change', () => dispatch({ type: 'entryChosen', index, change: { shape: shape.value } }), {
    signal,
  });
  functional.addEventListener(
    'change',
    () => dispatch({ type: 'entryChosen', index, change: { functional: functional.value } }),
    { signal },
  );
  remove.addEventListener('click', () => dispatch({ type: 'entryRemoved', index }), { signal });
  picture.addEventListener('error', () => (picture.hidden = true), { signal });

  const fillShapes = whenChanged((/** @type {Catalog} */ { shapes }) => {
    shape.replaceChildren(...shapes.map(({ name }) => element('option', { value: name }, shapeTitle(name))));
  });
  const fillFunctionals = whenChanged((/** @type {Catalog} */ catalog, /** @type {string} */ name) => {
    functional.replaceChildren(
      ...functionalsOf(catalog, name).map((column) =>
        element('option', { value: column.name }, columnWords(column).name),
      ),
    );
  });
  const showPicture = whenChanged((/** @type {string} */ name) => {
    picture.hidden = false;
    picture.src = catalogAddress(`pictures/${name}.webp`);
  });

  return {
    figure,
    place,
    /** @param {State} state @param {EntryName | null} entry */
    update({ catalog, entries, surfaces }, entry) {
      figure.hidden = !entry;
      if (!entry) return;
      if (catalog) {
        fillShapes(catalog);
        fillFunctionals(catalog, entry.shape);
      }
      shape.value = entry.shape;
      functional.value = entry.functional;
      setEnabled(remove, entries.length > FEWEST);
      const shown = surfaces[entryName(entry)];
      const problem = shown && 'problem' in shown ? shown.problem : '';
      setText(words, problem || (shown || pictures ? '' : 'Loading …'));
      if (pictures) showPicture(entryName(entry));
    },
    dispose() {
      listening.abort();
      figure.remove();
    },
  };
}
