// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the npm package into build/npm: `node web/npm/build.js [VERSION]`. It copies the sources that the package needs,
// unbundled, so that browsers load them as they are and bundlers find workers and modules by their addresses.
import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join, posix, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { kLanguageFiles, partOf } from '../i18n/locale_files.js';

const kRoot = fileURLToPath(new URL('../..', import.meta.url));
const kModuleFolder = process.env.QRELIEF_WASM_DIR ?? join(kRoot, 'build/wasm/wasm');
const kDecoderFolder = join(kRoot, 'node_modules/zxing-wasm');
const kPackage = join(kRoot, 'build/npm');

/** Files that start the package, or one of its workers. */
const kEntries = [
  'npm/index.js',
  'npm/node.js',
  'npm/node_thread.js',
  'engine/worker.js',
  'engine/print_worker.js',
  'decoder/scan_worker.js',
];

/** Files of the package from elsewhere, by their place in it. @type {Record<string, string>} */
const kForeign = {
  'module/qrelief.js': join(kModuleFolder, 'qrelief.js'),
  'module/qrelief.wasm': join(kModuleFolder, 'qrelief.wasm'),
  'zxing/reader/index.js': join(kDecoderFolder, 'dist/es/reader/index.js'),
  'zxing/share.js': join(kDecoderFolder, 'dist/es/share.js'),
  'zxing/zxing_reader.wasm': join(kDecoderFolder, 'dist/reader/zxing_reader.wasm'),
  'zxing/LICENSE': join(kDecoderFolder, 'LICENSE'),
  COPYING: join(kRoot, 'COPYING'),
  'options.md': join(kRoot, 'docs/options.md'),
  'README.md': join(kRoot, 'web/npm/README.md'),
};

/** Modules that the page's build resolves, by their place in the package. @type {Record<string, string>} */
const kModules = { 'qrelief-module': 'module/qrelief.js', 'zxing-wasm/reader': 'zxing/reader/index.js' };

/** Addresses that the page's build resolves. @type {Record<string, string>} */
const kAddresses = {
  'qrelief-wasm': 'module/qrelief.wasm',
  'zxing-wasm/reader/zxing_reader.wasm?url': 'zxing/zxing_reader.wasm',
};

/** The module that the package has in place of its source, and the place of a language's texts. */
const kLocales = 'i18n/locales.js';
const textsFile = (/** @type {string} */ code) => `messages/${code}.js`;

/** Returns a path as an import from a file of the package. @param {string} file @param {string} target */
function pathFrom(file, target) {
  const path = posix.relative(posix.dirname(file), target);
  return path.startsWith('.') ? path : `./${path}`;
}

/**
 * Resolves the imports that only the page's build knows.
 * @param {string} file    place in the package
 * @param {string} source
 */
export function resolved(file, source) {
  return source
    .replace(/^import (\w+) from '([^'.][^']*)';$/gm, (whole, name, from) => {
      if (!(from in kAddresses)) return whole;
      return `const ${name} = new URL('${pathFrom(file, kAddresses[from])}', import.meta.url).href;`;
    })
    .replace(/(\bfrom |\bimport\()'([^'.][^']*)'/g, (whole, before, from) =>
      from in kModules ? `${before}'${pathFrom(file, kModules[from])}'` : whole,
    );
}

/** Returns the files that a source imports when it runs. @param {string} file @param {string} source */
export function importsOf(file, source) {
  const code = source.replace(/\/\*[\s\S]*?\*\//g, '');
  return [...code.matchAll(/(?:\bfrom |\bimport\(|\bimport )'(\.[^']*)'/g)].map(([, target]) =>
    posix.join(posix.dirname(file), target),
  );
}

/** Copies the entries of the package and all that they import. */
function copySources() {
  const open = [...kEntries];
  const seen = new Set(open);
  for (let file = open.pop(); file !== undefined; file = open.pop()) {
    if (file in kForeign || file === kLocales) continue;
    const source = resolved(file, readFileSync(join(kRoot, 'web', file), 'utf8'));
    const left = /(?:\bfrom |\bimport\()'((?!\.|node:)[^']*)'/.exec(source.replace(/\/\*[\s\S]*?\*\//g, ''));
    if (left) throw new Error(`${file} imports ${left[1]}, which the package does not have`);
    write(file, source);
    for (const target of importsOf(file, source)) {
      if (!seen.has(target)) open.push(target);
      seen.add(target);
    }
  }
}

/** @param {string} file @param {string} content */
function write(file, content) {
  mkdirSync(dirname(join(kPackage, file)), { recursive: true });
  writeFileSync(join(kPackage, file), content);
}

/** @param {string} version */
function build(version) {
  rmSync(kPackage, { recursive: true, force: true });
  copySources();
  for (const [file, source] of Object.entries(kForeign)) {
    mkdirSync(dirname(join(kPackage, file)), { recursive: true });
    copyFileSync(source, join(kPackage, file));
  }
  write(kLocales, localesModule());
  for (const { code } of kLanguageFiles) {
    const texts = textsIn(code);
    write(textsFile(code), `export default ${JSON.stringify(texts)};\n`);
    write(`messages/${code}.json`, `${JSON.stringify(texts.messages, undefined, 1)}\n`);
  }
  execFileSync(join(kRoot, 'node_modules/.bin/tsc'), ['-p', join(kRoot, 'web/npm'), '--outDir', kPackage], {
    stdio: 'inherit',
  });
  const described = JSON.parse(readFileSync(new URL('package.json', import.meta.url), 'utf8'));
  write('package.json', `${JSON.stringify({ ...described, version }, undefined, 2)}\n`);
  console.log(relative(process.cwd(), kPackage));
}

/** Returns the texts of a language that sentences need. @param {string} code */
function textsIn(code) {
  const { format, page, settings } = partOf(code, 'app');
  return { app: { format, page: { settings: page.settings }, settings }, messages: partOf(code, 'messages') };
}

/** Returns the module that loads languages; English is always there. */
function localesModule() {
  const loads = kLanguageFiles.map(({ code }) => `  ${code}: () => import("../${textsFile(code)}"),\n`);
  return `import english from "../${textsFile('en')}";
export const kLanguages = ${JSON.stringify(kLanguageFiles)};
export const kEnglish = english.app;
const kLoads = {
${loads.join('')}};
export const load = async (language, part) => (await kLoads[language]()).default[part];
`;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const { version } = JSON.parse(readFileSync(join(kRoot, 'package.json'), 'utf8'));
  build(process.argv[2] ?? version);
}
