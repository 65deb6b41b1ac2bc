// SPDX-License-Identifier: MIT
/**
 * @file The controls of the section, under the picture while it is shown, and what is said of it.
 */
import { find, setText } from '../../../views/dom.js';
import { sectionWords } from '../../../words/section.js';
import { turnedSection } from '../state/section.js';

/** @import {CutFound} from '../../../scene/section_lines.js' */
/** @import {Section, SectionAxis} from '../state/section.js' */
/** @import {Action, State} from '../state/types.js' */

/**
 * @param {HTMLElement} root has the switch, too
 * @param {(action: Action) => void} dispatch
 */
export function createSectionView(root, dispatch) {
  const listening = new AbortController();
  const { signal } = listening;
  /** @param {string} name */
  const input = (name) => /** @type {HTMLInputElement} */ (find(root, `[name=${name}]`));
  const [shown, position, comb, cut] = ['show-section', 'section-position', 'section-comb', 'section-cut'].map(input);
  const axes = [...root.querySelectorAll('[name=section-axis]')].map((one) => /** @type {HTMLInputElement} */ (one));
  const controls = find(root, '#section');
  /** @type {State | null} */
  let last = null;

  /** @param {Partial<Section>} change */
  function change(change) {
    if (last) dispatch({ type: 'viewChanged', change: { section: { ...last.view.section, ...change } } });
  }
  shown.addEventListener('change', () => change({ shown: shown.checked }), { signal });
  cut.addEventListener('change', () => change({ cut: cut.checked }), { signal });
  position.addEventListener('input', () => change({ position: Number(position.value) }), { signal });
  comb.addEventListener('input', () => change({ comb: Number(comb.value) }), { signal });
  for (const axis of axes) {
    // A click, as the camera's direction may be taken once more.
    axis.addEventListener('click', () => last && change(turnedSection(last, /** @type {SectionAxis} */ (axis.value))), {
      signal,
    });
  }

  return {
    /** @param {State} state */
    update(state) {
      last = state;
      const { section } = state.view;
      shown.checked = section.shown;
      cut.checked = section.cut;
      controls.hidden = !section.shown;
      position.value = String(section.position);
      comb.value = String(section.comb);
      for (const axis of axes) axis.checked = axis.value === section.axis;
    },
    /** Says what was cut. @param {CutFound | null} found */
    tell: (found) => setText(find(controls, '.note'), sectionWords(found)),
    dispose: () => listening.abort(),
  };
}
