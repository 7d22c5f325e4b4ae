// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { setLanguage } from './catalogue.js';
import { stageText } from './stages.js';

/** The names of stages in a source: of `Progress{"…"`, and of `return {"…"` in a progress(). @param {string} path */
function stagesIn(path) {
  const source = readFileSync(new URL(`../../${path}`, import.meta.url), 'utf8');
  const from = source.search(/::progress\(\)|Job::advance\(\)/);
  return [...source.slice(from).matchAll(/(?:Progress\{|return \{|name = )"([^"]+)"/g)].map(([, name]) => name);
}

// The jobs that the module runs for the page.
for (const path of ['core/pipeline/engrave.cpp', 'core/pipeline/place.cpp']) {
  test(`every stage of ${path} has German words`, () => {
    const stages = stagesIn(path);
    assert.ok(stages.length >= 3, `found only ${stages.length} stages: the source is written differently now`);
    setLanguage('de');
    const missing = stages.filter((stage) => stageText(stage) === stage);
    setLanguage('en');
    assert.deepEqual(missing, []);
  });
}
