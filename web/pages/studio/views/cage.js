// SPDX-License-Identifier: MIT
/**
 * @file The cage panel: the generated shapes with their family and thickness, the button to open a file, and facts
 * and repairs of the open cage.
 */
import { cageWords } from '../../../words/cages.js';
import { integer } from '../../../words/numbers.js';
import { repairWords } from '../../../words/results.js';
import { createLines, element, find, setText, whenChanged } from '../../../views/dom.js';
import { termButton } from '../../../views/glossary.js';

/** @import {CageReport} from '../../../../wasm/types.js' */
/** @import {Action, Generator, OpenCage, Result, State} from '../state/types.js' */

/** The menu's entry for a cage from a file. */
const FILE = 'file';

/** A shape's text in the menu: "Two junctions, 3 arms · genus 2". @param {string} name */
function entryText(name) {
  const { title, genus } = cageWords(name);
  return genus === null ? title : `${title} · genus ${genus}`;
}

/** Facts that the glossary explains. @type {Record<string, string>} */
const terms = { Genus: 'genus', Boundaries: 'boundary' };

/** @param {string} fact */
const named = (fact) => (fact in terms ? [termButton(terms[fact], fact)] : [fact]);

/** @param {OpenCage} cage @param {CageReport} counts of what is open or was filled @returns {Array<[string, string]>} */
function facts({ source, name }, counts) {
  return [
    .../** @type {Array<[string, string]>} */ (source.kind === 'text' ? [['File', name]] : []),
    ['Vertices', integer(counts.vertices)],
    ['Edges', integer(counts.edges)],
    ['Faces', integer(counts.faces)],
    ['Genus', integer(counts.genus)],
    ['Components', integer(counts.components.length)],
    .../** @type {Array<[string, string]>} */ (
      counts.boundaries.length > 0 ? [['Boundaries', integer(counts.boundaries.length)]] : []
    ),
  ];
}

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 * @param {(files: File[]) => void} takeFiles
 */
export function createCageView(root, dispatch, takeFiles) {
  const listening = new AbortController();
  const { signal } = listening;
  const shape = /** @type {HTMLSelectElement} */ (find(root, '[name=shape]'));
  const file = /** @type {HTMLInputElement} */ (find(root, '#file'));
  const thickness = /** @type {HTMLInputElement} */ (find(root, '[name=thickness]'));
  const thicknessValue = find(root, '#thickness-value');
  const families = /** @type {HTMLInputElement[]} */ ([...root.querySelectorAll('[name=family]')]);
  const frameOptions = find(root, '.frame-options');
  const list = find(root, '.facts');
  const showRepairs = createLines(find(root, '.repairs'));

  shape.addEventListener(
    'change',
    () => shape.value !== FILE && dispatch({ type: 'generatorChanged', change: { name: shape.value } }),
    { signal },
  );
  find(root, '#choose-file').addEventListener('click', () => file.click(), { signal });
  file.addEventListener(
    'change',
    () => {
      takeFiles([...(file.files ?? [])]);
      file.value = ''; // so that the same file can be chosen again
    },
    { signal },
  );
  for (const radio of families) {
    const family = radio.value === 'hub' ? 'hub' : 'flag';
    radio.addEventListener('change', () => dispatch({ type: 'generatorChanged', change: { family } }), { signal });
  }
  const showThickness = () => setText(thicknessValue, `× ${Number(thickness.value).toFixed(2)}`);
  thickness.addEventListener('input', showThickness, { signal });
  thickness.addEventListener(
    'change',
    () => dispatch({ type: 'generatorChanged', change: { thickness: Number(thickness.value) } }),
    { signal },
  );

  const showNames = whenChanged((/** @type {string[]} */ names) => {
    shape.replaceChildren(...names.map((name) => element('option', { value: name }, entryText(name))));
  });

  const showCage = whenChanged(
    (
      /** @type {OpenCage | null} */ cage,
      /** @type {Result['taken']} */ taken,
      /** @type {string[]} */ names,
      /** @type {Generator} */ generator,
    ) => {
      const fromFile = cage?.source.kind === 'text';
      shape.querySelector(`[value=${FILE}]`)?.remove();
      if (cage && fromFile) shape.prepend(element('option', { value: FILE }, cage.name));
      // A problem's file may name a cage that the menu does not offer, such as an open one.
      const { name } = generator;
      const known = fromFile || [...shape.options].some(({ value }) => value === name);
      if (!known) shape.append(element('option', { value: name }, entryText(name)));
      shape.value = fromFile ? FILE : name;
      frameOptions.hidden = fromFile || !cageWords(generator.name).frame;
      for (const radio of families) radio.checked = radio.value === generator.family;
      thickness.value = String(generator.thickness);
      showThickness();
      list.replaceChildren(
        ...(cage ? facts(cage, (taken ?? cage).counts) : []).map(([term, value]) =>
          element(
            'div',
            term === 'File' ? { class: 'name' } : {},
            element('dt', {}, ...named(term)),
            element('dd', {}, value),
          ),
        ),
      );
      showRepairs((cage ? repairWords((taken ?? cage).counts) : []).map((words) => ({ words })));
    },
  );

  return {
    /** @param {State} state */
    update({ document: { cage, result, generator }, session: { cageNames } }) {
      showNames(cageNames);
      showCage(cage, result.taken, cageNames, generator);
    },
    dispose: () => listening.abort(),
  };
}
