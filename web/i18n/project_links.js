// SPDX-License-Identifier: GPL-3.0-or-later
// Part of the build: links the project's source and issue tracker in the footers, if package.json has their addresses
// (`repository` and `bugs`).
import { escaped } from './fill.js';

/** @typedef {string | { url?: string }} Address  as in package.json */
/** @typedef {{ repository?: Address, bugs?: Address }} Project */

const kPlace = /[^\S\n]*<p data-project-links><\/p>\n/;

/** Returns an address that a browser opens, or undefined. @param {Address | undefined} address */
function webAddress(address) {
  const url = (typeof address === 'string' ? address : (address?.url ?? ''))
    .replace(/^git\+/, '')
    .replace(/\.git$/, '');
  return url.startsWith('https://') ? url : undefined;
}

/**
 * Fills the place for the links, or removes it.
 * @param {string} html
 * @param {Project} project
 */
export function linkProject(html, { repository, bugs }) {
  const links = /** @type {const} */ ([
    ['links.source', webAddress(repository)],
    ['links.issues', webAddress(bugs)],
  ]).flatMap(([words, url]) => (url ? [`<a href="${escaped(url)}" rel="noreferrer" data-text="${words}"></a>`] : []));
  return html.replace(kPlace, () =>
    links.length > 0 ? `<p class="links project-links">${links.join(' ')}</p>\n` : '',
  );
}
