// SPDX-License-Identifier: GPL-3.0-or-later
// Depth by elevation and strength of one lamp, on a plate: why lamps make codes deeper or shallower.
import { groupBy } from '../page/compare.js';
import { inOrder, kColours, series } from '../page/figure.js';
import { ofSearch } from '../page/methods.js';
import { linePlots } from '../page/plots.js';
import { name, said } from '../page/say.js';

/** @typedef {import('../page/table.js').Row} Row */

/** Elevation of the higher lamp of the paper's figure 22, in degrees; its figure 21 gives none. */
const kPaperElevation = 33;

/**
 * Returns the depth under the sky alone, by module pattern.
 * @param {Record<string, Row[]>} tables
 * @returns {Record<string, number>}
 */
const skyDepths = ({ lamp_depths: depths = [] }) =>
  Object.fromEntries(
    ofSearch(depths)
      .filter(({ model, lamps }) => model === 'plate' && lamps === 0)
      .map(({ modules, depth_mm: depth }) => [modules, depth]),
  );

/**
 * Returns the elevations at which the lamp has the same effect at every strength.
 * @param {Row[]} rows  of one module pattern
 * @param {number} skyDepth  depth under the sky alone, mm
 * @returns {{ shallower: number[], deeper: number[], either: number[] }}  in degrees; `either`: the effect depends on the strength
 */
export function effects(rows, skyDepth) {
  /** @type {ReturnType<typeof effects>} */ const elevations = { shallower: [], deeper: [], either: [] };
  for (const [elevation, ofLamp] of groupBy(rows, 'elevation')) {
    const deeper = ofLamp.filter(({ depth_mm: depth }) => depth > skyDepth).length;
    elevations[deeper === 0 ? 'shallower' : deeper === ofLamp.length ? 'deeper' : 'either'].push(elevation);
  }
  return elevations;
}

/** @type {import('../page/figure.js').Figure} */
export const lampStrengths = {
  name: 'lampStrengths',
  table: 'lamp_strengths',
  measures: ['depth_mm', 'reads'],
  draw: (rows, look, tables) => {
    const sky = skyDepths(tables);
    const strengths = [...new Set(rows.map(({ strength }) => strength))];
    const line = (/** @type {Row} */ row) => look.word('lampAt', { elevation: row.elevation });
    const skyName = look.word('skyAlone');
    const { rows: values, order } = look.named(
      [
        ...rows.map((row) => ({ ...row, light: line(row) })),
        ...inOrder(rows, 'modules', 'pattern').flatMap((modules) =>
          strengths.map((strength) => ({ modules, strength, light: skyName, depth_mm: sky[modules] })),
        ),
      ],
      { modules: 'pattern' },
    );
    const lights = [skyName, ...new Set(rows.map(line))];
    return linePlots(values, look, {
      plots: { field: 'modules', names: order('modules') },
      columns: look.narrow ? 1 : 2,
      height: 170,
      x: { field: 'strength', title: look.word('axisStrength') },
      y: { field: 'depth_mm', title: look.word('axisDepth') },
      lines: series(
        'light',
        lights,
        [kColours.grey, kColours.blue, kColours.teal, kColours.olive, kColours.orange, kColours.purple],
        ['cross', 'circle', 'square', 'diamond', 'triangle-up', 'triangle-down'],
      ),
    });
  },
  find: (rows, tables) => {
    const sky = skyDepths(tables);
    const patterns = [...groupBy(rows, 'modules')]
      .filter(([modules]) => sky[modules] !== undefined)
      .map(([modules, ofPattern]) => ({ modules, ...effects(ofPattern, sky[modules]) }));
    const angles = (/** @type {number[]} */ elevations) =>
      elevations.map((elevation) => said('degrees', { elevation }));
    const isBorder = patterns.some(({ either }) => either.includes(kPaperElevation));
    return [
      ...patterns
        .filter(({ shallower, deeper }) => shallower.length > 0 && deeper.length > 0)
        .map(({ modules, shallower, deeper }) =>
          said('strengthsSides', {
            pattern: name('pattern', modules),
            shallower: angles(shallower),
            deeper: angles(deeper),
          }),
        ),
      ...(isBorder ? [said('strengthsWhy', { elevation: kPaperElevation })] : []),
    ];
  },
};
