// SPDX-License-Identifier: GPL-3.0-or-later
// The module as Emscripten writes it; vite.config.js says where it lies.

declare module 'qrelief-module' {
  const createQRelief: (options: { locateFile: (path: string) => string }) => Promise<import('./types.js').QReliefModule>;
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
