// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { importsOf, resolved } from './build.js';

test('Imports of the page’s build become files of the package', () => {
  assert.equal(
    resolved('engine/module.js', "import create from 'qrelief-module';\nimport wasmUrl from 'qrelief-wasm';\n"),
    "import create from '../module/qrelief.js';\n" +
      "const wasmUrl = new URL('../module/qrelief.wasm', import.meta.url).href;\n",
  );
  assert.equal(resolved('a.js', "import('zxing-wasm/reader')"), "import('./zxing/reader/index.js')");
});

test('Other imports stay', () => {
  const source = "import { a } from './a.js';\nimport { readFile } from 'node:fs/promises';\n";
  assert.equal(resolved('b.js', source), source);
});

test('A file’s imports are those that it loads, not those of its types', () => {
  const source = "import { a } from '../a/a.js';\n/** @type {import('./b.js').B} */ const c = import('./c.js');\n";
  assert.deepEqual(importsOf('d/e.js', source), ['a/a.js', 'd/c.js']);
});
