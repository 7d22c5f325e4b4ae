// SPDX-License-Identifier: GPL-3.0-or-later
import { poll } from './poll.js';

/** @typedef {import('@playwright/test').Page} Page */

/** Waits until the latest work is stored. @param {Page} page @param {(kept: any) => boolean | undefined} holds */
export const untilKept = (page, holds) =>
  poll(async () =>
    Boolean(
      holds(
        await page.evaluate(
          () =>
            new Promise((resolve) => {
              const request = indexedDB.open('qrelief');
              request.onerror = () => resolve(undefined);
              request.onsuccess = () => {
                const database = request.result;
                if (!database.objectStoreNames.contains('kept')) {
                  database.close();
                  resolve(undefined);
                  return;
                }
                const get = database.transaction('kept').objectStore('kept').get('last work');
                get.onsuccess = () => {
                  database.close();
                  resolve(get.result);
                };
              };
            }),
        ),
      ),
    ),
  ).toBe(true);
