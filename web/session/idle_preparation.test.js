// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { afterEach, beforeEach, test } from 'node:test';
import { LiveView } from '../view/live_view.js';
import { IdlePreparation } from './idle_preparation.js';

const { setTimeout: realSetTimeout, clearTimeout: realClearTimeout } = globalThis;
/** @type {string[]} */ let done = [];
let busy = false;
let live = false;
let searchMs = 0; // that the preparation takes
let overModel = true;
/** @type {EventTarget} */ let user;

const shown = new LiveView(() => live);
const make = () =>
  new IdlePreparation({
    client: {
      prepareEngrave: async ({ search, untilShown }) => {
        done.push(!search ? 'carving' : untilShown ? 'first pass' : 'search');
        now += searchMs;
        return search ? { meanMm: untilShown ? 0.4 : 0.5, maxMm: 1 } : null;
      },
    },
    prepareReader: () => void done.push('reader'),
    isBusy: () => busy,
    live: shown,
    onDepths: ({ meanMm }) => void done.push(`${meanMm} mm`),
    user,
    isOverModel: () => overModel,
  });
/** @type {{ at: number, act: () => void }[]} */ let timers = [];
let now = 0;
const wait = (/** @type {number} */ ms) => {
  now += ms;
  const due = timers.filter(({ at }) => at <= now);
  timers = timers.filter(({ at }) => at > now);
  for (const { act } of due) act();
  return new Promise((resolve) => {
    setImmediate(resolve);
  });
};
const use = () => user.dispatchEvent(new Event('pointermove'));

beforeEach(() => {
  shown.reset();
  timers = [];
  globalThis.setTimeout = /** @type {any} */ (
    (/** @type {() => void} */ act, /** @type {number} */ ms) => {
      const timer = { at: now + ms, act };
      timers.push(timer);
      return timer;
    }
  );
  globalThis.clearTimeout = /** @type {any} */ (
    (/** @type {unknown} */ timer) => {
      timers = timers.filter((each) => each !== timer);
    }
  );
  done = [];
  busy = false;
  live = false;
  searchMs = 0;
  overModel = true;
  user = new EventTarget();
});
afterEach(() => {
  Object.assign(globalThis, { setTimeout: realSetTimeout, clearTimeout: realClearTimeout });
});

test('A placed code is prepared once the page has been used and is quiet', async () => {
  make().setPlaced(true);
  await wait(5000);
  assert.deepEqual(done, [], 'nobody is there');
  use();
  await wait(250);
  assert.deepEqual(done, []);
  use();
  await wait(250);
  assert.deepEqual(done, [], 'it is being used');
  await wait(100);
  assert.deepEqual(done, ['carving', 'reader']);
  use();
  await wait(5000);
  assert.deepEqual(done, ['carving', 'reader'], 'once');
});

test('A pointer beside the model does not delay it', async () => {
  make().setPlaced(true);
  use();
  overModel = false;
  for (let i = 0; i < 5; i += 1) {
    await wait(200);
    use();
  }
  assert.deepEqual(done, ['carving', 'reader']);
});

test('Each new place is prepared, but not during quick successions', async () => {
  const preparation = make();
  use();
  for (let i = 0; i < 5; i += 1) {
    preparation.setPlaced(true);
    await wait(250);
  }
  assert.deepEqual(done, []);
  await wait(100);
  preparation.setPlaced(true);
  await wait(400);
  assert.deepEqual(done, ['carving', 'reader', 'carving', 'reader']);
});

test('The depths are searched ahead if codes are shown as carved, but not where that takes long', async (t) => {
  t.mock.method(performance, 'now', () => now);
  live = true;
  const preparation = make();
  use();
  const prepareNext = async () => {
    done = [];
    preparation.setPlaced(true);
    await wait(400);
    return done;
  };
  const searched = ['first pass', 'search', '0.5 mm', 'reader'];
  assert.deepEqual(await prepareNext(), searched);
  searchMs = 1500;
  assert.deepEqual(await prepareNext(), searched);
  assert.deepEqual(await prepareNext(), ['carving', 'reader'], 'it took too long');
  shown.reset();
  assert.deepEqual(await prepareNext(), searched, 'the user has switched it off and on');
});

test('Depths are not shown for a code that has moved on', async () => {
  live = true;
  const preparation = make();
  use();
  preparation.setPlaced(true);
  const searched = wait(400);
  preparation.setPlaced(true);
  await searched;
  assert.ok(done.includes('first pass'));
  assert.ok(!done.includes('0.5 mm'));
});

test('Nothing is prepared without a place or during other work', async () => {
  const preparation = make();
  use();
  preparation.setPlaced(true);
  preparation.setPlaced(false);
  await wait(5000);
  preparation.setPlaced(true);
  busy = true;
  await wait(5000);
  assert.deepEqual(done, []);
});

test('Errors are left for the carving to report', async () => {
  const preparation = new IdlePreparation({
    client: { prepareEngrave: () => Promise.reject(new Error('no memory')) },
    prepareReader: () => {},
    isBusy: () => false,
    live: new LiveView(() => false),
    onDepths: () => {},
    user,
    isOverModel: () => true,
  });
  use();
  preparation.setPlaced(true);
  await wait(700); // an unhandled rejection would fail the test
});
