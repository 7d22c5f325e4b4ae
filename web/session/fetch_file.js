// SPDX-License-Identifier: GPL-3.0-or-later

/** @param {string} path  relative to the page */
async function fetchOk(path) {
  const response = await fetch(path);
  if (!response.ok) throw new Error(`${path} could not be fetched (status ${response.status})`);
  return response;
}

/** @param {string} path */
export const fetchJson = async (path) => (await fetchOk(path)).json();

/** @param {string} path */
export const fetchBytes = async (path) => new Uint8Array(await (await fetchOk(path)).arrayBuffer());
