// SPDX-License-Identifier: MIT
/**
 * @file The downloads: what is saved, the options that it has, how large it will be, and one button.
 */
import { element, find, onPress, setEnabled, setText, whenChanged } from '../../../views/dom.js';
import { crossingsWords } from '../../../words/crossings.js';
import { fileSize, integer } from '../../../words/numbers.js';
import { crossingsKnown } from '../state/crossing.js';
import { wishOf } from '../state/wish.js';
import { canSave, choiceOf, downloadGroups, finenesses, sizeOf, usualFineness } from '../downloads.js';

/** @import {Range} from '../../../colour/range.js' */
/** @import {Action, Download, DownloadOptions, State} from '../state/types.js' */

/** @typedef {HTMLSelectElement} Select */

/** The pixels of a picture that is as large as the view on the screen. @param {Element} view @returns {[number, number]} */
function sizeOnScreen({ clientWidth, clientHeight }) {
  return [Math.round(clientWidth * devicePixelRatio), Math.round(clientHeight * devicePixelRatio)];
}

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 * @param {Element} picture the view that a picture is taken of
 */
export function createDownloadsView(root, dispatch, picture) {
  const listening = new AbortController();
  const { signal } = listening;
  /** @param {string} name */
  const select = (name) => /** @type {Select} */ (find(root, `select[name=${name}]`));
  const [what, density, steps, size, pixels, background] = [
    'what',
    'density',
    'steps',
    'size',
    'pixels',
    'background',
  ].map(select);
  const extent = /** @type {HTMLInputElement} */ (find(root, 'input[name=extent]'));
  const words = find(root, '#download-words');
  const printing = find(root, '#printing');
  const problem = find(root, '.problem');
  const save = /** @type {HTMLButtonElement} */ (find(root, '[name=save]'));
  what.append(
    ...downloadGroups.map(({ group, choices }) =>
      element('optgroup', { label: group }, ...choices.map((one) => element('option', { value: one.what }, one.name))),
    ),
  );
  /** @type {State | null} */
  let shown = null;
  /** @type {Range | null} */
  let range = null;
  /** Whether the user has chosen a density, which then stays while the surface has it. */
  let chosen = false;

  const chosenWhat = () => /** @type {Download} */ (what.value);

  const offer = whenChanged((/** @type {number} */ patches) => {
    const offered = finenesses(patches);
    const usual = usualFineness(offered);
    const kept = chosen && offered.some((one) => String(one.density) === density.value);
    const value = kept ? density.value : String(usual.density);
    density.replaceChildren(
      ...offered.map((one) => element('option', { value: String(one.density) }, integer(one.triangles))),
    );
    density.value = value;
  });

  /** @param {State} state @returns {DownloadOptions | null} null if the longest side is no length */
  function options(state) {
    const has = new Set(choiceOf(chosenWhat()).options);
    const scaled = has.has('extent') && size.value === 'extent';
    const side = scaled ? Number(extent.value.replace(',', '.') || NaN) : null;
    if (side !== null && !(side > 0)) return null;
    const coloured = chosenWhat() === 'glb' && range;
    return {
      ...(has.has('density') && { density: Number(density.value) }),
      ...(has.has('steps') && { steps: Number(steps.value) }),
      ...(has.has('extent') && { extent: side }),
      ...(chosenWhat() === 'glb' && {
        up: state.document.cage?.source.kind === 'generated' ? 'z' : 'y',
        name: state.document.cage?.name ?? '',
      }),
      ...(coloured && {
        colouring: { shading: state.view.shading, low: coloured.low, high: coloured.high, wish: wishOf(state) },
      }),
      ...(has.has('picture') && { size: pictureSize(), background: background.value === 'page' }),
    };
  }

  /** @returns {[number, number]} */
  function pictureSize() {
    const [width, height] = pixels.value.split('x').map(Number);
    return height ? [width, height] : sizeOnScreen(picture);
  }

  function show() {
    if (!shown) return;
    const choice = choiceOf(chosenWhat());
    for (const row of root.querySelectorAll('[data-option]')) {
      const option = row.getAttribute('data-option');
      /** @type {HTMLElement} */ (row).hidden = !choice.options.some((name) => name === option);
    }
    find(root, '.extent').hidden = size.value !== 'extent';
    const wanted = options(shown);
    const { surface } = shown.view;
    const counts = surface && { patches: surface.patches, vertices: surface.control.positions.length / 3 };
    const bytes = counts && wanted && sizeOf(choice.what, wanted, counts);
    setText(words, bytes ? `${choice.words} About ${fileSize(bytes)}.` : choice.words);
    tellPrinting(shown);
    setText(problem, wanted ? '' : 'The longest side is a number above 0.');
    setEnabled(save, wanted !== null && canSave(shown, choice.what));
    save.setAttribute('aria-busy', String(shown.session.exporting));
  }

  /** Says of a file for printing whether its surface can be printed. @param {State} state */
  function tellPrinting(state) {
    const prints = chosenWhat() === 'stl';
    printing.hidden = !prints;
    setText(printing, prints ? crossingsWords(crossingsKnown(state)) : '');
    if (prints !== state.view.printing) {
      queueMicrotask(() => dispatch({ type: 'viewChanged', change: { printing: prints } }));
    }
  }

  root.addEventListener(
    'input',
    ({ target }) => {
      if (target === density) chosen = true;
      show();
    },
    { signal },
  );
  onPress(
    save,
    () => {
      const wanted = shown && options(shown);
      if (wanted) dispatch({ type: 'downloadPressed', what: chosenWhat(), options: wanted });
    },
    signal,
  );

  return {
    /** @param {State} state @param {Range | null} shownRange of the quantity that colours the surface */
    update(state, shownRange) {
      shown = state;
      range = shownRange;
      if (state.view.surface) offer(state.view.surface.patches);
      show();
    },
    dispose: () => listening.abort(),
  };
}
