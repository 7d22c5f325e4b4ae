// SPDX-License-Identifier: GPL-3.0-or-later
import * as vega from 'vega';
import { compile } from 'vega-lite';
import { kWidths, Look } from './figure.js';

/** @typedef {import('./figure.js').Figure} Figure */
/** @typedef {import('./table.js').Row} Row */
/** @typedef {{ svg: string, width: number, height: number }} Drawing  in CSS pixels */

const kLetterEm = 0.57; // mean width of a letter, because nothing measures text during the build

// The types lack it.
/** @type {any} */ (vega).textMetrics.width = (
  /** @type {{ fontSize?: number }} */ { fontSize = 11 },
  /** @type {unknown} */ text,
) => kLetterEm * fontSize * String(text ?? '').length;

/**
 * @param {Figure} figure
 * @param {Row[]} rows
 * @param {Look} look
 * @param {Record<string, Row[]>} tables
 * @returns {Promise<Drawing>}
 */
async function drawn(figure, rows, look, tables) {
  const spec = /** @type {any} */ (figure.draw(rows, look, tables));
  const { spec: drawing } = compile({ padding: 2, ...spec, config: look.config });
  const view = new vega.View(vega.parse(drawing), { renderer: 'none' });
  const svg = (await view.toSVG()).replace(/\d+\.\d{3,}/g, (number) => String(Number(Number(number).toFixed(2))));
  view.finalize();
  const pixels = (/** @type {string} */ side) =>
    Math.round(Number(new RegExp(`<svg[^>]*\\b${side}="([\\d.]+)"`).exec(svg)?.[1]));
  return { svg, width: pixels('width'), height: pixels('height') };
}

/**
 * Draws a figure as an SVG file of its own.
 * @param {Figure} figure
 * @param {Row[]} rows  of its table, measured
 * @param {import('./figure.js').Language} language
 * @param {keyof typeof kWidths} width  to fill
 * @param {Record<string, Row[]>} tables  all, as measured
 */
export async function drawFigure(figure, rows, language, width, tables) {
  const whole = kWidths[width];
  const beside = (await drawn(figure, rows, new Look(language, width, whole), tables)).width - whole; // labels and gaps between the plots
  return drawn(figure, rows, new Look(language, width, whole - beside), tables);
}
