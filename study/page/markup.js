// SPDX-License-Identifier: GPL-3.0-or-later
// Figures and the sentences about them as markup, in every language; article.css shows the page's language.
import { escaped } from '../../web/i18n/fill.js';
import { isKnown, kLanguages, said, sentence } from './say.js';

/** @typedef {import('./say.js').Language} Language */
/** @typedef {import('./figure.js').Figure} Figure */
/** @typedef {import('./say.js').Said} Said */
/** @typedef {{ path: string, width: number, height: number }} Drawn */
/**
 * @typedef {object} Shown
 * @property {Figure} figure
 * @property {Record<Language, { wide: Drawn, narrow: Drawn }>} drawn
 * @property {Said[]} found
 * @property {{ path: string, cases: number, failed: number }} table
 */

const kNarrowest = '(max-width: 760px)'; // pages whose column is narrower than a wide figure

/**
 * Returns an element in each language, one of which is shown.
 * @param {string} tag
 * @param {(language: Language) => string} content
 */
export const inEach = (tag, content) =>
  kLanguages
    .map((language) => `<${tag} lang="${language}" class="in-${language}">${content(language)}</${tag}>`)
    .join('\n');

/** @param {Language} language @param {Said[]} sentences */
const paragraph = (language, sentences) => escaped(sentences.map((one) => sentence(language, one)).join(' '));

/** @param {Shown} shown @param {Language} language */
function picture({ figure, drawn }, language) {
  const { wide, narrow } = drawn[language];
  const alt = escaped(sentence(language, said(/** @type {any} */ (`${figure.name}Alt`))));
  return `<picture>
<source media="${kNarrowest}" srcset="${narrow.path}" width="${narrow.width}" height="${narrow.height}" />
<img src="${wide.path}" width="${wide.width}" height="${wide.height}" alt="${alt}" loading="lazy" />
</picture>`;
}

/** @param {Shown} entry @returns {string} */
export function figureMarkup(entry) {
  const { figure, found, table } = entry;
  const what = said(/** @type {any} */ (`${figure.name}Shown`));
  const caption = (/** @type {Language} */ language) =>
    `${paragraph(language, [what])} ` +
    `<a href="${table.path}" download>${paragraph(language, [said('download', { count: table.cases })])}</a>`;
  const sentences = [
    ...found.filter(isKnown),
    ...(table.failed > 0 ? [said('failed', { count: table.failed, of: table.cases })] : []),
  ];
  return `${inEach('p', (language) => paragraph(language, sentences))}
${inEach('figure', (language) => `<div class="chart">${picture(entry, language)}</div>\n<figcaption>${caption(language)}</figcaption>`)}`;
}

/**
 * Returns a finding: its number beside its bars, and a link to the figure behind it.
 * @param {import('./findings.js').Finding} finding
 * @param {string} section  id of the figure's section
 */
export function findingMarkup(
  { title, number, says, bars, whole = Math.max(...bars.map(({ value }) => value)) },
  section,
) {
  const rows = (/** @type {Language} */ language) =>
    bars.map(({ label, value, said: words, isOurs }) => {
      const width = Math.round((1000 * value) / whole) / 10;
      const bar = `<svg class="bar-line${isOurs ? ' ours' : ''}" aria-hidden="true"><rect width="${width}%" height="100%" rx="2" /></svg>`;
      return `<tr><th scope="row">${paragraph(language, [label])}</th><td>${bar}</td><td>${paragraph(language, [words])}</td></tr>`;
    });
  return inEach('section', (language) => {
    const heading = paragraph(language, [said(title)]);
    return `<h3>${heading}</h3>
<p><strong class="number">${paragraph(language, [number])}</strong> ${paragraph(language, says)} <a href="#${section}">${paragraph(language, [said('findingMore')])}</a></p>
<table class="bars" aria-label="${heading}"><tbody>${rows(language).join('\n')}</tbody></table>`;
  });
}

/**
 * Words, and a link to a section of the page after them.
 * @typedef {{ words: Said[], link?: { words: Said, section: string } }} Cell
 */

/**
 * Returns a table in each language; the first cell of a row names it.
 * @param {Said[]} head
 * @param {Cell[][]} body
 */
export const tableMarkup = (head, body) =>
  inEach('table', (language) => {
    const cell = (/** @type {Cell} */ { words, link }) =>
      paragraph(language, words) + (link ? ` <a href="#${link.section}">${paragraph(language, [link.words])}</a>` : '');
    const rows = body.map(
      ([name, ...cells]) =>
        `<tr><th scope="row">${cell(name)}</th>${cells.map((one) => `<td>${cell(one)}</td>`).join('')}</tr>`,
    );
    return `<thead><tr>${head.map((one) => `<th scope="col">${paragraph(language, [one])}</th>`).join('')}</tr></thead>\n<tbody>${rows.join('\n')}</tbody>`;
  });

/** Returns a link to download a file. @param {string} path @param {Said} words */
export const linkMarkup = (path, words) =>
  inEach('p', (language) => `<a href="${path}" download>${paragraph(language, [words])}</a>`);

/** @param {Said[]} sentences */
export const textMarkup = (sentences) => inEach('p', (language) => paragraph(language, sentences));

/** Returns the text shown instead of a table that has not been measured. */
export const missingMarkup = () => textMarkup([said('notMeasured')]);
