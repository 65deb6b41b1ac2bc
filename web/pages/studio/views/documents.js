// SPDX-License-Identifier: MIT
/**
 * @file The documents that are open, as tabs: one is on the screen, others may run meanwhile.
 */
import { element, find, setText, whenChanged } from '../../../views/dom.js';
import { counted } from '../../../words/numbers.js';

/** @import {Tab} from '../desk.js' */

/** @param {number} count of documents in other tabs of the browser */
const elsewhereWords = (count) =>
  count ? `${counted(count, 'document')} ${count > 1 ? 'are' : 'is'} open in another tab of the browser.` : '';

/**
 * @typedef {object} Commands
 * @property {(id: string) => void} show
 * @property {(id: string) => void} close
 * @property {() => void} create
 * @property {() => void} reopen
 */

/**
 * @param {HTMLElement} root
 * @param {Commands} commands
 */
export function createDocumentsView(root, { show, close, create, reopen }) {
  const listening = new AbortController();
  const { signal } = listening;
  const list = find(root, 'ul');
  const again = find(root, '#reopen');
  const note = find(root, '[role=status]');
  find(root, '#new').addEventListener('click', create, { signal });
  again.addEventListener('click', reopen, { signal });

  /** @param {Tab} tab */
  function item({ id, name, running, active }) {
    const title = element('span', { class: 'name' }, name);
    const tab = element('button', { type: 'button', class: 'quiet', 'data-id': id, title: name }, title);
    if (active) tab.setAttribute('aria-current', 'true');
    if (running) tab.append(element('span', { class: 'runs' }, 'minimizing'));
    tab.addEventListener('click', () => show(id), { signal });
    const end = element('button', { type: 'button', class: 'quiet close', 'aria-label': `Close ${name}` }, '✕');
    end.addEventListener('click', () => close(id), { signal });
    return element('li', active ? { class: 'active' } : {}, tab, end);
  }

  const showTabs = whenChanged((/** @type {string} */ text) => {
    const { tabs } = /** @type {{tabs: Tab[]}} */ (JSON.parse(text));
    const focused = document.activeElement;
    const inside = focused instanceof HTMLElement && list.contains(focused);
    const place = inside ? focused.closest('li')?.querySelector('button')?.dataset.id : undefined;
    const closing = inside && focused.classList.contains('close');
    list.replaceChildren(...tabs.map(item));
    const active = /** @type {HTMLElement | null} */ (list.querySelector('.active'));
    if (active) list.scrollLeft = active.offsetLeft + active.offsetWidth - list.clientWidth;
    if (!inside) return;
    // The button that had the focus is another one now, or gone.
    const same = list.querySelector(`[data-id="${place}"]`);
    const next = (closing ? same?.nextElementSibling : same) ?? list.querySelector('[aria-current]');
    if (next instanceof HTMLElement) next.focus();
  });

  return {
    /**
     * @param {object} shown
     * @param {Tab[]} shown.tabs
     * @param {boolean} shown.canReopen
     * @param {string | null} shown.unkept why nothing is kept, or null
     * @param {number} shown.elsewhere how many documents other tabs of the browser have
     */
    update({ tabs, canReopen, unkept, elsewhere }) {
      showTabs(JSON.stringify({ tabs }));
      again.hidden = !canReopen;
      setText(
        note,
        unkept ? `This browser does not keep your work: ${unkept}. Save what you need.` : elsewhereWords(elsewhere),
      );
    },
    dispose: () => listening.abort(),
  };
}
