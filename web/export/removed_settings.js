// SPDX-License-Identifier: GPL-3.0-or-later
// Drops the settings and choices that earlier versions had from the settings of a file or an address, with a warning
// for each.
import { message } from '../engine/message.js';
import { kRemovedSettings } from '../generated/settings.js';

/** @typedef {import('../engine/message.js').Message} Message */

/**
 * @param {Record<string, unknown>} given  by key
 * @returns {{ settings: Record<string, unknown>, warnings: Message[] }}  the settings that are left
 */
export function withoutRemoved(given) {
  const removed = kRemovedSettings.filter(
    ({ key, choice }) => Object.hasOwn(given, key) && (choice === undefined || given[key] === choice),
  );
  const keys = removed.map(({ key }) => key);
  return {
    settings: Object.fromEntries(Object.entries(given).filter(([key]) => !keys.includes(key))),
    warnings: removed.map(({ key, choice, since, why }) =>
      message('setting-removed', {
        name: { term: choice === undefined ? key : `${key} ${choice}` },
        since: { term: since },
        why: { cause: why },
      }),
    ),
  };
}
