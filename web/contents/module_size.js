// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a printer can make the modules of a symbol, and what size or symbol it could.

const kSmallestSymbol = 21;  // modules: version 1
const kRounding = 1e-9;

/**
 * @param {number} modules        along the symbol's edge
 * @param {number} symbolMm       its edge, without the quiet zone
 * @param {number} leastModuleMm  that prints
 * @returns {{ moduleMm: number, neededMm: number, printable: number | undefined } | undefined}  nothing if it prints;
 *   else the width that it needs, and the largest symbol that prints at this width, if there is one
 */
export function tooSmall(modules, symbolMm, leastModuleMm) {
  const moduleMm = symbolMm / modules;
  if (moduleMm >= leastModuleMm - kRounding) return undefined;
  const steps = Math.floor((symbolMm / leastModuleMm - kSmallestSymbol) / 4 + kRounding);
  return { moduleMm, neededMm: modules * leastModuleMm, printable: steps < 0 ? undefined : kSmallestSymbol + 4 * steps };
}
