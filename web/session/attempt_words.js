// SPDX-License-Identifier: GPL-3.0-or-later
// Words for the attempts of an engraving: what an attempt changes, why it is made, and what became of it.
import { text } from '../i18n/catalogue.js';

/** @typedef {import('./work.js').Work} Work */
/** @typedef {import('../i18n/live.js').Words} Words */
/** @typedef {'failed' | 'fine' | 'unread' | 'print-barely' | 'print-unread'} Reason */

/** By what an attempt changes: words while it is made, and words for the result. */
const kWords = /** @type {const} */ ({
  mark: ['page.tryColour', 'page.engravedInColour'],
  text: ['page.tryCapitals', 'page.engravedCapitals'],
  size: ['page.tryLarger', 'page.engravedLarger'],
  ecc: ['page.trySmallerSymbol', 'page.engravedSmallerSymbol'],
  carveFor: ['page.tryDesign', 'page.engravedForDesign'],
  preset: ['page.tryDeeper', 'page.engravedDeeper'],
});

const kReasons = /** @type {const} */ ({
  failed: 'page.sinceFailed',
  fine: 'page.sinceFine',
  unread: 'page.sinceUnread',
  'print-barely': 'page.sincePrintBarely',
  'print-unread': 'page.sincePrintUnread',
});

/** Returns the change that says most about an attempt. @param {Work} work @param {Work} asked @returns {keyof typeof kWords} */
function changeOf({ text: content, settings }, { text: askedContent, settings: asked }) {
  if (settings.mark !== asked.mark) return 'mark';
  if (content !== askedContent) return 'text';
  if (settings.size !== asked.size || settings.maxSizeMm !== asked.maxSizeMm) return 'size';
  if (settings.ecc !== asked.ecc) return 'ecc';
  return settings.preset === asked.preset ? 'carveFor' : 'preset';
}

/** Says what an attempt changes, and why it is made. @param {Work} work @param {Work} asked @param {Reason} reason @returns {Words} */
export function attemptWords(work, asked, reason) {
  const [trying] = kWords[changeOf(work, asked)];
  return () => text(kReasons[reason], { attempt: text(trying) });
}

/**
 * Says what the kept attempt changed.
 * @param {Work} work
 * @param {Work} asked
 * @param {boolean} [forPrint]  the change was made for the print
 */
export function engravedWords(work, asked, forPrint = false) {
  const change = changeOf(work, asked);
  if (work.settings.content === 'text' && change !== 'mark') return text('page.engravedTextLarger');
  return text(forPrint && change === 'preset' ? 'page.engravedForPrint' : kWords[change][1]);
}
