// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { fillFigures, makeStudy } from './build_plugin.js';
import { kFigures } from './figures.js';
import { kWidths } from './figure.js';
import { isKnown, models, name, said, sentence } from './say.js';
import { kStatements } from './statements.js';
import { parseTable, readTables } from './table.js';
import { kNeeded, kTries } from './tries.js';

const kHead = 'model,search,flips,flipped_modules,depth_mm,removed_mm,designed,printed,failed\n';
const kFailed = 'star,ours,none,,,,,,no-place\n';
const kMeasured = ['none,0,1.000', 'peng-2019,16,0.900', 'ours,53,0.800'].map((flips) => `${flips},0.4,50,40,\n`);
const kFlips = [
  kHead,
  ...['plate', 'cylinder'].flatMap((model) =>
    ['self-shadow-2019', 'ours'].flatMap((search) => kMeasured.map((row) => `${model},${search},${row}`)),
  ),
  kFailed,
].join('');

const tableOf = (/** @type {string} */ csv) => ({ csv, rows: parseTable(csv) });

test('a table becomes figures of both widths in both languages, sentences with its numbers, and a file', async () => {
  const { files, markup } = await makeStudy({ symbol_flips: tableOf(kFlips) });
  assert.equal(files.get('study/symbol_flips.csv'), kFlips);
  for (const language of ['en', 'de']) {
    for (const [width, pixels] of Object.entries(kWidths)) {
      const svg = files.get(`study/symbolFlips.${language}.${width}.svg`) ?? '';
      assert.ok(Math.abs(Number(/<svg[^>]* width="(\d+)/.exec(svg)?.[1]) - pixels) < 12, `${language} ${width}`);
      assert.doesNotMatch(svg, /NaN|undefined/);
    }
  }
  const content = markup.get('symbolFlips') ?? '';
  assert.match(content, /by\s10\s% and\s20\s%, with our search by\s10\s% and\s20\s%/);
  assert.match(content, /um\s10\s% und\s20\s% flacher/);
  assert.match(content, /1 of 13 cases could not be engraved and is left out/);
  assert.match(content, /<a href="study\/symbol_flips\.csv" download>Table with 13 rows, CSV<\/a>/);
});

test('no label of the kept tables’ figures is cut off', async () => {
  const { files } = await makeStudy(readTables(new URL('../results', import.meta.url).pathname));
  const drawings = [...files].filter(([path]) => path.endsWith('.svg'));
  assert.equal(drawings.length, 4 * kFigures.length);
  for (const [path, svg] of drawings) assert.doesNotMatch(svg, /…/, path);
});

test('where a table is missing or empty the figure is left out, and the page says so', async () => {
  const { files, markup } = await makeStudy({ symbol_flips: tableOf(kHead + kFailed) });
  assert.equal(files.size, 0);
  const { findings, statements, decoderRates, ...figures } = Object.fromEntries(markup);
  assert.deepEqual(
    Object.keys(figures),
    kFigures.map(({ name }) => name),
  );
  for (const content of Object.values(figures)) assert.match(content, /has not been measured yet/);
  for (const content of [findings, decoderRates]) assert.match(content, /has not been measured yet/);
  assert.equal(statements.match(/<td>not measured<\/td>/g)?.length, kStatements.length);
  assert.doesNotMatch(statements, /taken literally/);
  assert.doesNotMatch(statements, /Holds\.|Does not hold/);
});

test('a statement is judged by the table; where it does not hold, the reason follows', async () => {
  const lineOf = async (/** @type {number[]} */ depths) => {
    const lamps = tableOf(
      `model,modules,lamps,search,depth_mm,failed\n` +
        depths.map((mm, at) => `plate,none,${at},papp-2022,${mm},\nplate,none,${at},papp-2022-literal,0.9,\n`).join(''),
    );
    const { markup } = await makeStudy({ lamp_depths: lamps });
    assert.match(markup.get('statements') ?? '', /was measured for these sections: Lamps\./);
    return /Lamps make codes with whole modules shallower\.<\/th>(.*)<\/tr>/.exec(markup.get('statements') ?? '')?.[1];
  };
  const link = '<a href="#lamps">Lamps</a>';
  assert.equal(
    await lineOf([0.9, 0.8, 0.7]),
    `<td>on all 1 models</td><td>on none of the 1 models</td><td>Holds. ${link}</td>`,
  );
  assert.equal(
    await lineOf([0.7, 0.8, 0.9]),
    `<td>on none of the 1 models</td><td>on none of the 1 models</td>` +
      `<td>Does not hold. The paper gives neither the elevation nor the strength of these lamps; here the elevation decides. ${link}</td>`,
  );
});

test('sentences that lack a number are not said', () => {
  assert.equal(isKnown(said('flipsReads', { tries: NaN })), false);
  assert.equal(isKnown(said('patternsLoose', { cases: models({ holds: 0, of: 0 }) })), false);
  assert.equal(isKnown(said('lampsWhy')), true);
  assert.equal(isKnown(said('frontierLost', { list: [] })), false);
});

test('how often a statement holds is said in words', () => {
  const words = (/** @type {number} */ holds) => sentence('en', models({ holds, of: 8 }));
  assert.deepEqual([0, 7, 8].map(words), ['on none of the 8 models', 'on 7 of 8 models', 'on all 8 models']);
  assert.equal(
    sentence('de', said('robustOf', { pattern: said('pattern-square'), blur: { number: 0.5, digits: 2 } })),
    'Quadrat 0,50',
  );
});

test('the contents lead to every heading, and each of them has a name', () => {
  const page = readFileSync(new URL('../../web/study.html', import.meta.url), 'utf8');
  const contents = /<nav class="contents"[^]*?<\/nav>/.exec(page)?.[0] ?? '';
  const linked = [...contents.matchAll(/href="#(\w+)"/g)].map(([, id]) => id);
  const headings = [...page.matchAll(/<h[23] id="(\w+)"/g)].map(([, id]) => id).filter((id) => id !== 'contents');
  assert.deepEqual(linked, headings);
});

test('every figure stands on the page once, and one that is not there fails the build', () => {
  const page = readFileSync(new URL('../../web/study.html', import.meta.url), 'utf8');
  assert.deepEqual(
    [...page.matchAll(/data-figure="(\w+)"/g)].map(([, name]) => name).sort(),
    [...kFigures.map(({ name }) => name), 'findings', 'statements', 'decoderRates'].sort(),
  );
  assert.throws(() => fillFigures('<div data-figure="nothing"></div>', new Map()), /no figure "nothing"/);
});

test('a figure’s table is one that an experiment makes, with the columns it shows', () => {
  const source = (/** @type {string} */ path) => readFileSync(new URL(`../${path}`, import.meta.url), 'utf8');
  for (const { table, measures } of kFigures) {
    const maker =
      table === 'aside'
        ? source('aside/aside.mjs')
        : source(`experiments/${table}.cpp`) +
          source('experiments/experiments.cpp') +
          source('experiments/chosen_settings.cpp');
    for (const measure of measures) assert.match(maker, new RegExp(`[",]${measure}[",]`), `${table}: ${measure}`);
  }
});

test('every model, method and pattern of the tables has a name', () => {
  const source = (/** @type {string} */ path) => readFileSync(new URL(path, import.meta.url), 'utf8');
  const quoted = (/** @type {string | undefined} */ code) =>
    [...(code ?? '').matchAll(/"([\w-]+)"/g)].map(([, word]) => word);
  const names = {
    model: quoted(/kNames = \{([^}]*)\}/.exec(source('../study_context.cpp'))?.[1]),
    method: [...source('../methods/methods.cpp').matchAll(/^ {6}\{"([\w-]+)",/gm)].map(([, method]) => method),
    pattern: ['none', 'square', 'thin-plus', 'diamond', 'thick-plus'],
  };
  assert.ok(names.model.length >= 8 && names.method.length >= 9);
  for (const [kind, values] of Object.entries(names)) {
    for (const value of values) assert.notEqual(name(kind, value).say, 'asIs', `${kind} ${value}`);
  }
  assert.equal(sentence('en', name('method', 'new-one')), 'new-one');
});

test('the line that figures mark is the core’s', () => {
  assert.equal(kNeeded, 29);
  const core = readFileSync(new URL('../../core/verification/frontal_reading.h', import.meta.url), 'utf8');
  assert.match(core, /needed\(int tries\) \{ return \(2 \* tries \+ 4\) \/ 5; \}/);
  assert.match(
    readFileSync(new URL('../README.md', import.meta.url), 'utf8'),
    new RegExp(`makes ${kTries}\\. A code passes with ${kNeeded}`),
  );
});
