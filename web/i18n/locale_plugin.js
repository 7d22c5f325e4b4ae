// SPDX-License-Identifier: GPL-3.0-or-later
// Build plugin: replaces locales.js by imports, a module for each part of each language, so that the page loads only the
// parts it shows.
import { kLanguageFiles, partOf } from './locale_files.js';

/** @typedef {import('./locale_files.js').Part} Part */

/** @type {Part[]} */
const kParts = ['app', 'messages', 'inspector'];
/** @type {Part[]} */
const kArticles = ['guide', 'method', 'gallery', 'study'];
const kPrefix = '\0locale/';

/** Returns the module that the page loads in place of locales.js. */
export function localesModule() {
  const loads = kLanguageFiles.flatMap(({ code, hasArticles }) =>
    [...kParts, ...(hasArticles ? kArticles : [])].map(
      (part) => `  '${code}-${part}': () => import('locale/${code}-${part}'),\n`,
    ),
  );
  return `import kEnglish from 'locale/en-app';
export { kEnglish };
export const kLanguages = ${JSON.stringify(kLanguageFiles)};
const kLoads = {
${loads.join('')}};
export const load = async (language, part) => (await kLoads[\`\${language}-\${part}\`]()).default;
`;
}

/** Returns the module of a part. @param {string} name  "de-app" */
export function partModule(name) {
  const [code, part] = name.split('-');
  return `export default ${JSON.stringify(partOf(code, /** @type {Part} */ (part)))};`;
}

/** @returns {import('vite').Plugin} */
export function locales() {
  return {
    name: 'qrelief-locales',
    resolveId: { filter: { id: /^locale\// }, handler: (id) => `\0${id}` },
    load: {
      filter: { id: /\/i18n\/locales\.js$|^\0locale\// },
      handler: (id) => (id.startsWith(kPrefix) ? partModule(id.slice(kPrefix.length)) : localesModule()),
    },
  };
}
