// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { deeperPreset, depthRemedies, printingRemedies, readingRemedies, sizeRemedies } from './remedies.js';
import { verdictOf } from './verdict.js';

/** @typedef {import('../engine/types.js').Report} Report */

const values = { size: 'free', 'size-mm': '40', preset: 'balanced', contrast: '', pattern: 'thick-plus', nozzle: '0.4', layer: '0.1', ecc: 'auto' };

/** @param {{ size?: object, features?: object, mesh?: object, verification?: object }} [parts] */
const makeReport = ({ size, features, mesh, verification } = {}) => /** @type {Report} */ (/** @type {unknown} */ ({
  text: 'hello',
  symbol: { version: 3, ecc: 'M', modules: 29 },
  size: { symbolMm: 29, moduleMm: 1, guaranteedMm: 29, ...size },
  depth: { features: { moduleMm: 1, pocketMm: 0.6, leastDepthMm: 0.8, ...features } },
  mesh: { closed: true, manifold: true, selfIntersections: 0, ...mesh },
  verification: { printability: [], iso29158: { overall: 3 }, ...verification },
}));

const reading = { text: 'hello', tries: 10, reads: 10 };

test('A code reads if enough of the tries succeed, barely if few do, and not if none or another text', () => {
  const level = (/** @type {object} */ change) => verdictOf(makeReport(), { ...reading, ...change }).reads;
  assert.equal(level({}), 'good');
  assert.equal(level({ reads: 4 }), 'good');
  assert.equal(level({ reads: 3 }), 'barely');
  assert.equal(level({ reads: 0, text: '' }), 'bad');
  assert.equal(level({ text: 'hullo' }), 'bad');
});

test('A code that a verifier would fail reads barely', () => {
  const verdict = verdictOf(makeReport({ verification: { iso29158: { overall: 0 } } }), reading);
  assert.deepEqual([verdict.reads, verdict.weak], ['barely', true]);
});

test('Advice on printing makes it doubtful, a defect of the mesh makes it no solid', () => {
  assert.equal(verdictOf(makeReport({ verification: { printability: [{ problem: 'p', hint: 'h' }] } }), reading).prints, 'barely');
  for (const mesh of [{ closed: false }, { manifold: false }, { selfIntersections: 1 }]) {
    assert.equal(verdictOf(makeReport({ mesh }), reading).solid, 'bad');
  }
});

test('A code at its greatest size may become a quarter larger, or as large as its modules must be', () => {
  const report = makeReport({ size: { symbolMm: 40, guaranteedMm: 40 } });
  assert.deepEqual(sizeRemedies(report, values), [{ kind: 'larger', control: 'size-mm', value: '50' }]);
  assert.deepEqual(sizeRemedies(report, values, 2), [{ kind: 'larger', control: 'size-mm', value: '58' }]);
});

test('A code that the spot keeps small may be turned, one of exact size may grow to what fits', () => {
  assert.deepEqual(sizeRemedies(makeReport(), values), [{ kind: 'turned', control: 'size', value: 'best' }]);
  assert.deepEqual(sizeRemedies(makeReport(), { ...values, size: 'best' }), []);
  const exact = { ...values, size: 'fixed', 'size-mm': '20' };
  assert.deepEqual(sizeRemedies(makeReport({ size: { symbolMm: 20, guaranteedMm: 31 } }), exact), [{ kind: 'largest', control: 'size', value: 'free' }]);
  assert.deepEqual(sizeRemedies(makeReport({ size: { symbolMm: 20, guaranteedMm: 20 } }), exact), []);
});

test('A preset is followed by the next deeper one, unless a contrast was chosen by itself', () => {
  assert.equal(deeperPreset({ ...values, preset: 'shallow' }), 'balanced');
  assert.equal(deeperPreset(values), 'robust');
  assert.equal(deeperPreset({ ...values, preset: 'robust' }), undefined);
  assert.equal(deeperPreset({ ...values, contrast: '0.2' }), undefined);
});

test('The next deeper preset helps, but first the contrast that overrides it goes', () => {
  assert.deepEqual(depthRemedies({ ...values, preset: 'shallow' }), [{ kind: 'balanced', control: 'preset', value: 'balanced' }]);
  assert.deepEqual(depthRemedies(values), [{ kind: 'robust', control: 'preset', value: 'robust' }]);
  assert.deepEqual(depthRemedies({ ...values, preset: 'robust' }), []);
  assert.deepEqual(depthRemedies({ ...values, contrast: '0.1' }), [{ kind: 'autoContrast', control: 'contrast', value: '' }]);
});

test('Another spot can always be looked for', () => {
  assert.deepEqual(readingRemedies(makeReport(), values).at(-1), { kind: 'spot' });
  assert.ok(readingRemedies(makeReport(), { ...values, ecc: 'L' }).some(({ kind }) => kind === 'ecc'));
});

test('Full modules too small for the nozzle: thick plus, or the widest nozzle that is sold and fits', () => {
  const report = makeReport({ features: { moduleMm: 1, pocketMm: 1 } });
  const found = printingRemedies(report, { ...values, pattern: 'none', size: 'best' });
  assert.deepEqual(found, [
    { kind: 'pattern', control: 'pattern', value: 'thick-plus' }, { kind: 'nozzle', control: 'nozzle', value: '0.3' }, { kind: 'spot' },
  ]);
});

test('Modules too shallow for two layers: deeper, or thinner layers', () => {
  const found = printingRemedies(makeReport({ features: { leastDepthMm: 0.17 } }), values);
  assert.deepEqual(found, [
    { kind: 'robust', control: 'preset', value: 'robust' }, { kind: 'layer', control: 'layer', value: '0.08' }, { kind: 'spot' },
  ]);
});
