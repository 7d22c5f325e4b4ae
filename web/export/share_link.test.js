// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { shareLink } from './share_link.js';

const kLink = 'https://example.org/?text=x';

/**
 * Shares the link in a browser with these abilities.
 * @param {{ share?: () => Promise<void>, copy?: () => Promise<void> }} abilities
 */
async function shared({ share, copy }) {
  /** @type {string[]} */ const used = [];
  const way = await shareLink(kLink, {
    navigator: {
      ...(share && { share: ({ url } = {}) => share().then(() => void used.push(`share ${url}`)) }),
      ...(copy && { clipboard: { writeText: (text) => copy().then(() => void used.push(`copy ${text}`)) } }),
    },
    history: { replaceState: (_state, _title, url) => void used.push(`show ${url}`) },
  });
  return [way, ...used];
}

const works = () => Promise.resolve();
const fails = (/** @type {string} */ name) => () => Promise.reject(new DOMException('', name));

test('the link goes to the share sheet, else to the clipboard, else into the address bar', async () => {
  assert.deepEqual(await shared({ share: works, copy: works }), ['linkShared', `share ${kLink}`]);
  assert.deepEqual(await shared({ copy: works }), ['linkCopied', `copy ${kLink}`]);
  assert.deepEqual(await shared({}), ['linkShown', `show ${kLink}`]);
});

test('a share sheet that fails leaves the clipboard, and a clipboard that refuses the address bar', async () => {
  assert.deepEqual(await shared({ share: fails('NotAllowedError'), copy: works }), ['linkCopied', `copy ${kLink}`]);
  assert.deepEqual(await shared({ copy: fails('NotAllowedError') }), ['linkShown', `show ${kLink}`]);
});

test('a share sheet that the user closes does nothing else', async () => {
  assert.deepEqual(await shared({ share: fails('AbortError'), copy: works }), ['cancelled']);
});
