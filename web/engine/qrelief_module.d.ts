// SPDX-License-Identifier: GPL-3.0-or-later
// The module as Emscripten writes it; vite.config.js says where it lies.

declare module 'qrelief-module' {
  type Receive = (instance: WebAssembly.Instance) => void;
  const createQRelief: (options: { instantiateWasm: (imports: WebAssembly.Imports, receive: Receive) => object }) =>
    Promise<import('./types.js').QReliefModule>;
  export default createQRelief;
}

declare module 'qrelief-wasm' {
  const url: string;
  export default url;
}

declare module 'qrelief-inspector-wasm' {
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
