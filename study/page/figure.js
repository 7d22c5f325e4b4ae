// SPDX-License-Identifier: GPL-3.0-or-later
// Common parts of the figures: measures, colours, names in the page's language.
import { kWords, name, sentence } from './say.js';

/** @typedef {import('./table.js').Row} Row */
/** @typedef {import('./say.js').Said} Said */
/** @typedef {import('./say.js').Word} Word */
/** @typedef {import('./say.js').Language} Language */
/** @typedef {import('vega-lite').TopLevelSpec} Spec */

/**
 * A figure of the page, from one table. Rows are the measured ones.
 * @typedef {object} Figure
 * @property {string} name    of its files, and of its words: NAMEAlt, NAMEShown
 * @property {string} table
 * @property {string[]} measures  columns that it shows; no figure without a value in each of them
 * @property {(rows: Row[], look: Look, tables: Record<string, Row[]>) => Spec} draw  `tables` are all, as measured
 * @property {(rows: Row[], tables: Record<string, Row[]>) => Said[]} find  sentences about it; `tables` are all, as measured
 */

/** CSS pixels. A wide figure fits the column of the page, a narrow one a phone of 360. */
export const kWidths = { wide: 712, narrow: 328 };

/** Colours for every kind of colour vision, 3:1 on white at least; dark pages invert their lightness (article.css). */
export const kColours = {
  blue: '#0072b2',
  orange: '#c85200',
  green: '#007a58',
  purple: '#a6427f',
  grey: '#75797d',
  olive: '#80751a',
  teal: '#00899e',
  ink: '#1c1f21',
  soft: '#575d61',
  line: '#d9d9d2',
};

/**
 * Returns a column's values, each once, in the order of their words.
 * @param {Row[]} rows
 * @param {string} column
 * @param {string} kind  of name
 * @returns {any[]}
 */
export function inOrder(rows, column, kind) {
  const words = Object.keys(kWords.en);
  const at = (/** @type {any} */ value) => words.indexOf(`${kind}-${value}`);
  return [...new Set(rows.map((row) => row[column]))].sort((a, b) => at(a) - at(b));
}

export class Look {
  /**
   * @param {Language} language
   * @param {keyof typeof kWidths} width
   * @param {number} room  for the plots of a row, without labels and legend
   */
  constructor(language, width, room) {
    this.language = language;
    this.narrow = width === 'narrow';
    this.room = room;
  }

  /** @param {Word} word @param {Record<string, import('./say.js').Value>} [values] */
  word(word, values) {
    return sentence(this.language, { say: word, with: values });
  }

  /** @param {string} kind @param {string} value */
  name(kind, value) {
    return sentence(this.language, name(kind, value));
  }

  /**
   * Replaces a column's values by names, and returns these names in the order of the words.
   * @param {Row[]} rows
   * @param {Record<string, string>} kinds  of names, by column
   */
  named(rows, kinds) {
    const named = rows.map((row) => ({
      ...row,
      ...Object.fromEntries(Object.entries(kinds).map(([column, kind]) => [column, this.name(kind, row[column])])),
    }));
    /** @param {string} column */
    const order = (column) => inOrder(rows, column, kinds[column]).map((value) => this.name(kinds[column], value));
    return { rows: named, order };
  }

  /** Returns the width of one of several plots side by side. @param {number} columns */
  plotWidth(columns) {
    return Math.floor(this.room / columns);
  }

  get config() {
    const size = this.narrow ? 10 : 11;
    return {
      font: 'system-ui, "Noto Sans", "Liberation Sans", sans-serif',
      background: 'transparent',
      aria: false, // the <img> has its alternative text
      locale: {
        number:
          this.language === 'de'
            ? { decimal: ',', thousands: '.', grouping: [3], currency: ['', ' €'] }
            : { decimal: '.', thousands: ',', grouping: [3], currency: ['$', ''] },
      },
      view: { stroke: null },
      axis: {
        labelFontSize: size,
        labelColor: kColours.ink,
        titleFontSize: size,
        titleFontWeight: 500,
        titleColor: kColours.soft,
        titlePadding: 6,
        gridColor: kColours.line,
        domainColor: kColours.grey,
        tickColor: kColours.grey,
        labelLimit: 200,
        tickCount: 4,
      },
      axisY: { domain: false, ticks: false },
      legend: {
        orient: 'top',
        labelFontSize: size,
        labelColor: kColours.ink,
        labelLimit: 240,
        symbolSize: 60,
        symbolStrokeWidth: 2,
        titleFontSize: size,
        titleFontWeight: 600,
        titleColor: kColours.ink,
        columnPadding: 12,
        offset: 6,
        columns: this.narrow ? 2 : 5,
      },
      header: { labelFontSize: size + 1, labelFontWeight: 600, labelColor: kColours.ink, title: null, labelPadding: 4 },
      facet: { spacing: this.narrow ? 14 : 18 },
    };
  }
}

/**
 * Encodes a series by colour and shape at once.
 * @param {string} field
 * @param {string[]} names
 * @param {string[]} colours
 * @param {string[]} shapes
 * @param {string | null} [title]
 */
export const series = (field, names, colours, shapes, title = null) => {
  const of = { field, type: /** @type {const} */ ('nominal'), legend: { title } };
  return {
    color: { ...of, scale: { domain: names, range: colours } },
    shape: { ...of, scale: { domain: names, range: shapes } },
  };
};

/** Encodes up to three models as a series. @param {string[]} models */
export const seriesOfModels = (models) =>
  series('model', models, [kColours.grey, kColours.blue, kColours.orange], ['circle', 'square', 'triangle-up']);
