// SPDX-License-Identifier: GPL-3.0-or-later
// Checks what PrusaSlicer makes of a two-colour 3MF: G-code in which each module has the right tool, and which changes
// tools in the layers with the second colour and in no other.
//
//     node check.mjs FILE.3mf REPORT.json FILE.gcode
import { readFileSync } from 'node:fs';
import { unzip } from '../../e2e/support/three_mf.js';
import { layersOf, toolAt } from './toolpaths.mjs';

const MIN_RIGHT = 0.99; // of all modules
const REACH_MM = 0.4; // from a point to the middle of its bead: a line is 0.45 mm wide
const SLIVER_MM = 0.09; // less of the second colour under and over a layer's middle may be narrower than a line

const [file, report, gcode] = process.argv.slice(2);

/** Returns the elements' attributes. @param {string} xml @param {string} name */
const elements = (xml, name) =>
  [...xml.matchAll(new RegExp(`<${name}\\b([^>]*)>`, 'g'))].map(([, attributes]) =>
    Object.fromEntries([...attributes.matchAll(/([\w:]+)="([^"]*)"/g)].map(([, key, value]) => [key, value])),
  );

/**
 * Returns the heights of the triangles in the second filament: of the volume with extruder 2, or of painted facets.
 * @param {Map<string, string>} files
 * @returns {{ heights: [number, number][], isPaint: boolean }}
 */
function secondColour(files) {
  const model = files.get('3D/3dmodel.model') ?? '';
  const config = files.get('Metadata/Slic3r_PE_model.config') ?? '';
  /** @type {[number, number][]} */ const heights = [];
  let isPaint = false;
  for (const [text, id] of model.matchAll(/<object id="(\d+)".*?<\/object>/gs)) {
    const z = elements(text, 'vertex').map((vertex) => Number(vertex.z));
    const triangles = elements(text, 'triangle');
    const own = config.match(new RegExp(`<object id="${id}".*?</object>`, 's'))?.[0] ?? '';
    const volumes = [...own.matchAll(/<volume firstid="(\d+)" lastid="(\d+)">.*?key="extruder" value="(\d+)"/gs)];
    triangles.forEach((triangle, t) => {
      const isVolume = volumes.some(([, first, last, extruder]) => extruder === '2' && t >= +first && t <= +last);
      const isPainted = triangle['slic3rpe:mmu_segmentation'] === '8';
      isPaint ||= isPainted;
      if (!isVolume && !isPainted) return;
      const corners = [triangle.v1, triangle.v2, triangle.v3].map((v) => z[Number(v)]);
      heights.push([Math.min(...corners), Math.max(...corners)]);
    });
  }
  return { heights, isPaint };
}

/** Returns the modules whose tool is wrong. */
function wrongModules(/** @type {any} */ { symbol, projection, size }, /** @type {any[]} */ layers) {
  const { centre, normal, up } = projection;
  const right = [
    up[1] * normal[2] - up[2] * normal[1],
    up[2] * normal[0] - up[0] * normal[2],
    up[0] * normal[1] - up[1] * normal[0],
  ];
  /** @type {(row: number, column: number, depthMm: number) => number} */
  const tool = (row, column, depthMm) => {
    const [u, v] = [(column - symbol.modules / 2) * size.moduleMm, (symbol.modules / 2 - row) * size.moduleMm];
    const [x, y, z] = [0, 1, 2].map((i) => centre[i] + right[i] * u + up[i] * v - normal[i] * depthMm);
    const layer = layers.find((/** @type {any} */ l) => z <= l.z && z > l.z - l.height);
    return layer ? toolAt(layer, x, y, REACH_MM) : -1;
  };
  const depthMm = 0.25; // under the surface: inside of every second colour, and within the outermost lines
  let wrong = 0;
  symbol.rows.forEach((/** @type {string} */ text, /** @type {number} */ row) => {
    [...text].forEach((module, column) => {
      if (tool(row + 0.5, column + 0.5, depthMm) !== Number(module)) wrong += 1;
    });
  });
  return wrong;
}

const layers = layersOf(readFileSync(gcode, 'utf8'));
const engraving = JSON.parse(readFileSync(report, 'utf8'));
const { heights, isPaint } = secondColour(unzip(readFileSync(file)));
/** Returns the layers whose middles cut the second colour, with `margin` mm of it below and above. */
const layersWith = (/** @type {number} */ margin) =>
  layers.filter(({ z, height }) =>
    heights.some(([low, top]) => low < z - height / 2 - margin && top > z - height / 2 + margin),
  );
const changed = layers.filter(({ beads }) => beads.some(({ tool }) => tool === 1));
const [sure, possible] = [layersWith(SLIVER_MM), layersWith(0)];
const missing = sure.filter((layer) => !changed.includes(layer));
const surplus = changed.filter((layer) => !possible.includes(layer));
const modules = engraving.symbol.modules ** 2;
const wrong = wrongModules(engraving, layers);
console.log(
  `${file}: ${modules - wrong} of ${modules} modules have the right tool; the second colour is in ${changed.length} layers of ${layers.length}, ` +
    `${sure.length} to ${possible.length} expected, ${missing.length} missing, ${surplus.length} too many`,
);
// PrusaSlicer colours several layers under painted facets that face up.
const layersAreRight = missing.length === 0 && (isPaint || surplus.length === 0);
if (heights.length === 0 || wrong > (1 - MIN_RIGHT) * modules || !layersAreRight) process.exitCode = 1;
