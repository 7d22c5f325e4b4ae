// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the filament changes, the second filament and the wipe tower that a report predicts with the G-code of
// PrusaSlicer 2.5:
//
//     script/bench colour FOLDER CENTRES.json [KIND] [MODEL...]
//
// Each model gets an inlaid code and is sliced with the code facing up and upright. The slicer gets both bodies as two
// volumes of one mesh, and two extruders without a wipe tower, so that its tool changes are the filament changes. Then it
// slices for one nozzle with a wipe tower, by its defaults but for the purge, to weigh the tower.
import { downloadZip } from 'client-zip';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const MODELS = [
  'bunny_70k.off',
  'bumpy_sphere_82k.ply',
  'chess_knight_19k.obj',
  'fandisk_13k.obj',
  'vase_wavy_thinwall_50k.stl',
  'cylinder_r30_slivers.stl',
];
const SIZE_MM = 20;
const LAYER_MM = 0.2;
const BED_MM = 600;
const DENSITY_G_PER_MM3 = 1.24e-3;
const FILAMENT_MM2 = Math.PI * (1.75 / 2) ** 2;
const PURGE_MM3 = 250;
const WITH_TOWER = [
  '--single-extruder-multi-material',
  '--no-single-extruder-multi-material-priming',
  '--wipe-tower',
  '--wipe-tower-x',
  `${BED_MM - 100}`,
  '--wipe-tower-y',
  `${BED_MM - 100}`,
  '--wiping-volumes-matrix',
  `0,${PURGE_MM3},${PURGE_MM3},0`,
];

const [folder, centresFile, kind = 'flat', ...chosen] = process.argv.slice(2);
const centres = JSON.parse(readFileSync(centresFile, 'utf8'));
const work = mkdtempSync(join(tmpdir(), 'colour-'));

/** @typedef {number[]} Triple */

/** @param {Triple} a @param {Triple} b */
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** @param {Triple} a @param {Triple} b */
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
/** @param {Triple} a */
const unit = (a) => a.map((x) => x / Math.sqrt(dot(a, a)));

/** Reads the bodies of our 3MF: model and second colour. @param {string} file */
function bodiesOf(file) {
  const xml = execFileSync('unzip', ['-p', file, '3D/3dmodel.model'], { encoding: 'utf8', maxBuffer: 2 ** 31 - 1 });
  return xml
    .split('<mesh>')
    .slice(1)
    .map((mesh) => ({
      points: [...mesh.matchAll(/<vertex x="([^"]+)" y="([^"]+)" z="([^"]+)"/g)].map((m) => m.slice(1).map(Number)),
      triangles: [...mesh.matchAll(/<triangle v1="(\d+)" v2="(\d+)" v3="(\d+)"/g)].map((m) => m.slice(1).map(Number)),
    }));
}

