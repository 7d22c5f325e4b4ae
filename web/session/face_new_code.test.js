// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { faceNewCodes } from './face_new_code.js';
import { Signal } from './signal.js';

/** @type {any[]} */ let acts;
/** @type {any} */ let carving;
/** @type {any} */ let tools;
let prefersStill = false;

beforeEach(() => {
  acts = [];
  carving = { started: new Signal(), finished: new Signal() };
  tools = { seesCode: false, reader: { shown: false } };
  prefersStill = false;
  faceNewCodes({
    client: { act: async (/** @type {any} */ action) => void acts.push(action) },
    carving,
    tools,
    prefersStill: () => prefersStill,
  });
});

test('The camera turns to a new engraving', () => {
  tools.onMoved();
  carving.started.emit();
  carving.finished.emit();
  assert.deepEqual(acts, [{ kind: 'face' }]);
});

test('The camera stays where the user moved it during the work', () => {
  carving.started.emit();
  tools.onMoved();
  carving.finished.emit();
  assert.deepEqual(acts, []);
});

test('The camera stays where the code is already seen well, in the phone view, and without motion', () => {
  carving.started.emit();
  tools.seesCode = true;
  carving.finished.emit();
  tools.seesCode = false;
  tools.reader.shown = true;
  carving.finished.emit();
  tools.reader.shown = false;
  prefersStill = true;
  carving.finished.emit();
  assert.deepEqual(acts, []);
});
