// SPDX-License-Identifier: GPL-3.0-or-later
// Hands a link on: by the device's share sheet, else the clipboard, else the address bar.

/** @typedef {'linkShared' | 'linkCopied' | 'linkShown' | 'cancelled'} Way */

/**
 * @param {string} link  of this page
 * @param {{ navigator: { share?: Navigator['share'], clipboard?: Pick<Clipboard, 'writeText'> },
 *   history: Pick<History, 'replaceState'> }} browser
 * @returns {Promise<Way>}
 */
export async function shareLink(link, { navigator, history }) {
  if (navigator.share) {
    try {
      await navigator.share({ title: 'QRelief', url: link });
      return 'linkShared';
    } catch (thrown) {
      if (thrown instanceof DOMException && thrown.name === 'AbortError') return 'cancelled';
    }
  }
  try {
    if (!navigator.clipboard) throw new Error('no clipboard on an unencrypted page');
    await navigator.clipboard.writeText(link);
    return 'linkCopied';
  } catch {
    history.replaceState(null, '', link);
    return 'linkShown';
  }
}
