// SPDX-License-Identifier: MIT
/**
 * @file Menus that open over the picture: Escape and a press elsewhere close them, and of several one is open.
 */

/** @param {HTMLElement} root contains the menus, `details` elements of the class `menu` */
export function createMenus(root) {
  const listening = new AbortController();
  const { signal } = listening;
  const menus = [...root.querySelectorAll('details.menu')].map((menu) => /** @type {HTMLDetailsElement} */ (menu));

  /** @param {EventTarget | null} target */
  function closeOthers(target) {
    for (const menu of menus) if (menu.open && !(target instanceof Node && menu.contains(target))) menu.open = false;
  }

  /** @param {KeyboardEvent} event */
  function escape({ key }) {
    const open = menus.find((menu) => menu.open);
    if (key !== 'Escape' || !open) return;
    if (open.contains(document.activeElement)) open.querySelector('summary')?.focus();
    open.open = false;
  }

  document.addEventListener('pointerdown', ({ target }) => closeOthers(target), { signal, capture: true });
  document.addEventListener('keydown', escape, { signal });
  for (const menu of menus) menu.addEventListener('toggle', () => menu.open && closeOthers(menu), { signal });
  return { dispose: () => listening.abort() };
}
