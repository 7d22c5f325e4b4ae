// SPDX-License-Identifier: GPL-3.0-or-later
// Part of the build: puts the kept pictures (script/gallery), with their captions, into gallery.html.
import { readFileSync } from 'node:fs';
import { escaped } from '../../web/i18n/fill.js';
import { partOf } from '../../web/i18n/locale_files.js';
import { inEach } from '../page/markup.js';
import { mm, name, said, sentence } from '../page/say.js';
import { kFinders, kPatterns, kPicturesFolder, readGallery } from './exhibits.js';

/** @typedef {import('../page/say.js').Language} Language */
/** @typedef {import('./exhibits.js').Exhibit} Exhibit */
/** @typedef {import('./exhibits.js').Room} Room */

const kFolder = 'gallery';

/** Returns the address of the app with this code, to carve at once. @param {string} sample @param {Exhibit} exhibit */
const addressOf = (sample, { settings }) => `./?${new URLSearchParams({ sample, ...settings, engrave: '1' })}`;

/** @param {Language} language @param {import('../page/say.js').Said} one */
const words = (language, one) => escaped(sentence(language, one));

/** @param {Language} language @param {string} sample @param {Exhibit} exhibit @param {import('../page/say.js').Said} title */
function card(language, sample, exhibit, title) {
  const { designed, printed, depthMm, reads, printedReads, tries } = exhibit;
  const picture = (/** @type {string} */ file, /** @type {'galleryDesigned' | 'galleryPrinted'} */ what) =>
    `<img src="${kFolder}/${file}" alt="${words(language, said(what))}" width="156" height="156" loading="lazy" />`;
  return `<a class="exhibit" href="${escaped(addressOf(sample, exhibit))}"><span class="pair">${picture(designed, 'galleryDesigned')}${picture(printed, 'galleryPrinted')}</span>
<strong>${words(language, title)}</strong>
<span>${words(language, said('galleryFacts', { depth: mm(depthMm), reads, printed: printedReads, tries }))}</span></a>`;
}

/** @param {Language} language @param {string} sample */
const titleOf = (language, sample) => escaped(partOf(language, 'app').page.samples[sample] ?? sample);

/** @param {Language} language @param {Room} room */
function roomMarkup(language, { sample, exhibits }) {
  const title = titleOf(language, sample);
  const titles = { default: said('galleryDefault'), lamp: said('galleryLamp') };
  const usual = exhibits
    .filter(({ kind }) => kind !== 'pattern')
    .map((exhibit) => card(language, sample, exhibit, titles[/** @type {'default' | 'lamp'} */ (exhibit.kind)]))
    .join('\n');
  const patterned = exhibits.filter(({ kind }) => kind === 'pattern');
  const at = (/** @type {string} */ pattern, /** @type {string} */ finders) =>
    patterned.find(({ settings }) => settings.pattern === pattern && settings.finderPattern === finders);
  const rows = kPatterns
    .map(
      (pattern) =>
        `<tr>${kFinders
          .map((finders) => {
            const exhibit = at(pattern, finders);
            const patterns = said('carvingPattern', {
              modules: name('pattern', pattern),
              finders: name('finder', finders),
            });
            return `<td>${exhibit ? card(language, sample, exhibit, patterns) : ''}</td>`;
          })
          .join('')}</tr>`,
    )
    .join('\n');
  const table =
    patterned.length > 0
      ? `<details><summary><h3>${words(language, said('galleryPatterns'))}</h3></summary>
<div class="scroll" tabindex="0" role="region" aria-label="${title}: ${words(language, said('galleryPatterns'))}"><table class="matrix"><tbody>${rows}</tbody></table></div></details>`
      : '';
  return `<h2>${title}</h2>\n<div class="exhibits">${usual}</div>\n${table}`;
}

/**
 * Returns links to all samples, then every sample with its codes. Closed details load no pictures.
 * @param {Room[]} rooms
 * @returns {string}
 */
export function galleryMarkup(rooms) {
  const links = (/** @type {Language} */ language) => {
    const items = rooms.map(({ sample }) => `<li><a href="#${sample}">${titleOf(language, sample)}</a></li>`);
    return `<ul class="sample-links">${items.join('')}</ul>`;
  };
  const sections = rooms.map(
    (room) => `<div id="${room.sample}">\n${inEach('section', (language) => roomMarkup(language, room))}\n</div>`,
  );
  return [inEach('div', links), ...sections].join('\n');
}

/** @returns {import('vite').Plugin} */
export function gallery() {
  const bytesOf = (/** @type {string} */ file) => readFileSync(`${kPicturesFolder}/${file}`);
  const files = () =>
    readGallery().flatMap(({ exhibits }) => exhibits.flatMap(({ designed, printed }) => [designed, printed]));
  return {
    name: 'qrelief-gallery',
    transformIndexHtml: {
      order: 'post', // otherwise Vite would look for the pictures itself
      handler: (html, { path }) =>
        path.endsWith('gallery.html') ? html.replace('<div data-gallery></div>', galleryMarkup(readGallery())) : html,
    },
    generateBundle() {
      for (const file of files())
        this.emitFile({ type: 'asset', fileName: `${kFolder}/${file}`, source: bytesOf(file) });
    },
    configureServer(server) {
      server.middlewares.use(`/${kFolder}`, (request, response, next) => {
        const file = files().find((name) => request.url === `/${name}`);
        if (file === undefined) next();
        else response.setHeader('Content-Type', 'image/webp').end(bytesOf(file));
      });
    },
  };
}
