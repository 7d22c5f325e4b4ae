// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { afterEach, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { setLanguage } from './catalogue.js';
import { coreWords } from './core_words.js';
import { findingWords, suggestedUnits } from './finding_words.js';
import { findings } from './parts/findings.js';
import { kPatterns } from './parts/core.js';

const root = fileURLToPath(new URL('../..', import.meta.url));

afterEach(() => setLanguage('en'));

/** Every source of these folders as one text, with string literals that follow each other joined. @param {string[]} folders */
function sources(folders) {
  const files = folders.flatMap((folder) => readdirSync(`${root}${folder}`, { recursive: true, encoding: 'utf8' })
    .filter((name) => /\.(cpp|h|js)$/.test(name) && !name.includes('test'))
    .map((name) => readFileSync(`${root}${folder}/${name}`, 'utf8')));
  return files.join('\n').replace(/"\s*\n\s*"/g, '').replaceAll("'s ", '’s ').replaceAll('`', '').replaceAll('\\"', '"');
}

test('Every sentence that is translated is still said by the core or the engine', () => {
  const said = sources(['core', 'wasm', 'web/engine']);
  const kTelling = 9;  // shorter pieces between two values say little
  const pieces = /\{\d\}| takes a code| of | mm|°|[;:,] | with its quiet zone| at the best| at this| or a module| a module/;  // some are put together
  const stale = kPatterns.filter((pattern) => pattern.split(pieces).some((piece) => piece.length >= kTelling && !said.includes(piece)));
  assert.deepEqual(stale, []);
});

test('A sentence with values is said in German, with a decimal comma', () => {
  setLanguage('de');
  assert.equal(coreWords('Only a code of 7.3 mm fits here: its modules would be 0.29 mm wide'),
    'Hier passt nur ein Code von 7,3 mm: seine Module wären 0,29 mm breit');
});

test('Where the core speaks of the command, the page speaks of its controls', () => {
  assert.equal(coreWords('Choose a thicker spot, or engrave with --min-wall 0.8'), 'Choose a thicker spot, or set “Wall left” to 0.8');
  for (const pattern of kPatterns.filter((one) => one.includes('--'))) {
    for (const language of /** @type {const} */ (['en', 'de'])) {
      setLanguage(language);
      assert.doesNotMatch(coreWords(pattern), / --|\(--/, pattern);
    }
  }
});

test('What is not known stays as it is', () => {
  setLanguage('de');
  assert.equal(coreWords('The moon is full'), 'The moon is full');
});

test('Every finding about a model has words of the page, without the command’s options', () => {
  const said = sources(['core/mesh']);
  const codes = [...said.matchAll(/findings\.(?:note|warn|block)\(\s*"([a-z-]+)"|\ballowed, "([a-z-]+)"/g)].map(([, a, b]) => a ?? b);
  assert.ok(codes.length >= 18, `found only ${codes.length} codes: the sources are written differently now`);
  const known = /** @type {Record<string, unknown>} */ (findings.en);
  assert.deepEqual(codes.filter((code) => known[code] === undefined), []);
  assert.doesNotMatch(JSON.stringify(findings), /--[a-z]/);
});

test('A finding keeps its number and its place', () => {
  const finding = /** @type {const} */ ({ severity: 'blocking', code: 'open-edges', count: 3, hint: '',
    message: 'The surface is not closed: 3 open edges around 1 hole or gap, one at (1.5, -2, 3), of facet 7' });
  assert.equal(findingWords(finding).message, 'The surface is not closed: 3 open edges, one at (1.5, -2, 3)');
  setLanguage('de');
  assert.equal(findingWords(finding).message, 'Die Oberfläche ist nicht geschlossen: 3 offene Kanten, eine bei (1.5, -2, 3)');
});

test('A tiny model comes with the units that would make it printable', () => {
  const tiny = /** @type {const} */ ({ severity: 'warning', code: 'tiny', count: 1, message: 'The model is tiny: 0.1 x 0.1 x 0.05 mm',
    hint: 'In metres, it is 100 x 100 x 50 mm: --units m; in inches, it is 2.54 x 2.54 x 1.27 mm: --units in; or use --scale' });
  assert.deepEqual(suggestedUnits(tiny), [{ unit: 'm', size: '100 × 100 × 50 mm' }, { unit: 'in', size: '2.54 × 2.54 × 1.27 mm' }]);
  assert.equal(findingWords(tiny).message, 'The model is tiny: 0.1 × 0.1 × 0.05 mm');
});
