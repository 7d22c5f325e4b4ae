// SPDX-License-Identifier: GPL-3.0-or-later
// Types of the files that Emscripten writes; vite.config.js resolves their paths.

declare module 'qrelief-module' {
  type Receive = (instance: WebAssembly.Instance) => void;
  const createQRelief: (options: { instantiateWasm: (imports: WebAssembly.Imports, receive: Receive) => object }) =>
    Promise<import('./module.js').QReliefModule>;
  export default createQRelief;
}

declare module 'qrelief-wasm' {
  const url: string;
  export default url;
}

declare module '*.wasm?url' {
  const url: string;
  export default url;
}

interface ImportMeta {
  readonly env: { readonly BASE_URL: string; readonly PROD: boolean };
}
