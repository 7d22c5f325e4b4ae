// SPDX-License-Identifier: GPL-3.0-or-later
import { existsSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { gallery } from './study/gallery/build_plugin.js';
import { study } from './study/page/build_plugin.js';
import { offline } from './web/offline/build_plugin.js';
import { withArticleFooter } from './web/i18n/article_footer.js';
import { fillTexts } from './web/i18n/fill.js';
import { locales } from './web/i18n/locale_plugin.js';
import { linkProject } from './web/i18n/project_links.js';

const root = fileURLToPath(new URL('.', import.meta.url));
const moduleFolder = process.env.QRELIEF_WASM_DIR ?? `${root}build/wasm/wasm`;

/** The policy for a page of this origin: it fetches nothing from other origins and sends nothing to them. */
const kPolicy = [
  "default-src 'none'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "worker-src 'self'",
  "connect-src 'self'",
  "style-src 'self'",
  "img-src 'self' data:",
  "manifest-src 'self'",
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

/** @returns {import('vite').Plugin} */
function requireModule() {
  return {
    name: 'qrelief-require-module',
    buildStart() {
      for (const file of ['qrelief.js', 'qrelief.wasm']) {
        if (!existsSync(`${moduleFolder}/${file}`)) {
          this.error(
            `${moduleFolder}/${file} is not there: build the module first (cmake --preset wasm && cmake --build --preset wasm)`,
          );
        }
      }
    },
  };
}

/**
 * Adds the policy to built pages only, since the development server inserts scripts and styles into the page.
 * @returns {import('vite').Plugin}
 */
function contentSecurityPolicy() {
  return {
    name: 'qrelief-content-security-policy',
    apply: 'build',
    transformIndexHtml: () => [
      { tag: 'meta', attrs: { 'http-equiv': 'Content-Security-Policy', content: kPolicy }, injectTo: 'head-prepend' },
    ],
  };
}

/** @returns {import('vite').Plugin} */
function texts() {
  const project = JSON.parse(readFileSync(`${root}package.json`, 'utf8'));
  return {
    name: 'qrelief-texts',
    transformIndexHtml: { order: 'pre', handler: (html) => fillTexts(linkProject(withArticleFooter(html), project)) },
  };
}

export default defineConfig({
  root: `${root}web`,
  base: './',
  publicDir: `${root}public`,
  resolve: {
    alias: { 'qrelief-module': `${moduleFolder}/qrelief.js`, 'qrelief-wasm': `${moduleFolder}/qrelief.wasm?url` },
  },
  plugins: [
    requireModule(),
    texts(),
    locales(),
    study({ tables: `${root}study/results` }),
    gallery(),
    contentSecurityPolicy(),
    offline({ site: process.env.QRELIEF_SITE }),
  ],
  worker: { format: 'es' },
  build: {
    outDir: `${root}dist`,
    emptyOutDir: true,
    target: 'es2022',
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    rolldownOptions: {
      input: ['index', 'guide', 'method', 'study', 'gallery'].map((page) => `${root}web/${page}.html`),
    },
  },
  server: { fs: { allow: [root, moduleFolder] } },
});
