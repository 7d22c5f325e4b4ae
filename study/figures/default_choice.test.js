// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { betterThanDefault, choicesOf, defaultChoice, kChosenBy } from './default_choice.js';

const kOurs = { module_mm: 1, modules: 'thick-plus', finders: 'none', contrast: 0.27 };
const row = (/** @type {object} */ change) => ({
  model: 'vase',
  module_mm: 1,
  pose: 'code-up',
  modules: 'thick-plus',
  finders: 'none',
  contrast: 0.27,
  max_depth_modules: 4,
  broken_up: 'no',
  depth_mm: 0.6,
  depth_max_mm: 2,
  printed: 40,
  ...change,
});

test('choices are means, and the program’s own is known by all its settings', () => {
  const choices = choicesOf(
    [row({}), row({ pose: 'slanted', printed: 50 }), row({ broken_up: 'yes', printed: 60 })],
    kOurs,
  );
  assert.deepEqual(
    choices.map(({ printed, isDefault }) => [printed, isDefault]),
    [
      [45, true],
      [60, false],
    ],
  );
});

test('a choice is better where it reads more at no more depth', () => {
  const better = (/** @type {object} */ other) =>
    betterThanDefault(choicesOf([row({}), row({ contrast: 0.3, ...other })], kOurs))?.length;
  assert.equal(better({ printed: 41 }), 1);
  assert.equal(better({ printed: 40, depth_mm: 0.5 }), 0);
  assert.equal(better({ printed: 60, depth_mm: 0.7 }), 0);
  assert.equal(betterThanDefault(choicesOf([row({ contrast: 0.3 })], kOurs)), undefined);
});

test('what reads more often than the default is named, and nothing is said without the default', () => {
  const diamond = row({ modules: 'diamond', finders: 'thick-plus-sharp', contrast: 0.4, printed: 50 });
  const say = (/** @type {object[]} */ rows) =>
    defaultChoice.find(rows, { default_settings: [kOurs] }).map((one) => one.say);
  assert.deepEqual(say([row({}), row({ model: 'plate' }), diamond]), [
    'choiceReads',
    'choiceFrontier',
    'choiceOthers',
    'choiceBetter',
    'choiceWhy',
  ]);
  assert.deepEqual(say([row({}), row({ model: 'plate' })]), ['choiceReads', 'choiceFrontier']);
  assert.deepEqual(say([diamond]), []);
});

test('the halves of the models are those of the experiment', () => {
  const header = readFileSync(new URL('../experiments/chosen_settings.h', import.meta.url), 'utf8');
  assert.equal(/kModelsToChooseBy = \{([^}]*)\}/.exec(header)?.[1], kChosenBy.map((model) => `"${model}"`).join(', '));
  const defaults = readFileSync(new URL('../../core/pipeline/default_patterns.h', import.meta.url), 'utf8');
  assert.match(defaults, /kMaxDepthModules = 4;/);
});
