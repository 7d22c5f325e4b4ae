// SPDX-License-Identifier: GPL-3.0-or-later
// Loads the WebAssembly module.
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
 * @param {Compile} [compile]
 * @returns {Promise<QReliefModule>}
 * @throws {EngineFailure}
 */
export async function loadModule(compile = compileFetched) {
  const start = async () => {
    // As a chunk of its own, the page and its workers load one file.
    const [{ default: createQRelief }, compiled] = await Promise.all([import('qrelief-module'), compile(wasmUrl)]);
    return /** @type {Promise<QReliefModule>} */ (
      new Promise((resolve, reject) => {
        /** @param {WebAssembly.Imports} imports @param {(instance: WebAssembly.Instance) => void} receive */
        const instantiate = async (imports, receive) => receive(await WebAssembly.instantiate(compiled, imports));
        createQRelief({
          instantiateWasm: (imports, receive) => {
            instantiate(imports, receive).catch(reject);
            return {}; // `receive` gets the exports later
          },
        }).then(resolve, reject);
      })
    );
  };
  try {
    return await start();
  } catch (thrown) {
    throw new EngineFailure(internal(message('engine-not-started', { detail: { term: detailOf(thrown) } })));
  }
}
