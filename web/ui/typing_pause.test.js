// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { mock, test } from 'node:test';
import { TypingPause } from './typing_pause.js';

test('Acts once, when typing has paused', async () => {
  mock.timers.enable({ apis: ['setTimeout'] });
  try {
    let acts = 0;
    const pause = new TypingPause(() => (acts += 1));
    pause.typed();
    mock.timers.tick(200);
    pause.typed();
    mock.timers.tick(200);
    assert.equal(acts, 0);
    mock.timers.tick(50);
    assert.equal(acts, 1);
    await pause.settle();
    assert.equal(acts, 1, 'no pause has begun');
    pause.typed();
    await pause.settle();
    assert.equal(acts, 2);
    pause.typed();
    pause.forget();
    mock.timers.tick(1000);
    assert.equal(acts, 2);
  } finally {
    mock.timers.reset();
  }
});