/** Writes both bodies as two volumes of one mesh, with `up` vertical. @param {string} file */
async function writeForSlicer(file, bodies, up) {
  const z = unit(up);
  const x = unit(cross(Math.abs(z[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0], z));
  const y = cross(z, x);
  const vertices = [];
  const triangles = [];
  const volumes = [];
  bodies.forEach((body, k) => {
    const first = vertices.length;
    const firstTriangle = triangles.length;
    for (const p of body.points) vertices.push(`<vertex x="${dot(p, x)}" y="${dot(p, y)}" z="${dot(p, z)}"/>`);
    for (const [a, b, c] of body.triangles)
      triangles.push(`<triangle v1="${a + first}" v2="${b + first}" v3="${c + first}"/>`);
    volumes.push(
      `<volume firstid="${firstTriangle}" lastid="${triangles.length - 1}">` +
        `<metadata type="volume" key="extruder" value="${k + 1}"/>` +
        `<metadata type="volume" key="fill_density" value="${k === 0 ? 10 : 100}%"/></volume>`,
    );
  });
  const parts = {
    '[Content_Types].xml':
      '<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">' +
      '<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>' +
      '<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>',
    '_rels/.rels':
      '<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="r" ' +
      'Target="/3D/3dmodel.model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>',
    '3D/3dmodel.model':
      '<?xml version="1.0" encoding="UTF-8"?><model unit="millimeter" ' +
      'xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" ' +
      'xmlns:slic3rpe="http://schemas.slic3r.org/3mf/2017/06"><metadata name="slic3rpe:Version3mf">1</metadata>' +
      `<resources><object id="1" type="model"><mesh><vertices>${vertices.join('')}</vertices>` +
      `<triangles>${triangles.join('')}</triangles></mesh></object></resources><build><item objectid="1"/></build></model>`,
    'Metadata/Slic3r_PE_model.config': `<config><object id="1">${volumes.join('')}</object></config>`,
  };
  const entries = Object.entries(parts).map(([name, input]) => ({ name, input }));
  writeFileSync(file, Buffer.from(await downloadZip(entries).arrayBuffer()));
}

/** Slices a file. Returns the lines of the G-code. @param {string} file @param {string[]} [more]  options */
function slice(file, more = []) {
  const gcode = `${file}.gcode`;
  execFileSync(
    'prusa-slicer',
    [
      '--export-gcode',
      file,
      '-o',
      gcode,
      '--center',
      `${BED_MM / 2},${BED_MM / 2}`,
      '--bed-shape',
      `0x0,${BED_MM}x0,${BED_MM}x${BED_MM},0x${BED_MM}`,
      '--max-print-height',
      '1000',
      '--nozzle-diameter',
      '0.4,0.4',
      '--filament-diameter',
      '1.75,1.75',
      '--extrusion-width',
      '0.45',
      '--layer-height',
      `${LAYER_MM}`,
      '--first-layer-height',
      `${LAYER_MM}`,
      '--perimeters',
      '2',
      '--skirts',
      '0',
      '--use-relative-e-distances',
      '--layer-gcode',
      'G92 E0\n;LAYER',
      '--before-layer-gcode',
      '',
      '--start-gcode',
      '',
      '--end-gcode',
      '',
      '--toolchange-gcode',
      '',
      ...more,
    ],
    { stdio: ['ignore', 'ignore', 'inherit'] },
  );
  return readFileSync(gcode, 'utf8').split('\n');
}

/** Weighs a wipe tower without the purges. @param {string[]} lines @param {number} changes */
function towerG(lines, changes) {
  let inTower = false;
  let fedMm = 0;
  for (const line of lines) {
    if (line.startsWith(';TYPE:')) inTower = line === ';TYPE:Wipe tower';
    // Filament that is unloaded comes back: retractions count, too.
    const fed = inTower && /^G1 .*E(-?[\d.]+)/.exec(line);
    if (fed) fedMm += Number(fed[1]);
  }
  return (fedMm * FILAMENT_MM2 - changes * PURGE_MM3) * DENSITY_G_PER_MM3;
}

/** Reads tool changes, layers and volume of the second filament. @param {string[]} lines */
function secondFilament(lines) {
  let held = null;
  let changes = 0;
  let secondMm = 0;
  let layer = 0;
  const layers = new Set();
  for (const line of lines) {
    if (line.startsWith(';LAYER')) ++layer;
    const tool = /^T(\d)/.exec(line)?.[1];
    if (tool !== undefined) {
      if (held !== null && held !== tool) ++changes;
      held = tool;
    }
    const fed = /^G1 .*E(-?[\d.]+)/.exec(line);
    // Moves in x and y alone lay plastic; others retract.
    if (held === '1' && fed && /[XY]/.test(line) && Number(fed[1]) > 0) {
      secondMm += Number(fed[1]);
      layers.add(layer);
    }
  }
  return { changes, layers: layers.size, secondMm3: secondMm * FILAMENT_MM2 };
}

const off = (/** @type {number} */ ours, /** @type {number} */ theirs) => `${((ours / theirs - 1) * 100).toFixed(1)} %`;

console.log(
  '| model | pose | layers, ours | PrusaSlicer | changes, ours | PrusaSlicer | off | second filament, ours, g | PrusaSlicer, g | off | tower, ours, g | PrusaSlicer, g | off |',
);
console.log('|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|');
try {
  for (const model of chosen.length ? chosen : MODELS) {
    const { scaleToMm, picks } = centres[model];
    for (const pose of ['code-up', 'code-upright']) {
      const out = join(work, 'case.3mf');
      const report = join(work, 'case.json');
      execFileSync(
        'build/release/bin/qrelief',
        [
          'engrave',
          join(folder, model),
          '--scale',
          `${scaleToMm}`,
          '--at',
          picks[kind].pointFileUnits.join(','),
          '--size',
          `${SIZE_MM}`,
          '--text',
          'https://example.org/p/01',
          '--mark',
          'inlay',
          '--build-up',
          pose,
          '-o',
          out,
          '--report',
          report,
          '--quiet',
        ],
        { stdio: 'ignore' },
      );
      const { colour, projection } = JSON.parse(readFileSync(report, 'utf8'));
      const forSlicer = join(work, 'sliced.3mf');
      await writeForSlicer(forSlicer, bodiesOf(out), pose === 'code-up' ? projection.normal : projection.up);
      const theirs = secondFilament(slice(forSlicer));
      const theirG = theirs.secondMm3 * DENSITY_G_PER_MM3;
      const theirTowerG = towerG(slice(forSlicer, WITH_TOWER), theirs.changes);
      const cells = [
        model,
        pose,
        colour.layers,
        theirs.layers,
        colour.changes,
        theirs.changes,
        off(colour.changes, theirs.changes),
        colour.secondG.toFixed(3),
        theirG.toFixed(3),
        off(colour.secondG, theirG),
        colour.towerG.toFixed(1),
        theirTowerG.toFixed(1),
        off(colour.towerG, theirTowerG),
      ];
      console.log(`| ${cells.join(' | ')} |`);
    }
  }
} finally {
  rmSync(work, { recursive: true });
}
