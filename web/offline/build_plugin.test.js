// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { test } from 'node:test';
import { listFiles, serviceWorkerFor } from './build_plugin.js';

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

test('every file is cached except hidden ones, the worker and files for search engines', () => {
  withFolder(
    {
      'api/index.html': 'l',
      'gallery/x.png': 'p',
      'index.html': 'a',
      'assets/x.js': 'b',
      'samples/.gitignore': '*',
      'service_worker.js': 'c',
      'robots.txt': 'd',
    },
    (folder) => {
      assert.deepEqual(
        listFiles(folder).map(([path]) => path),
        ['assets/x.js', 'index.html'],
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
