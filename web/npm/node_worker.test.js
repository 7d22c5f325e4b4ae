// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { test } from 'node:test';
import { NodeWorker } from './node_worker.js';

/** Makes a worker of a module's source. @param {string} source */
const workerOf = (source) => new NodeWorker(new URL(`data:text/javascript,${encodeURIComponent(source)}`));

test('A worker answers messages, reads files by fetch, and has ImageData', async () => {
  const worker = workerOf(`globalThis.onmessage = async ({ data }) => {
    const text = await (await fetch(data)).text();
    postMessage([text.includes('NodeWorker'), new ImageData(2, 3).data.length]);
  };`);
  const answer = await new Promise((resolve) => {
    worker.onmessage = ({ data }) => resolve(data);
    worker.postMessage(new URL('./node_worker.js', import.meta.url).href);
  });
  worker.terminate();
  assert.deepEqual(answer, [true, 24]);
});

test('A worker runs in a program whose text is given by a flag', () => {
  const program = `
    import { NodeWorker } from ${JSON.stringify(new URL('./node_worker.js', import.meta.url).href)};
    const worker = new NodeWorker(new URL('data:text/javascript,globalThis.onmessage=()=>{};postMessage("runs")'));
    for (const event of ['onmessage', 'onerror'])
      worker[event] = ({ data, message }) => { console.log(data ?? message); worker.terminate(); };`;
  const said = execFileSync(process.execPath, ['--input-type=module', '-e', program], { encoding: 'utf8' });
  assert.equal(said, 'runs\n');
});

test('A worker that fails reports it', async () => {
  const worker = workerOf("throw new Error('broken');");
  const reason = await new Promise((resolve) => {
    worker.onerror = ({ message }) => resolve(message);
  });
  assert.equal(reason, 'broken');
});
