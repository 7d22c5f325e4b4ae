// SPDX-License-Identifier: GPL-3.0-or-later
// Checks whether a printer can make the modules of a symbol, and finds the size or symbol that it could.

const kSmallestSymbol = 21; // modules: version 1
const kRounding = 1e-9;

/**
 * Checks a symbol's module size.
 * @param {number} modules        along the symbol's edge
 * @param {number} symbolMm       edge of the symbol without quiet zone
 * @param {number} leastModuleMm  smallest printable module
 * @returns {{ moduleMm: number, neededMm: number, printable: number | undefined } | undefined}
 *   undefined if it prints; `neededMm`: smallest printable size of this symbol; `printable`: modules of the largest
 *   symbol that prints at `symbolMm`, undefined if there is none
 */
export function tooSmall(modules, symbolMm, leastModuleMm) {
  const moduleMm = symbolMm / modules;
  if (moduleMm >= leastModuleMm - kRounding) return undefined;
  const steps = Math.floor((symbolMm / leastModuleMm - kSmallestSymbol) / 4 + kRounding);
  return {
    moduleMm,
    neededMm: modules * leastModuleMm,
    printable: steps < 0 ? undefined : kSmallestSymbol + 4 * steps,
  };
}
