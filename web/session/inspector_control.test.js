// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { InspectorControl } from './inspector_control.js';

test('A frame drawn while the inspector closes leaves no state behind', async () => {
  /** @type {unknown} */ let state = 'shown';
  const options = /** @type {any} */ ({
    client: {
      inspector: async () => {
        state = 'of the last frame';
      },
    },
    view: { reportsPointer: true },
    window: { update: (/** @type {unknown} */ now) => (state = now) },
    toolbar: { inspectorShown: false },
    guard: (/** @type {() => Promise<void>} */ action) => action(),
  });
  await new InspectorControl(options).show(false);
  assert.equal(state, undefined);
  assert.equal(options.view.reportsPointer, false);
});
