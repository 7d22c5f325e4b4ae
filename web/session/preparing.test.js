// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { afterEach, beforeEach, test } from 'node:test';
import { Preparing } from './preparing.js';

const { setTimeout: realSetTimeout, clearTimeout: realClearTimeout } = globalThis;
/** @type {string[]} */ let done = [];
let busy = false;
/** @type {EventTarget} */ let user;

const make = () => new Preparing({
  client: { prepareEngrave: async () => void done.push('carving') },
  prepareReader: () => void done.push('reader'),
  isBusy: () => busy,
  user,
});
/** @type {{ at: number, act: () => void }[]} */ let timers = [];
let now = 0;
const wait = (/** @type {number} */ ms) => {
  now += ms;
  const due = timers.filter(({ at }) => at <= now);
  timers = timers.filter(({ at }) => at > now);
  for (const { act } of due) act();
};
const use = () => user.dispatchEvent(new Event('pointermove'));

beforeEach(() => {
  timers = [];
  globalThis.setTimeout = /** @type {any} */ ((/** @type {() => void} */ act, /** @type {number} */ ms) => {
    const timer = { at: now + ms, act };
    timers.push(timer);
    return timer;
  });
  globalThis.clearTimeout = /** @type {any} */ ((/** @type {unknown} */ timer) => {
    timers = timers.filter((each) => each !== timer);
  });
  done = [];
  busy = false;
  user = new EventTarget();
});
afterEach(() => {
  Object.assign(globalThis, { setTimeout: realSetTimeout, clearTimeout: realClearTimeout });
});

test('A placed code is prepared once the page is used and quiet, whichever comes last', () => {
  make().note(true);
  wait(5000);
  assert.deepEqual(done, [], 'nobody is there');
  use();
  wait(300);
  assert.deepEqual(done, []);
  wait(200);
  assert.deepEqual(done, ['reader', 'carving']);
  use();
  wait(5000);
  assert.deepEqual(done, ['reader', 'carving'], 'once');
});

test('Each new place is prepared, but not while they follow each other', () => {
  const preparing = make();
  use();
  for (let i = 0; i < 5; i += 1) {
    preparing.note(true);
    wait(300);
  }
  assert.deepEqual(done, []);
  wait(200);
  preparing.note(true);
  wait(500);
  assert.deepEqual(done, ['reader', 'carving', 'reader', 'carving']);
});

test('Nothing is prepared without a place, or beside other work', () => {
  const preparing = make();
  use();
  preparing.note(true);
  preparing.note(false);
  wait(5000);
  preparing.note(true);
  busy = true;
  wait(5000);
  assert.deepEqual(done, []);
});

test('What goes wrong is for the carving to say', async () => {
  const preparing = new Preparing({
    client: { prepareEngrave: () => Promise.reject(new Error('no memory')) }, prepareReader: () => {}, isBusy: () => false, user,
  });
  use();
  preparing.note(true);
  wait(500);
  await new Promise((resolve) => { setImmediate(resolve); });  // an unhandled rejection would fail the test
});
