// SPDX-License-Identifier: MIT
/**
 * @file What the keys do, in words, for the list of keys.
 */

/** Keys that are pressed together, joined by +; each alternative does the same. @typedef {{keys: string[], words: string}} KeyWords */
/** @typedef {{title: string, keys: KeyWords[]}} KeyGroup */

/** @type {KeyGroup} */
const everywhere = {
  title: 'On every page',
  keys: [
    { keys: ['?'], words: 'This list' },
    { keys: ['G'], words: 'What the terms mean' },
    { keys: ['Tab', 'Shift+Tab'], words: 'To the next control, and back; first of all past the header' },
    { keys: ['Enter', 'Space'], words: 'Press a button that has the focus' },
    { keys: ['Esc'], words: 'Close a dialog' },
  ],
};

/** @type {KeyGroup} */
const picture = {
  title: 'On the picture',
  keys: [
    { keys: ['←', '→', '↑', '↓'], words: 'Turn' },
    { keys: ['+', '−'], words: 'Zoom in and out' },
    { keys: ['F'], words: 'Fit to the view' },
  ],
};

/** The keys of each page. @type {Record<'catalog' | 'compare' | 'torus' | 'studio' | 'methods', KeyGroup[]>} */
export const keyGroups = {
  catalog: [everywhere],
  methods: [everywhere],
  compare: [everywhere, picture],
  torus: [
    everywhere,
    picture,
    { title: 'On the plot of energies', keys: [{ keys: ['←', '→'], words: 'Read the next ratio of radii' }] },
  ],
  studio: [
    everywhere,
    {
      title: 'In the studio',
      keys: [
        { keys: ['Ctrl+Z'], words: 'Undo' },
        { keys: ['Shift+Ctrl+Z', 'Ctrl+Y'], words: 'Redo' },
        { keys: ['Ctrl+S'], words: 'Save the project' },
        { keys: ['Ctrl+V'], words: 'Open pasted OBJ, OFF or PLY, a report or a project' },
      ],
    },
    picture,
    {
      title: 'On the triangle of a blend',
      keys: [
        { keys: ['←', '→', '↑', '↓'], words: 'Move the point; further with Shift' },
        { keys: ['1', '2', '3'], words: 'To the top, the left and the right corner' },
        { keys: ['0'], words: 'To the middle' },
      ],
    },
  ],
};
