// SPDX-License-Identifier: GPL-3.0-or-later
// Loads the module in two parts: the main part at once, the inspector on demand. Both share one memory and one table of
// functions (wasm/split_inspector.js).
import inspectorUrl from 'qrelief-inspector-wasm';
import createQRelief from 'qrelief-module';
import wasmUrl from 'qrelief-wasm';
import { EngineFailure, internal } from './engine_error.js';
import { message } from './message.js';

/**
 * Emscripten's tables of WebGL objects by their OpenGL names; null for deleted objects.
 * @typedef {Record<'buffers' | 'programs' | 'framebuffers' | 'renderbuffers' | 'textures' | 'shaders' | 'vaos' | 'queries' | 'syncs',
 *   (object | null)[]>} GlTables
 */

/**
 * @typedef {object} QReliefModule
 * @property {new () => import('./types.js').ModuleObject & { memoryInUse: () => number }} Engine  `memoryInUse`: bytes of the heap
 * @property {new () => import('./types.js').ModuleObject} PrintedCode
 * @property {new () => import('./types.js').ModuleObject} PlannedBatch
 * @property {new () => import('./types.js').ModuleObject} TrackedBatch
 * @property {new () => import('./types.js').ModuleObject} Facts
 * @property {{ registerContext: (gl: WebGL2RenderingContext, attributes: { majorVersion: number }) => number,
 *   makeContextCurrent: (handle: number) => boolean } & GlTables} GL
 * @property {Uint8Array} HEAPU8
 */

/** Placeholders for the inspector's functions, by their index in the table, until the inspector is loaded. */
const kPlaceholders = new Proxy(
  {},
  {
    get: (_, place) => () => {
      throw new Error(`the inspector was called before it was loaded (${String(place)})`);
    },
  },
);

/** @typedef {(url: string) => Promise<WebAssembly.Module>} Compile */

/** @type {Compile} */
async function compileFetched(url) {
  const response = await fetch(url, { credentials: 'same-origin' });
  if (!response.ok) throw new Error(`${response.status} ${response.statusText}`.trim());
  const isTyped = response.headers.get('Content-Type') === 'application/wasm'; // required to compile while downloading
  return isTyped ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

/** @param {unknown} thrown */
const detailOf = (thrown) => (thrown instanceof Error ? thrown.message : String(thrown));

/**
 * Loads the main part.
 * @param {Compile} [compile]
 * @returns {Promise<{ module: QReliefModule, loadInspector: () => Promise<void> }>}
 * @throws {EngineFailure}
 */
export async function loadModule(compile = compileFetched) {
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
          return {}; // `receive` gets the exports later
        },
      }).then(resolve, reject);
    });
  }

  async function addInspector() {
    await WebAssembly.instantiate(await compile(inspectorUrl), {
      primary: /** @type {WebAssembly.Instance} */ (first).exports,
    });
  }

  async function loadInspector() {
    second ??= addInspector();
    try {
      await second;
    } catch (thrown) {
      second = undefined; // allows another attempt
      throw new EngineFailure(internal(message('inspector-not-loaded', { detail: { term: detailOf(thrown) } })));
    }
  }

  try {
    return { module: await start(), loadInspector };
  } catch (thrown) {
    throw new EngineFailure(internal(message('engine-not-started', { detail: { term: detailOf(thrown) } })));
  }
}
