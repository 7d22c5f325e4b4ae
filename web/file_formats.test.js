// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { kLanguages } from './i18n/locales.js';

/** @param {string} path  from the repository's folder */
const contentOf = (path) => readFileSync(new URL(`../${path}`, import.meta.url), 'utf8');

/** The formats that readModel() reads, by name, with their extensions. */
const kReadable = (() => {
  const names = new Map(
    [...contentOf('core/io/sniff_format.cpp').matchAll(/^ +\{"(\w+)", \{(("\w+"(, )?)+)\}, \w+\},$/gm)].map(
      ([, name, extensions]) => [name.toUpperCase(), extensions.replaceAll('"', '').split(', ')],
    ),
  );
  const cases = [...contentOf('core/io/read_model.cpp').matchAll(/case ModelFormat::(\w+):\s*return read/g)];
  return cases.map(([, format]) => {
    const name = format.toUpperCase().replace('THREE', '3');
    return { name, extensions: names.get(name) ?? [] };
  });
})();

test('The formats are found in the source', () => {
  assert.ok(kReadable.length >= 5, JSON.stringify(kReadable));
  for (const { name, extensions } of kReadable) assert.ok(extensions.length > 0, name);
});

test('Every list of the readable formats is complete', () => {
  const kLists = /** @type {const} */ ([
    ['README.md', /^- Takes (.*);/m],
    ['ARCHITECTURE.md', /parsers \(([^)]*)\)/],
    ['docs/command-line.md', /^- Input: (.*)$/m],
    ['docs/comparison.md', /^\| takes .* \| ([^|]*) \|$/m],
    ['native/cli/model_input.h', /kModelFormats = "([^"]*)"/],
    ['web/npm/README.md', /fileName: 'part.stl', *\/\/ (.*)/],
    ['web/npm/engine.js', /@param \{Bytes\} bytes *of an (.*) file/],
  ]);
  /** @type {{ path: string, list: string }[]} */
  const lists = kLists.map(([path, list]) => ({ path, list: list.exec(contentOf(path))?.[1] ?? '' }));
  for (const { code } of kLanguages) {
    const path = `locales/${code}.json`;
    const { files } = JSON.parse(contentOf(path)).messages;
    for (const key of ['format-unknown', 'format-unreadable']) lists.push({ path, list: files[key].hint });
  }
  for (const { path, list } of lists)
    for (const { name } of kReadable) assert.match(list, new RegExp(`\\b${name}\\b`), path);
});

test('Every chooser of files offers the extensions of the readable formats', () => {
  for (const path of ['web/index.html', 'examples/page/index.html']) {
    const offered = /id="file" type="file" accept="([^"]*)"/.exec(contentOf(path))?.[1].split(',');
    for (const extension of [...kReadable.flatMap(({ extensions }) => extensions), 'zip'])
      assert.ok(offered?.includes(`.${extension}`), `${path}: .${extension}`);
  }
});
