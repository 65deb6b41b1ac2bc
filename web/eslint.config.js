// SPDX-License-Identifier: MIT
/**
 * @file ESLint's rules for all JavaScript of the project; run from the root with `--config web/eslint.config.js`.
 */
import js from '@eslint/js';
import { defineConfig, globalIgnores } from 'eslint/config';
import globals from 'globals';

export default defineConfig([
  globalIgnores(['build/', 'node_modules/']),
  js.configs.recommended,
  {
    linterOptions: { reportUnusedDisableDirectives: 'error' },
    rules: {
      'array-callback-return': 'error',
      eqeqeq: ['error', 'always', { null: 'ignore' }],
      'no-constructor-return': 'error',
      'no-implicit-coercion': ['error', { boolean: false }],
      'no-promise-executor-return': 'error',
      'no-self-compare': 'error',
      'no-unused-expressions': 'error',
      'no-unused-vars': ['error', { args: 'none' }],
      'no-use-before-define': ['error', { functions: false, classes: false, variables: false }],
      'no-var': 'error',
      'object-shorthand': 'error',
      'prefer-const': 'error',
    },
  },
  { files: ['web/**/*.js'], ignores: ['web/*.config.js'], languageOptions: { globals: globals.browser } },
  { files: ['web/*.config.js', 'tests/**/*.js'], languageOptions: { globals: globals.node } },
  // Functions that browser tests and `npm run pictures` pass to the page run in the browser.
  {
    files: ['tests/browser/**/*.js', 'tests/web/**/*.js', 'tests/run/pictures/*.js'],
    languageOptions: { globals: globals.browser },
  },
  { files: ['wasm/**/*.js'], languageOptions: { globals: { ...globals['shared-node-browser'], process: 'readonly' } } },
  { files: ['wasm/{loading,thread}.js'], languageOptions: { globals: globals.worker } },
]);
