// SPDX-License-Identifier: GPL-3.0-or-later
// Depth by contrast and module pattern, compared with the depths of Peng 2019 and 2020 [Papp 2022, figure 20].
import { groupBy, rises } from '../page/compare.js';
import { inOrder, kColours, series } from '../page/figure.js';
import { name, said } from '../page/say.js';

/** @typedef {import('../page/table.js').Row} Row */

const kShadow = 'self-shadow-2019',
  kLamp = 'one-light-2020';
const kOthers = [kLamp, kShadow];

/**
 * Returns the depth of a method at the contrast of its authors’ program.
 * @param {Record<string, Row[]>} tables
 * @param {string} model
 * @param {string} method
 */
const depthOf = ({ method_comparison: comparison = [] }, model, method) =>
  comparison.find((row) => row.model === model && row.method === method)?.depth_mm;

/**
 * Returns the least contrast at which codes with this pattern are at least this deep.
 * @param {Row[]} ofModel
 * @param {string} modules  pattern
 * @param {number | undefined} depth  mm
 * @returns {number | undefined}  undefined if no contrast is enough
 */
export function contrastThatReaches(ofModel, modules, depth) {
  if (depth === undefined) return undefined;
  const enough = ofModel
    .filter((row) => row.modules === modules && row.depth_mm >= depth)
    .map(({ contrast }) => contrast);
  return enough.length > 0 ? Math.min(...enough) : undefined;
}

/**
 * Returns the contrasts at which the paper's order holds: Peng 2020, then every pattern, then Peng 2019.
 * @param {Row[]} ofModel
 * @param {number | undefined} lampDepth    of Peng 2020, mm
 * @param {number | undefined} shadowDepth  of Peng 2019, mm
 */
export const contrastsOfPaperOrder = (ofModel, lampDepth, shadowDepth) =>
  [
    ...groupBy(
      ofModel.filter(({ modules }) => modules !== 'none'),
      'contrast',
    ),
  ]
    .filter(([, ofContrast]) => ofContrast.every((row) => rises([lampDepth, row.depth_mm, shadowDepth])))
    .map(([contrast]) => contrast);

/** @type {import('../page/figure.js').Figure} */
export const contrastSweep = {
  name: 'contrastSweep',
  table: 'contrast_sweep',
  measures: ['depth_mm', 'printed'],
  draw: (rows, look, tables) => {
    const contrasts = rows.map(({ contrast }) => contrast);
    const ends = [Math.min(...contrasts), Math.max(...contrasts)];
    const flat = inOrder(rows, 'model', 'model').flatMap((model) =>
      kOthers.flatMap((method) =>
        ends.map((contrast) => ({
          model,
          contrast,
          line: look.name('method', method),
          isFlat: true,
          depth_mm: depthOf(tables, model, method) ?? null,
        })),
      ),
    );
    const patterned = rows.map((row) => ({ ...row, line: look.name('pattern', row.modules), isFlat: false }));
    const { rows: values, order } = look.named([...patterned, ...flat], { model: 'model' });
    const lines = [
      ...inOrder(rows, 'modules', 'pattern').map((modules) => look.name('pattern', modules)),
      ...kOthers.map((method) => look.name('method', method)),
    ];
    const columns = look.narrow ? 1 : 2;
    const encoding = {
      x: {
        field: 'contrast',
        type: /** @type {const} */ ('quantitative'),
        title: look.word('axisContrast'),
        scale: { domain: ends, nice: false },
        axis: { grid: false },
      },
      y: { field: 'depth_mm', type: /** @type {const} */ ('quantitative'), title: look.word('axisDepth') },
      ...series(
        'line',
        lines,
        [kColours.blue, kColours.teal, kColours.grey, kColours.olive, kColours.green, kColours.orange, kColours.purple],
        ['circle', 'square', 'diamond', 'cross', 'triangle-up', 'stroke', 'stroke'],
      ),
    };
    return /** @type {any} */ ({
      data: { values },
      columns,
      facet: { field: 'model', type: 'nominal', sort: order('model') },
      spec: {
        width: look.plotWidth(columns),
        height: 200,
        layer: [
          {
            transform: [{ filter: 'datum.isFlat' }],
            mark: { type: 'line', strokeDash: [6, 4], strokeWidth: 2 },
            encoding,
          },
          {
            transform: [{ filter: '!datum.isFlat' }],
            mark: { type: 'line', point: { size: 36 }, strokeWidth: 1.6 },
            encoding,
          },
        ],
      },
    });
  },
  find: (rows, tables) =>
    [...groupBy(rows, 'model')]
      .map(([model, ofModel]) => {
        const depths = kOthers.map((method) => depthOf(tables, model, method));
        const reaches = contrastThatReaches(ofModel, 'none', depths[1]);
        const inOrderAt = contrastsOfPaperOrder(ofModel, depths[0], depths[1]);
        const two = (/** @type {number} */ number) => ({ number, digits: 2 });
        return [
          ...(depths[1] === undefined
            ? []
            : [
                reaches === undefined
                  ? said('sweepNever', { model: name('model', model) })
                  : said('sweepReaches', { model: name('model', model), contrast: two(reaches) }),
              ]),
          ...(depths.includes(undefined)
            ? []
            : [
                inOrderAt.length === 0
                  ? said('sweepNoOrder')
                  : inOrderAt.length === 1
                    ? said('sweepOrderOnce', { least: two(inOrderAt[0]) })
                    : said('sweepOrder', { least: two(Math.min(...inOrderAt)), most: two(Math.max(...inOrderAt)) }),
              ]),
        ];
      })
      .flat()
      .concat([said('sweepWhy')]),
};
