// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { centredAt, changeByHandles, chosenCentre, sameWork, storedWork, withChanges } from './work.js';

/** @type {import('./work.js').Work} */
const kWork = {
  source: { bytes: new Uint8Array([1]), fileName: 'a.stl', scaleToMm: 10, upAxis: 'y', credit: 'x', unitStated: false },
  text: 'a',
  settings: { preset: 'balanced' },
  centreMm: [1, 2, 3],
  centreIsGuess: false,
};
const kBatch = /** @type {any} */ ({ from: 'count', list: new Uint8Array(), count: 3 });

test('Works with the same inputs of a carving are the same', () => {
  const source = /** @type {any} */ (kWork.source);
  assert.equal(sameWork(kWork, { ...kWork, settings: { ...kWork.settings }, centreMm: [1, 2, 3] }), true);
  assert.equal(sameWork(kWork, { ...kWork, source: { ...source, fileName: 'b.stl' } }), true);
  for (const change of /** @type {Partial<import('./work.js').Work>[]} */ ([
    { text: 'b' },
    { settings: { preset: 'robust' } },
    { centreMm: [1, 2, 4] },
    { batch: kBatch },
    { source: { ...source, upAxis: 'z' } },
    { source: { ...source, scaleToMm: 1 } },
    { source: { ...source, bytes: new Uint8Array([1]) } },
    { source: undefined },
  ]))
    assert.equal(sameWork(kWork, { ...kWork, ...change }), false, JSON.stringify(change));
});

test('A proposed centre is not a chosen one', () => {
  assert.deepEqual(chosenCentre(kWork), [1, 2, 3]);
  assert.equal(chosenCentre({ ...kWork, ...centredAt([1, 2, 3], true) }), undefined);
  assert.deepEqual(centredAt(undefined, true), { centreMm: undefined, centreIsGuess: false });
});

test('A file is stored with its bytes, a sample by its id, and a proposed centre not at all', () => {
  const place = { fileName: 'a.stl', scaleToMm: 10, upAxis: 'y' };
  assert.deepEqual(storedWork(kWork), {
    ...place,
    bytes: kWork.source?.bytes,
    centreMm: [1, 2, 3],
    text: 'a',
    settings: kWork.settings,
  });
  const source = /** @type {any} */ ({ ...kWork.source, sampleId: 'saddle' });
  assert.deepEqual(storedWork({ ...kWork, source, centreIsGuess: true, batch: kBatch }), {
    ...place,
    sampleId: 'saddle',
    centreMm: undefined,
    text: 'a',
    settings: kWork.settings,
    batch: kBatch,
  });
  assert.equal(storedWork({ ...kWork, source: undefined }), undefined);
});

test('The handles set rotation and size', () => {
  assert.deepEqual(changeByHandles({ rotateDeg: 15 }, { size: 'free' }), { rotateDeg: 15 });
  assert.deepEqual(changeByHandles({ rotateDeg: 15 }, { size: 'best' }), { rotateDeg: 15, size: 'oriented' });
  assert.deepEqual(changeByHandles({ symbolMm: 21.5 }, { size: 'free' }), { size: 21.5 });
  assert.deepEqual(changeByHandles({ rotateDeg: 3, symbolMm: 9 }, {}), { size: 9, rotateDeg: 3 });
});

test('The changes that the engine proposes are of the text or of settings', () => {
  const changes = [
    { setting: 'text', value: 'A' },
    { setting: 'maxSizeMm', value: '45.5' },
    { setting: 'process', value: 'powder' },
  ];
  const { text, settings } = withChanges(kWork, changes);
  assert.equal(text, 'A');
  assert.deepEqual(settings, { preset: 'balanced', maxSizeMm: 45.5, process: 'powder', nozzleMm: 0.1, layerMm: 0.1 });
  assert.deepEqual(withChanges(kWork, []), { text: 'a', settings: kWork.settings });
});
