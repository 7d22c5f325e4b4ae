// SPDX-License-Identifier: GPL-3.0-or-later
// Loads the module in its two parts: all that the page needs at first, and the inspector once it is wanted. Both share
// one memory and one table of functions (wasm/split_inspector.js).
import inspectorUrl from 'qrelief-inspector-wasm';
import createQRelief from 'qrelief-module';
import wasmUrl from 'qrelief-wasm';
import { EngineFailure, internal } from './engine_error.js';
import { message } from './message.js';

/** @typedef {import('./types.js').QReliefModule} QReliefModule */

/** Stands for what the second part holds, by the name of its place in the table, until that is there. */
const kPlaceholders = new Proxy({}, {
  get: (_, place) => () => {
    throw new Error(`the inspector was called before it was loaded (${String(place)})`);
  },
});

/** @param {string} url @returns {Promise<WebAssembly.Module>} */
async function compile(url) {
  const response = await fetch(url, { credentials: 'same-origin' });
  if (!response.ok) throw new Error(`${response.status} ${response.statusText}`.trim());
  const isTyped = response.headers.get('Content-Type') === 'application/wasm';  // else it cannot be compiled on the way
  return isTyped ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

/** @param {unknown} thrown */
const detailOf = (thrown) => (thrown instanceof Error ? thrown.message : String(thrown));

/** @returns {Promise<{ module: QReliefModule, loadInspector: () => Promise<void> }>}  what it rejects with can be shown */
export async function loadModule() {
  /** @type {WebAssembly.Instance | undefined} */ let first;
  /** @type {Promise<unknown> | undefined} */ let second;

  /** @param {WebAssembly.Imports} imports @param {(instance: WebAssembly.Instance) => void} receive */
  async function instantiate(imports, receive) {
    first = await WebAssembly.instantiate(await compile(wasmUrl), { ...imports, inspector: kPlaceholders });
    receive(first);
  }

  function start() {
    return new Promise((resolve, reject) => {
      createQRelief({
        instantiateWasm: (imports, receive) => {
          instantiate(imports, receive).catch(reject);
          return {};  // it comes later
        },
      }).then(resolve, reject);
    });
  }

  async function addInspector() {
    await WebAssembly.instantiate(await compile(inspectorUrl), { primary: /** @type {WebAssembly.Instance} */ (first).exports });
  }

  async function loadInspector() {
    second ??= addInspector();
    try {
      await second;
    } catch (thrown) {
      second = undefined;  // the network may be back the next time
      throw new EngineFailure(internal(message('inspector-not-loaded', { detail: { term: detailOf(thrown) } })));
    }
  }

  try {
    return { module: await start(), loadInspector };
  } catch (thrown) {
    throw new EngineFailure(internal(message('engine-not-started', { detail: { term: detailOf(thrown) } })));
  }
}
