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

  document.addEventListener('pointerdown', ({ target }) => closeOthers(target), { signal, capture: true });
  for (const menu of menus) {
    menu.addEventListener('toggle', () => menu.open && closeOthers(menu), { signal });
    menu.addEventListener(
      'keydown',
      (event) => {
        if (event.key !== 'Escape' || !menu.open) return;
        menu.open = false;
        menu.querySelector('summary')?.focus();
      },
      { signal },
    );
  }
  return { dispose: () => listening.abort() };
}
