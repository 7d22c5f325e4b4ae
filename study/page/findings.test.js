// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { kFindings } from './findings.js';
import { findingMarkup } from './markup.js';
import { sentence } from './say.js';
import { measured, parseTable, readTables } from './table.js';

const rowsOf = Object.fromEntries(
  Object.entries(readTables(new URL('../results', import.meta.url).pathname)).map(([table, { rows }]) => [
    table,
    measured(rows),
  ]),
);

test('the kept tables have five findings, each with a number, bars, and a figure behind it', () => {
  const page = readFileSync(new URL('../../web/study.html', import.meta.url), 'utf8');
  assert.equal(kFindings.length, 5);
  for (const { section, find } of kFindings) {
    const finding = find(rowsOf);
    assert.ok(finding, section);
    assert.match(sentence('en', finding.number), /^\d/);
    assert.ok(finding.bars.length >= 2);
    for (const { value } of finding.bars) assert.ok(value >= 0, section);
    assert.equal(new Set(finding.bars.map(({ label }) => sentence('en', label))).size, finding.bars.length, section);
    assert.match(page, new RegExp(`<h3 id="${section}"`));
  }
});

test('without their tables there are no findings', () => {
  for (const { section, find } of kFindings) assert.equal(find({}), undefined, section);
});

/** @param {string} section @param {Record<string, string>} tables  CSV by name */
const found = (section, tables) =>
  kFindings
    .find((source) => source.section === section)
    ?.find(Object.fromEntries(Object.entries(tables).map(([table, csv]) => [table, parseTable(csv)])));

test('the smallest module is the one that decodes in both orientations, in the default’s pattern', () => {
  const head = 'process,modules,finders,pose,module_mm\n';
  const sizes = ['fdm-0.4/0.2', 'fdm-0.25/0.1']
    .flatMap((process, fine) => [
      `${process},thick-plus,none,code-up,${0.5 - 0.2 * fine}`,
      `${process},thick-plus,none,code-upright,${0.6 - 0.2 * fine}`,
      `${process},square,none,code-up,0.1`,
    ])
    .join('\n');
  const settings = 'module_mm,modules,finders\n0.6,thick-plus,none\n';
  const finding = found('module', { least_module: `${head}${sizes}\n`, default_settings: settings });
  assert.equal(finding && sentence('en', finding.number), '0.60\u00a0mm');
  assert.equal(finding?.bars.length, 4);
});

test('depths are compared only with methods that decode as printed on every model', () => {
  const finding = found('methods', {
    method_comparison:
      'model,method,depth_mm,printed\n' +
      ['plate,ours,0.5,50', 'vase,ours,0.7,40', 'plate,papp-2022,0.4,34', 'vase,papp-2022,0.4,28']
        .concat(['plate,self-shadow-2019,2,60', 'vase,self-shadow-2019,2.2,60', ''])
        .join('\n'),
  });
  assert.deepEqual(
    finding?.bars.map(({ label, value, isOurs }) => [sentence('en', label), value.toFixed(2), isOurs]),
    [
      ['QRelief (default)', '0.60', true],
      ['Peng 2019', '2.10', false],
    ],
  );
});

test('the highest lamp is the last angle before the first that fails', () => {
  const finding = found('angles', {
    light_angles:
      'modules,carved_at,read_at,search,reads\n' +
      ['4,papp-2022,60', '15,papp-2022,29', '15,papp-2022-literal,70', '23,papp-2022,28', '88,papp-2022,40']
        .map((row) => `none,sky,${row}\n`)
        .join(''),
  });
  assert.equal(finding && sentence('en', finding.number), '15°');
  assert.equal(finding?.bars.length, 4, 'without the literal search');
});

test('a bar is as long as its value in the whole, and the number links the figure', () => {
  const html = findingMarkup(
    {
      title: 'findingPrint',
      number: { say: 'asIs', with: { value: '51' } },
      says: [{ say: 'findingPrintSays', with: { needed: 29, of: 72 } }],
      bars: [65, 13].map((value) => ({
        label: { say: 'asIs', with: { value: `<${value}>` } },
        value,
        said: { say: 'findingMm', with: { value } },
      })),
      whole: 130,
    },
    'frontier',
  );
  assert.deepEqual(
    [...html.matchAll(/<rect width="([\d.]+)%"/g)].map(([, width]) => Number(width)),
    [50, 10, 50, 10],
  );
  assert.match(html, /<section lang="de" class="in-de"><h3>Was kostet der Druck\?<\/h3>/);
  assert.match(html, /<a href="#frontier">Figure and table<\/a>/);
  assert.match(html, /<th scope="row">&lt;13>/);
});
