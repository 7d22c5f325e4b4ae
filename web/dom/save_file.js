// SPDX-License-Identifier: GPL-3.0-or-later

const kKeepMs = 60_000; // some browsers read the blob only after the click has returned

/** Saves a blob as a download. @param {Blob} blob @param {string} fileName */
export function saveFile(blob, fileName) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = fileName;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), kKeepMs);
}
