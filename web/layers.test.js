// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the layers of the page: the folders that a folder of web/ may import. Their order is defined here.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { posix } from 'node:path';
import { test } from 'node:test';

/** Lowest first: a folder imports, types included, only itself and the folders before it. */
const kLayers = [
  'generated', // the core's description of its settings
  'offline', // keeps the page for visits without a network
  'engine', // the engine, its worker and its answers
  'settings', // values of the settings
  'storage', // data that the browser keeps
  'i18n', // all texts, numbers and messages in all languages
  'dom', // elements and files, for all layers above
  'decoder', // decodes codes in pictures
  'payloads', // kinds of content
  'export', // files that can be saved
  'batch', // a code for every part: rows, the engines that carve them, and the storage of the results
  'npm', // the npm package: engine, decoder and carver for other programs
  'view', // the model on the screen
  'ui', // the panels
  'session', // the current work and its jobs
  'guide',
  'method',
  'study',
  'gallery', // articles
  'app.js', // connects all of them
  'main.js', // starts the page
];
const kApart = ['samples', 'styles']; // models made by the build, and styles

const kRoot = new URL('.', import.meta.url);

/** @param {string} path  below web/ */
const folderOf = (path) => (path.includes('/') ? path.slice(0, path.indexOf('/')) : path);

/** @param {string} folder */
const layerOf = (folder) => kLayers.indexOf(folder);

/** Returns the forbidden imports of a source from web/. @param {string} path @param {string} source */
function violationsIn(path, source) {
  const own = layerOf(folderOf(path));
  return [...source.matchAll(/(?:\bfrom |\bimport |\bimport\()'(\.[^']*)'/g)]
    .map(([, target]) => posix.join(posix.dirname(path), target))
    .filter(
      (target) =>
        !target.startsWith('../') &&
        folderOf(target) !== folderOf(path) &&
        !(layerOf(folderOf(target)) >= 0 && layerOf(folderOf(target)) < own),
    )
    .map((target) => `${path} imports ${target}`);
}

/** Returns the import cycles in a folder. @param {string[]} paths  below web/ @param {(path: string) => string} read */
function cyclesAmong(paths, read) {
  /** @type {Map<string, string[]>} */
  const imports = new Map(
    paths.map((path) => [
      path,
      [...withoutComments(read(path)).matchAll(/^(?:import|export)\b[^;]*? from '(\.[^']*)'/gm)].map(([, target]) =>
        posix.join(posix.dirname(path), target),
      ),
    ]),
  );
  /** @type {string[]} */ const cycles = [];
  /** @type {Map<string, 'open' | 'done'>} */ const seen = new Map();
  /** @param {string} path @param {string[]} way */
  const visit = (path, way) => {
    if (seen.get(path) === 'open') cycles.push([...way.slice(way.indexOf(path)), path].join(' → '));
    if (seen.has(path)) return;
    seen.set(path, 'open');
    for (const next of imports.get(path) ?? []) visit(next, [...way, path]);
    seen.set(path, 'done');
  };
  paths.forEach((path) => visit(path, []));
  return cycles;
}

/** @param {string} source */
const withoutComments = (source) => source.replace(/\/\*[\s\S]*?\*\//g, '');

const kSources = readdirSync(kRoot, { recursive: true, encoding: 'utf8' })
  .map((path) => path.replaceAll('\\', '/'))
  .filter((path) => path.endsWith('.js') && !path.endsWith('.test.js') && !kApart.includes(folderOf(path)));
const read = (/** @type {string} */ path) => readFileSync(new URL(path, kRoot), 'utf8');

test('A folder imports only lower layers', () => {
  assert.deepEqual(
    kSources.flatMap((path) => violationsIn(path, read(path))),
    [],
  );
});

test('The layers are the folders of web/', () => {
  assert.deepEqual([...new Set(kSources.map(folderOf))].sort(), [...kLayers].sort());
});

test('There are no import cycles', () => {
  assert.deepEqual(cyclesAmong(kSources, read), []);
});

test('Forbidden imports are detected', () => {
  assert.deepEqual(violationsIn('ui/a.js', "import { b } from '../session/b.js';"), ['ui/a.js imports session/b.js']);
  assert.deepEqual(violationsIn('view/a.js', "/** @typedef {import('../ui/b.js').B} B */"), [
    'view/a.js imports ui/b.js',
  ]);
  assert.deepEqual(violationsIn('ui/a.js', "import { b } from '../app.js';"), ['ui/a.js imports app.js']);
  assert.deepEqual(violationsIn('session/a.js', "import { b } from '../nowhere/b.js';"), [
    'session/a.js imports nowhere/b.js',
  ]);
  assert.deepEqual(
    violationsIn('session/a.js', "import { b } from '../ui/b.js';\nimport c from '../../locales/c.json';"),
    [],
  );
  const loop = { 'a.js': "import { b } from './b.js';", 'b.js': "import { a } from './a.js';" };
  assert.deepEqual(
    cyclesAmong(Object.keys(loop), (path) => /** @type {any} */ (loop)[path]),
    ['a.js → b.js → a.js'],
  );
});
