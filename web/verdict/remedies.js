// SPDX-License-Identifier: GPL-3.0-or-later
// What would help, as values for the page's controls.

/** @typedef {import('../engine/types.js').Report} Report */
/** @typedef {import('../storage/last_work.js').Values} Values */
/** @typedef {'larger' | 'largest' | 'turned' | 'robust' | 'balanced' | 'autoContrast' | 'pattern' | 'nozzle' | 'layer' | 'ecc'} Kind */
/** @typedef {{ kind: Kind, control: string, value: string } | { kind: 'spot' }} Remedy  `spot`: have spots suggested */

const kNozzlesMm = [0.8, 0.6, 0.4, 0.3, 0.25, 0.2, 0.15];  // that are sold
const kLayersMm = [0.2, 0.16, 0.12, 0.1, 0.08, 0.06, 0.05, 0.04];
const kPocketNozzles = 0.9;  // least width of a pocket, as in core/verification/printability.cpp
const kLayers = 2;           // least depth
const kModuleNozzles = /** @type {Record<string, number>} */ (
  { square: 0.9 / 0.4, diamond: 0.9 / 0.4, 'thick-plus': 0.6 / 0.4, none: 1.2 / 0.4, 'thin-plus': 0 });
const kMostSizeMm = 1000;
const kLarger = 1.25;

/** A larger code, if the controls are what keeps it small. @param {Report} report @param {Values} values @returns {Remedy[]} */
export function sizeRemedies({ size, symbol }, values, leastModuleMm = 0) {
  const atMost = Number(values['size-mm']);
  const needed = Math.ceil(Math.max(kLarger * size.symbolMm, leastModuleMm * symbol.modules));
  if (values.size === 'fixed') {
    return size.guaranteedMm > size.symbolMm + 0.1 ? [{ kind: 'largest', control: 'size', value: 'free' }] : [];
  }
  if (size.symbolMm > atMost - 0.1 && needed <= kMostSizeMm) return [{ kind: 'larger', control: 'size-mm', value: String(needed) }];
  return values.size === 'best' ? [] : [{ kind: 'turned', control: 'size', value: 'best' }];
}

/** The next deeper one, if presets count and there is one. @param {Values} values @returns {'balanced' | 'robust' | undefined} */
export function deeperPreset({ preset, contrast }) {
  if (contrast !== '' || preset === 'robust') return undefined;
  return preset === 'shallow' ? 'balanced' : 'robust';
}

/** Darker modules. @param {Values} values @returns {Remedy[]} */
export function depthRemedies(values) {
  if (values.contrast !== '') return [{ kind: 'autoContrast', control: 'contrast', value: '' }];
  const deeper = deeperPreset(values);
  return deeper ? [{ kind: deeper, control: 'preset', value: deeper }] : [];
}

/** Against a code that does not read, or barely. @param {Report} report @param {Values} values @returns {Remedy[]} */
export const readingRemedies = (report, values) => [
  ...depthRemedies(values),
  ...sizeRemedies(report, values),
  ...(values.ecc === 'L' ? [/** @type {Remedy} */ ({ kind: 'ecc', control: 'ecc', value: 'auto' })] : []),
  { kind: 'spot' },
];

/** Against one that may not print. @param {Report} report @param {Values} values @returns {Remedy[]} */
export function printingRemedies(report, values) {
  const { features } = report.depth;
  const pattern = String(values.pattern);
  /** @type {Remedy[]} */ const found = [];
  const nozzle = Number(values.nozzle);
  const leastModuleMm = Math.max(kModuleNozzles[pattern] * nozzle, (features.moduleMm * kPocketNozzles * nozzle) / features.pocketMm);
  if (features.moduleMm < leastModuleMm - 1e-9) {
    found.push(...sizeRemedies(report, values, leastModuleMm));
    if (pattern !== 'thick-plus') found.push({ kind: 'pattern', control: 'pattern', value: pattern === 'thin-plus' ? 'square' : 'thick-plus' });
    const most = Math.min(features.pocketMm / kPocketNozzles, kModuleNozzles[pattern] > 0 ? features.moduleMm / kModuleNozzles[pattern] : Infinity);
    const finer = kNozzlesMm.find((mm) => mm <= most + 1e-9 && mm < nozzle);
    if (finer) found.push({ kind: 'nozzle', control: 'nozzle', value: String(finer) });
  }
  if (features.leastDepthMm < kLayers * Number(values.layer) - 1e-9) {
    found.push(...depthRemedies(values));
    const thinner = kLayersMm.find((mm) => mm <= features.leastDepthMm / kLayers + 1e-9);
    if (thinner) found.push({ kind: 'layer', control: 'layer', value: String(thinner) });
  }
  return [...found, { kind: 'spot' }];
}
