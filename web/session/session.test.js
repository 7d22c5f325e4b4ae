// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { BatchPanel } from '../ui/batch_panel.js';
import { CodePanel } from '../ui/code_panel.js';
import { FacePicker } from '../ui/face_picker.js';
import { WorkPanel } from '../ui/work_panel.js';
import { LiveView } from '../view/live_view.js';
import { ViewTools } from '../view/view_tools.js';
import { Batching } from './batching.js';
import { Carving } from './carving.js';
import { Placing } from './placing.js';
import { Session } from './session.js';
import { Signal } from './signal.js';
import { SpotSearch } from './spot_search.js';
import { Pending, fake, settled, storeOf } from './testing.js';
import { Undo } from './undo.js';

/** @type {any} */ let parts;
/** @type {string[]} */ let order; // of what a new model leads to
/** @type {any} */ let user;
/** @type {Session} */ let session;

beforeEach(() => {
  order = [];
  const store = storeOf();
  store.applied.on(() => void order.push('applied'));
  const noted = (/** @type {string} */ name) => async () => void order.push(name);
  const batching = fake(Batching, { ready: noted('planned'), incomplete: false }, { changed: new Signal() });
  parts = {
    store,
    batching,
    model: { engravable: true },
    jobs: { busy: false, cancel: noted('cancelled') },
    spots: fake(SpotSearch, {}, { proposed: Promise.resolve() }),
    placing: fake(Placing, { begin: noted('placed') }),
    carving: fake(Carving, { drop: noted('dropped'), engrave: noted('carved') }),
    undo: fake(Undo, { asOne: (/** @type {() => Promise<void>} */ action) => action() }),
    code: fake(CodePanel, { incomplete: false }),
    batchPanel: fake(BatchPanel),
    workPanel: fake(WorkPanel, { listen: (/** @type {any} */ listener) => void (user = listener) }),
    tools: fake(ViewTools),
    live: fake(LiveView),
    picker: fake(FacePicker),
    guard: (/** @type {() => Promise<unknown>} */ action) => action(),
  };
  session = new Session(parts);
});

test('A new model drops the carving before placing the code', async () => {
  await session.useModel();
  assert.deepEqual(order, ['dropped', 'applied', 'placed']);
  assert.deepEqual(parts.spots.calls, ['setDisabled ', 'clear', 'begin']);
});

test('A code on a new model is shown as carved again, however long that took on the last model', async () => {
  await session.useModel();
  assert.deepEqual(parts.live.calls, ['reset']);
});

test('Engraving is disabled without a model, during jobs and on unsuitable models, and says why', () => {
  session.updateControls();
  parts.jobs.busy = true;
  session.updateControls();
  Object.assign(parts, { jobs: { busy: false }, model: { engravable: false, info: {} } });
  session.updateControls();
  parts.model.info = undefined;
  session.updateControls();
  const why = ['', 'page.whyBusy', 'page.notEngravable', 'page.whyNoModel'];
  assert.deepEqual(
    parts.workPanel.calls.slice(1),
    why.map((key) => `setEngraveDisabled ${key}`),
  );
  assert.deepEqual(
    parts.picker.calls,
    why.map((key) => `setDisabled ${key}`),
  );
});

test('Engraving waits for the spot that is being proposed', async () => {
  const proposed = new Pending();
  parts.spots.proposed = proposed.promise;
  const engraving = user.onEngrave();
  await settled();
  assert.deepEqual(order, ['planned']);
  proposed.resolve();
  await engraving;
  assert.deepEqual(order, ['planned', 'carved']);
});

test('Missing input is revealed instead of engraving', async () => {
  await user.onEngrave();
  assert.deepEqual(order, ['planned', 'carved']);
  parts.code.answers.incomplete = true;
  await user.onEngrave();
  assert.deepEqual(parts.code.calls, ['reveal']);
  parts.batching.answers.incomplete = true;
  await user.onEngrave();
  assert.deepEqual(parts.batchPanel.calls, ['reveal']);
  assert.equal(order.filter((step) => step === 'carved').length, 1);
});

test('With a list the button names the first part', () => {
  parts.batching.changed.emit({});
  parts.batching.changed.emit(undefined);
  assert.deepEqual(parts.workPanel.calls.slice(1), ['nameEngrave batch.engraveFirst', 'nameEngrave page.engrave']);
});
