// SPDX-License-Identifier: MIT
/**
 * @file The page of methods' entry point: its text is there without it; the theme, the glossary and the list of keys are not.
 */
import { storeTheme, storedTheme } from './files/theme.js';
import { find } from './views/dom.js';
import { createGlossaryView } from './views/glossary.js';
import { createKeyListView } from './views/key_list.js';
import { createThemeView } from './views/theme.js';
import { keyGroups } from './words/keys.js';

createGlossaryView(find(document, '.top'));
createKeyListView(find(document, '.top'), keyGroups.methods);
const theme = createThemeView(find(document, '#theme'), (chosen) => {
  storeTheme(chosen);
  theme.update(chosen);
});
theme.update(storedTheme());
