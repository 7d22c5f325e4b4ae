// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { test } from 'node:test';
import { isKeptAtOnce, listFiles, serviceWorkerFor } from './build_plugin.js';

/** @param {Record<string, string>} contents  by path @param {(folder: string) => void} run */
function withFolder(contents, run) {
  const folder = mkdtempSync(`${tmpdir()}/qrelief-`);
  try {
    for (const [path, content] of Object.entries(contents)) {
      mkdirSync(`${folder}/${path.replace(/[^/]*$/, '')}`, { recursive: true });
      writeFileSync(`${folder}/${path}`, content);
    }
    run(folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** @param {string} code */
const versionOf = (code) => /"version":"(\w+)"/.exec(code)?.[1];

test('every file is kept except hidden ones, the worker, the library’s pages and files for search engines', () => {
  withFolder(
    {
      'api/index.html': 'l',
      'gallery/x.webp': 'p',
      'index.html': 'a',
      'assets/x.js': 'b',
      'samples/.gitignore': '*',
      'service_worker.js': 'c',
      'robots.txt': 'd',
    },
    (folder) => {
      assert.deepEqual(
        listFiles(folder).map(([path]) => path),
        ['assets/x.js', 'gallery/x.webp', 'index.html'],
      );
    },
  );
});

test('the version is the same for the same files, and another one when a byte of them changes', () => {
  withFolder({ 'index.html': 'a', 'assets/x.js': 'b' }, (folder) => {
    const before = versionOf(serviceWorkerFor(listFiles(folder)));
    assert.match(String(before), /^[0-9a-f]{16}$/);
    assert.equal(versionOf(serviceWorkerFor(listFiles(folder))), before);
    writeFileSync(`${folder}/assets/x.js`, 'c');
    assert.notEqual(versionOf(serviceWorkerFor(listFiles(folder))), before);
  });
});

test('the app and its first sample are kept at once, articles, pictures and other samples when opened', () => {
  const atOnce = ['index.html', 'theme.js', 'assets/index-1.js', 'assets/worker-2.js', 'assets/qrelief-3.wasm'].concat([
    'manifest.webmanifest',
    'favicon.svg',
    'samples/bunny.stl',
    'samples/manifest.json',
    'assets/en-app-4.js',
    'assets/en-messages-5.js',
  ]);
  const whenOpened = ['guide.html', 'study.html', 'study/frontier.csv', 'gallery/owl-0-designed.webp'].concat([
    'assets/guide-1.js',
    'assets/article-2.css',
    'assets/fr-app-6.js',
    'assets/ja-messages-7.js',
    'assets/en-guide-8.js',
    'assets/carved-3.jpg',
    'samples/owl.stl',
    'icons/icon-512.png',
  ]);
  assert.deepEqual([...atOnce, ...whenOpened].filter(isKeptAtOnce), atOnce);
  const files = [...atOnce, ...whenOpened].map((path) => /** @type {[string, string]} */ ([path, 'h']));
  const build = JSON.parse(/self\.qreliefBuild = (.*);\n/.exec(serviceWorkerFor(files))?.[1] ?? '');
  assert.deepEqual(
    build.files,
    atOnce.map((path) => [path, 'h']),
  );
  assert.deepEqual(build.whenOpened, whenOpened);
});
