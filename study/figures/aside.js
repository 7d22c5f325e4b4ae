// SPDX-License-Identifier: GPL-3.0-or-later
// Largest tilts at which painted codes on cylinders decode, by arc, layout and decoder.
import { distinct, groupBy, median, rises, tally } from '../page/compare.js';
import { kColours, series } from '../page/figure.js';
import { linePlots } from '../page/plots.js';
import { cases, name, said } from '../page/say.js';

/** @typedef {import('../page/table.js').Row} Row */

const kManyMarks = 7; // from this version on a code has six alignment patterns, from 2 to 6 one [ISO/IEC 18004, annex E]
const kUnread = -Infinity; // not even from the front: below every tilt

/** @param {Row} row */
const tiltOf = (row) => row.tilt_deg ?? kUnread;

/** Returns the decoder without its version: "jsqr" of "jsqr 1.4.0 (npm)". @param {Row} row */
export const decoderOf = ({ reader }) => String(reader).split(' ')[0];

/**
 * Returns the median tilt, in degrees; undefined if half or more do not decode even from the front.
 * @param {Row[]} rows
 */
export function medianTilt(rows) {
  const tilt = median(rows.map(tiltOf));
  return Number.isFinite(tilt) ? tilt : undefined;
}

/** @param {Row[]} rows @returns {Row[]} a row for each decoder, layout and arc: the median of the versions */
const overVersions = (rows) =>
  [
    ...groupBy(
      rows.map((row) => ({ ...row, others: [row.reader, row.layout, row.arc_deg].join() })),
      'others',
    ).values(),
  ]
    .map((group) => ({
      reader: decoderOf(group[0]),
      layout: group[0].layout,
      arc_deg: group[0].arc_deg,
      tilt_deg: medianTilt(group),
    }))
    .filter(({ tilt_deg: tilt }) => tilt !== undefined);

/**
 * Counts how often codes of one layout decode at tilts at least as large as codes of another layout, all else equal.
 * Codes that decode in neither layout do not count.
 * @param {Row[]} rows @param {string} one @param {string} other
 */
export function asFarAside(rows, one, other) {
  const groups = groupBy(
    rows.map((row) => ({ ...row, others: [row.reader, row.version, row.arc_deg].join() })),
    'others',
  );
  return tally(groups.values(), (group) => {
    const [a, b] = [one, other]
      .map((layout) => group.find((row) => row.layout === layout))
      .map((row) => row && tiltOf(row));
    return a === undefined || b === undefined || Math.max(a, b) === kUnread ? undefined : a >= b;
  });
}

/**
 * Returns the median tilts of smaller and of larger versions at every arc.
 * @param {Row[]} rows  of one decoder and layout
 */
const fewAndMany = (rows) =>
  [...groupBy(rows, 'arc_deg').values()].map((ofArc) =>
    [false, true].map((many) => {
      const tilts = ofArc.filter(({ version }) => version >= kManyMarks === many).map(tiltOf);
      return tilts.length > 0 ? median(tilts) : undefined;
    }),
  );

/**
 * True if one decoder decodes larger versions, with more alignment patterns, at larger tilts than smaller ones at every
 * arc.
 * @param {Row[]} rows  of one decoder and layout
 */
export const manyMarksHelp = (rows) => fewAndMany(rows).every((tilts) => rises(tilts) === true);

/** True if larger versions decode at larger tilts at no arc. @param {Row[]} rows  of one decoder and layout */
export const manyMarksNeverHelp = (rows) => fewAndMany(rows).every((tilts) => rises(tilts) === false);

/** @type {import('../page/figure.js').Figure} */
export const aside = {
  name: 'aside',
  table: 'aside',
  measures: ['tilt_deg'],
  draw: (rows, look) => {
    const { rows: values, order } = look.named(overVersions(rows), { reader: 'decoder', layout: 'layout' });
    return linePlots(values, look, {
      plots: { field: 'reader', names: order('reader') },
      columns: look.narrow ? 2 : 5,
      height: 130,
      x: { field: 'arc_deg', title: look.word('axisArc') },
      y: { field: 'tilt_deg', title: look.word('axisAside') },
      lines: series(
        'layout',
        order('layout'),
        [kColours.blue, kColours.grey, kColours.orange],
        ['circle', 'triangle-up', 'square'],
      ),
    });
  },
  find: (rows) => {
    const ofLayout = groupBy(rows, 'layout');
    const projected = ofLayout.get('projected') ?? [];
    const arcs = distinct(projected, 'arc_deg').sort((a, b) => a - b);
    if (arcs.length === 0) return [];
    const upTo = (/** @type {number} */ arc) => {
      const tilt = medianTilt(projected.filter(({ arc_deg: at }) => at === arc));
      if (tilt === undefined) return said('asideUnread');
      return tilt === 0 ? said('asideOnlyFront') : said('asideUpTo', { tilt });
    };
    const inFront = (/** @type {string} */ layout) => tally(ofLayout.get(layout) ?? [], (row) => tiltOf(row) > kUnread);
    const ofDecoders = groupBy(
      projected.map((row) => ({ ...row, decoder: decoderOf(row) })),
      'decoder',
    );
    const decodersWith = (/** @type {(rows: Row[]) => boolean} */ holds) =>
      [...ofDecoders].filter(([, rows]) => holds(rows)).map(([decoder]) => name('decoder', decoder));
    return [
      said('asideArcs', {
        narrow: arcs[0],
        narrowTilt: upTo(arcs[0]),
        wide: arcs[arcs.length - 1],
        wideTilt: upTo(arcs[arcs.length - 1]),
      }),
      said('asideLayouts', { cases: cases(asFarAside(rows, 'projected', 'wrapped')) }),
      said('asideFront', {
        projected: cases(inFront('projected')),
        halfway: cases(inFront('halfway')),
        wrapped: cases(inFront('wrapped')),
      }),
      said('asideMarks', { version: kManyMarks, list: decodersWith(manyMarksHelp) }),
      said('asideMarksNot', { list: decodersWith(manyMarksNeverHelp) }),
      said('asidePaper'),
    ];
  },
};
