// SPDX-License-Identifier: GPL-3.0-or-later
// Part of the build: writes the service worker with the lists of the files it keeps, and the files for search engines.
import { createHash } from 'node:crypto';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const kSource = fileURLToPath(new URL('service_worker.js', import.meta.url));
const kWorker = 'service_worker.js';
const kNotKept = new Set([kWorker, 'robots.txt', 'sitemap.xml']);
const kNeverKept = /^api\//; // thousands of pages, which need a network anyway
/**
 * Files of which most visitors need few: articles with their scripts, styles and pictures, languages but English, icons,
 * and all samples but the first.
 */
const kKeptWhenOpened =
  /^(guide|method|study|gallery)(\.html$|\/)|^assets\/(article|guide|method|study|gallery)-|^assets\/(?!en-(app|messages)-)\w\w-(app|messages|inspector|guide|method|study|gallery)-|\.jpg$|^icons\/|^samples\/(?!bunny|manifest)/;

/** @param {string | Uint8Array} content */
const hashOf = (content) => createHash('sha256').update(content).digest('hex').slice(0, 16);

/**
 * Lists every file below a folder with the hash of its content, sorted by path, without hidden files.
 * @param {string} folder
 * @returns {[path: string, hash: string][]}
 */
export function listFiles(folder) {
  return readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && !entry.name.startsWith('.'))
    .map((entry) => `${entry.parentPath}/${entry.name}`.slice(folder.length + 1).replaceAll('\\', '/'))
    .filter((path) => !kNotKept.has(path) && !kNeverKept.test(path))
    .sort()
    .map((path) => [path, hashOf(readFileSync(`${folder}/${path}`))]);
}

/** Tells whether a file is kept at the first visit, not only once it is opened. @param {string} path */
export const isKeptAtOnce = (path) => !kKeptWhenOpened.test(path);

/**
 * Returns the service worker for a built page. Its version changes with any file and with its own source.
 * @param {[path: string, hash: string][]} files
 * @returns {string}
 */
export function serviceWorkerFor(files) {
  const source = readFileSync(kSource, 'utf8');
  const build = {
    version: hashOf(JSON.stringify(files) + source),
    files: files.filter(([path]) => isKeptAtOnce(path)),
    whenOpened: files.map(([path]) => path).filter((path) => !isKeptAtOnce(path)),
  };
  return `self.qreliefBuild = ${JSON.stringify(build)};\n${source}`;
}

/**
 * @param {string} site     address of the published page, with a slash at its end
 * @param {string[]} pages
 */
const sitemap = (site, pages) =>
  [
    '<?xml version="1.0" encoding="UTF-8"?>',
    '<urlset xmlns="http://www.sitemaps.org/schemas/sitemap/0.9">',
    ...pages.map((page) => `  <url><loc>${site}${page === 'index.html' ? '' : page}</loc></url>`),
    '</urlset>',
    '',
  ].join('\n');

/**
 * @param {{ site?: string }} options  `site`: address of the published page; without it there is no sitemap
 * @returns {import('vite').Plugin}
 */
export function offline({ site }) {
  let folder = '';
  return {
    name: 'qrelief-offline',
    apply: 'build',
    configResolved: (config) => {
      folder = config.build.outDir;
    },
    closeBundle: () => {
      const files = listFiles(folder);
      writeFileSync(`${folder}/${kWorker}`, serviceWorkerFor(files));
      const robots = ['User-agent: *', 'Allow: /'];
      if (site) {
        const home = site.endsWith('/') ? site : `${site}/`;
        robots.push(`Sitemap: ${home}sitemap.xml`);
        writeFileSync(
          `${folder}/sitemap.xml`,
          sitemap(
            home,
            files.map(([path]) => path).filter((path) => path.endsWith('.html')),
          ),
        );
      }
      writeFileSync(`${folder}/robots.txt`, `${robots.join('\n')}\n`);
    },
  };
}
