// SPDX-License-Identifier: GPL-3.0-or-later
import js from '@eslint/js';
import globals from 'globals';
import { messageRule, readMessages, valuesByCode } from './script/message_rule.js';

/** Rules in addition to the recommended ones. None concerns layout, and tsc finds type errors (`npm run check`). */
const kRules = {
  'array-callback-return': 'error',
  'consistent-return': 'error',
  'default-case-last': 'error',
  eqeqeq: 'error',
  'no-console': 'error',
  'no-else-return': 'error',
  'no-implicit-globals': 'error',
  'no-throw-literal': 'error',
  'no-unused-vars': ['error', { ignoreRestSiblings: true }],
  'no-useless-rename': 'error',
  'no-var': 'error',
  'object-shorthand': 'error',
  'prefer-const': ['error', { destructuring: 'all' }],
};

/** Parts of web/ that run during the build. */
const kAtBuild = ['web/offline/build_plugin.js', 'web/samples/*.js', 'web/i18n/fill.js', 'web/npm/build.js'];

/** Files run at a terminal, and tests that print measurements. */
const kOnTerminal = [
  'bench/**/*.mjs',
  'study/**/*.mjs',
  'script/cmake/*.js',
  'e2e/**/*.js',
  'wasm/**/*.js',
  'web/samples/generate.js',
  'web/npm/build.js',
  'examples/**/*.js',
  '*.js',
];

export default [
  { ignores: ['build/', 'dist/', 'e2e/results/'] },
  {
    files: ['**/*.js', '**/*.mjs'],
    linterOptions: { reportUnusedDisableDirectives: 'error' },
    languageOptions: { ecmaVersion: 'latest', sourceType: 'module' },
    rules: { ...js.configs.recommended.rules, ...kRules },
  },
  { files: ['web/**/*.js', 'public/**/*.js'], languageOptions: { globals: globals.browser } },
  // Classic scripts: their declarations are visible to every other script of the page.
  { files: ['public/**/*.js'], languageOptions: { sourceType: 'script' } },
  { files: ['web/offline/service_worker.js'], languageOptions: { globals: globals.serviceworker } },
  // Code that e2e hands to the browser is in the same files as code for Node.
  { files: ['e2e/**/*.js', 'examples/**/*.js'], languageOptions: { globals: { ...globals.node, ...globals.browser } } },
  {
    files: [
      'bench/**/*.mjs',
      'study/**/*.mjs',
      'study/**/*.js',
      'script/**/*.js',
      'wasm/**/*.js',
      '*.js',
      '**/*.test.js',
      'web/session/testing.js',
      ...kAtBuild,
    ],
    languageOptions: { globals: globals.node },
  },
  // The page writes only faults of the program to the console, for developers.
  { files: ['web/**/*.js'], rules: { 'no-console': ['error', { allow: ['warn', 'error'] }] } },
  {
    files: ['web/**/*.js'],
    ignores: ['**/*.test.js'],
    plugins: { qrelief: { rules: { message: messageRule(valuesByCode(readMessages())) } } },
    rules: { 'qrelief/message': 'error' },
  },
  { files: kOnTerminal, rules: { 'no-console': 'off' } },
];
