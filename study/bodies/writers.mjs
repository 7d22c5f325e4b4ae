// SPDX-License-Identifier: GPL-3.0-or-later
// Writes scenes as the programs do that people use: each way to keep several bodies in one file.
import { downloadZip } from 'client-zip';
import { moved } from './solids.mjs';

/** @typedef {import('./solids.mjs').Mesh} Mesh */
/** @typedef {import('./solids.mjs').Point} Point */
/** @typedef {import('./scenes.mjs').SceneBody} SceneBody */
/** @typedef {import('./scenes.mjs').Random} Random */
/** @typedef {(bodies: SceneBody[], random: Random) => Uint8Array | Promise<Uint8Array>} Writer */

const CORE = 'http://schemas.microsoft.com/3dmanufacturing/core/2015/02';
const PRODUCTION = 'http://schemas.microsoft.com/3dmanufacturing/production/2015/06';
const HEAD = '<?xml version="1.0" encoding="UTF-8"?>\n';
const PLATE_MM = 125; // the middle of the plate in transforms of items
const PAINT = '4'; // PrusaSlicer's and Bambu Studio's code of the first filament

/** Returns the bodies' meshes as one, with vertices of their own. @param {Mesh[]} meshes @returns {Mesh} */
function joined(meshes) {
  /** @type {Mesh} */ const all = { positions: [], triangles: [] };
  for (const { positions, triangles } of meshes) {
    const first = all.positions.length;
    all.positions.push(...positions);
    all.triangles.push(...triangles.map((t) => /** @type {Point} */ (t.map((v) => v + first))));
  }
  return all;
}

/** Returns a modifier across the first body: no model. @param {SceneBody[]} bodies @returns {Mesh} */
const modifierOf = ([{ mesh }]) => moved(mesh, [1, 1, 1]);

/** @type {Writer} */
function stl(bodies) {
  const { positions, triangles } = joined(bodies.map(({ mesh }) => mesh));
  const bytes = Buffer.alloc(84 + 50 * triangles.length);
  bytes.writeUInt32LE(triangles.length, 80);
  triangles.forEach((triangle, t) => {
    triangle
      .flatMap((v) => positions[v])
      .forEach((x, i) => {
        bytes.writeFloatLE(x, 84 + 50 * t + 12 + 4 * i);
      });
  });
  return bytes;
}

/** Writes OBJ with a group for each body. @param {string} keyword @returns {Writer} */
const obj = (keyword) => (bodies) => {
  let [text, first] = ['', 1];
  for (const { mesh } of bodies) text += mesh.positions.map((p) => `v ${p.join(' ')}\n`).join('');
  for (const { name, mesh } of bodies) {
    text += `${keyword} ${name}\n${mesh.triangles.map((t) => `f ${t.map((v) => v + first).join(' ')}\n`).join('')}`;
    first += mesh.positions.length;
  }
  return Buffer.from(text);
};

/** @param {Mesh} mesh @param {(triangle: number) => string} [attributes] */
const meshText = ({ positions, triangles }, attributes = () => '') =>
  `<mesh><vertices>${positions.map(([x, y, z]) => `<vertex x="${x}" y="${y}" z="${z}"/>`).join('\n')}</vertices>\n<triangles>${triangles
    .map(([a, b, c], t) => `<triangle v1="${a}" v2="${b}" v3="${c}"${attributes(t)}/>`)
    .join('\n')}</triangles></mesh>`;

/** @param {string} resources @param {string} items @param {string} [spaces] @param {string} [metadata] */
const modelText = (resources, items, spaces = '', metadata = '') =>
  `${HEAD}<model unit="millimeter" xml:lang="en-US" xmlns="${CORE}"${spaces}>${metadata}<resources>${resources}</resources><build>${items}</build></model>`;

/** @param {Record<string, string>} parts @returns {Promise<Uint8Array>} */
async function packed(parts) {
  const types = `${HEAD}<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/><Default Extension="config" ContentType="text/xml"/></Types>`;
  const relationships = `${HEAD}<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>`;
  const files = { '[Content_Types].xml': types, '_rels/.rels': relationships, ...parts };
  const zip = downloadZip(
    Object.entries(files).map(([name, input]) => ({ name, input, lastModified: new Date('2026-01-01') })),
  );
  return new Uint8Array(await zip.arrayBuffer());
}

const onPlate = `transform="1 0 0 0 1 0 0 0 1 ${PLATE_MM} ${PLATE_MM} 0"`;

/** Writes each body as an object of its own, turned by a quarter on the plate. @type {Writer} */
function objects(bodies) {
  const meshes = bodies.map(
    ({ name, mesh }, i) => `<object id="${i + 1}" type="model" name="${name}">${meshText(mesh)}</object>`,
  );
  const items = bodies.map(
    (_, i) => `<item objectid="${i + 1}" transform="0 1 0 -1 0 0 0 0 1 ${PLATE_MM} ${PLATE_MM} 0"/>`,
  );
  return packed({ '3D/3dmodel.model': modelText(meshes.join('\n'), items.join('')) });
}

/** Writes all bodies as components of one object, each at the origin of its own mesh. @type {Writer} */
function components(bodies) {
  const meshes = bodies.map(
    ({ name, mesh, min }, i) =>
      `<object id="${i + 1}" type="model" name="${name}">${meshText(moved(mesh, /** @type {Point} */ (min.map((x) => -x))))}</object>`,
  );
  const parts = bodies.map(
    ({ min }, i) => `<component objectid="${i + 1}" transform="1 0 0 0 1 0 0 0 1 ${min.join(' ')}"/>`,
  );
  const id = bodies.length + 1;
  meshes.push(`<object id="${id}" type="model" name="assembly"><components>${parts.join('')}</components></object>`);
  return packed({ '3D/3dmodel.model': modelText(meshes.join('\n'), `<item objectid="${id}"/>`) });
}

/** Writes one or two objects, each of one mesh that is divided into volumes. @type {Writer} */
function prusaSlicer(bodies, random) {
  const cut = bodies.length > 3 && random() < 0.5 ? 2 : bodies.length;
  const groups = [bodies.slice(0, cut), bodies.slice(cut)].filter(({ length }) => length > 0);
  const painted = Math.floor(random() * 4);
  let [resources, items, config] = ['', '', ''];
  groups.forEach((group, g) => {
    const withModifier = random() < 0.5;
    const meshes = [...group.map(({ mesh }) => mesh), ...(withModifier ? [modifierOf(group)] : [])];
    const attributes = (/** @type {number} */ t) => (t % 5 === painted ? ` slic3rpe:mmu_segmentation="${PAINT}"` : '');
    resources += `<object id="${g + 1}" type="model">${meshText(joined(meshes), attributes)}</object>\n`;
    items += `<item objectid="${g + 1}" ${onPlate} printable="1"/>`;
    let first = 0;
    const volumes = meshes.map((mesh, m) => {
      const last = first + mesh.triangles.length - 1;
      const [name, kind] = m < group.length ? [group[m].name, 'ModelPart'] : ['modifier', 'ParameterModifier'];
      const extruder = m < group.length ? `<metadata type="volume" key="extruder" value="${group[m].extruder}"/>` : '';
      const text = `<volume firstid="${first}" lastid="${last}"><metadata type="volume" key="name" value="${name}"/><metadata type="volume" key="volume_type" value="${kind}"/>${extruder}</volume>`;
      first = last + 1;
      return text;
    });
    config += ` <object id="${g + 1}" instances_count="1"><metadata type="object" key="name" value="object ${g + 1}"/><metadata type="object" key="extruder" value="${group[0].extruder}"/>\n${volumes.join('\n')}</object>\n`;
  });
  const metadata =
    '<metadata name="slic3rpe:Version3mf">1</metadata><metadata name="slic3rpe:MmPaintingVersion">1</metadata><metadata name="Application">PrusaSlicer-2.5.0</metadata>';
  return packed({
    '3D/3dmodel.model': modelText(
      resources,
      items,
      ' xmlns:slic3rpe="http://schemas.slic3r.org/3mf/2017/06"',
      metadata,
    ),
    'Metadata/Slic3r_PE_model.config': `${HEAD}<config>\n${config}</config>\n`,
  });
}

/** Writes one object of parts, in the model itself or in a part file as newer versions do. @param {boolean} inPartFile @returns {Writer} */
const bambuStudio = (inPartFile) => (bodies, random) => {
  const painted = Math.floor(random() * 4);
  const withModifier = random() < 0.5;
  const meshes = [...bodies.map(({ mesh }) => mesh), ...(withModifier ? [modifierOf(bodies)] : [])];
  const uuid = (/** @type {number} */ i, /** @type {string} */ end) =>
    inPartFile ? ` p:UUID="0000000${i}-${end}-4c1f-9632-d53dff20c8ad"` : '';
  const attributes = (/** @type {number} */ t) => (t % 5 === painted ? ` paint_color="${PAINT}"` : '');
  const parts = meshes.map(
    (mesh, i) => `<object id="${i + 1}"${uuid(i + 1, '81cb')} type="model">${meshText(mesh, attributes)}</object>`,
  );
  const id = meshes.length + 1;
  const path = inPartFile ? ' p:path="/3D/Objects/object_1.model"' : '';
  const own = meshes.map(
    (_, i) => `<component${path} objectid="${i + 1}"${uuid(i + 1, 'b206')} transform="1 0 0 0 1 0 0 0 1 0 0 0"/>`,
  );
  const whole = `<object id="${id}"${uuid(id, '61cb')} type="model"><components>${own.join('')}</components></object>`;
  const settings = meshes.map((_, i) => {
    const [name, kind] = i < bodies.length ? [bodies[i].name, 'normal_part'] : ['modifier', 'modifier_part'];
    const extruder = i < bodies.length ? `<metadata key="extruder" value="${bodies[i].extruder}"/>` : '';
    return `<part id="${i + 1}" subtype="${kind}"><metadata key="name" value="${name}"/>${extruder}</part>`;
  });
  const spaces = ` xmlns:BambuStudio="http://schemas.bambulab.com/package/2021" xmlns:p="${PRODUCTION}"`;
  const metadata =
    '<metadata name="Application">BambuStudio-02.04.00.70</metadata><metadata name="BambuStudio:3mfVersion">1</metadata>';
  const root = inPartFile ? whole : `${parts.join('\n')}${whole}`;
  /** @type {Record<string, string>} */
  const files = {
    '3D/3dmodel.model': modelText(
      root,
      `<item objectid="${id}"${uuid(id, 'b1ec')} ${onPlate} printable="1"/>`,
      spaces,
      metadata,
    ),
    'Metadata/model_settings.config': `${HEAD}<config>\n<object id="${id}"><metadata key="name" value="assembly"/><metadata key="extruder" value="1"/>\n${settings.join('\n')}</object>\n</config>\n`,
  };
  if (inPartFile) {
    files['3D/Objects/object_1.model'] = modelText(parts.join('\n'), '', spaces, metadata);
    files['3D/_rels/3dmodel.model.rels'] =
      `${HEAD}<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/Objects/object_1.model" Id="rel-1" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>`;
  }
  return packed(files);
};

/** Writes an object for each body, and a mesh for supports that is no model. @type {Writer} */
function cura(bodies, random) {
  const meta = (/** @type {string} */ name, /** @type {string} */ value) =>
    `<metadata name="cura:${name}" preserve="1" type="xs:string">${value}</metadata>`;
  const object = (
    /** @type {number} */ i,
    /** @type {string} */ name,
    /** @type {string} */ metadata,
    /** @type {Mesh} */ mesh,
  ) =>
    `<object id="${i}" type="model" name="${name}"><metadatagroup>${metadata}</metadatagroup>${meshText(mesh)}</object>`;
  const texts = bodies.map(({ name, extruder, mesh }, i) =>
    object(i + 1, name, meta('drop_to_buildplate', 'True') + meta('extruder_nr', String(extruder - 1)), mesh),
  );
  const kind = random() < 0.5 ? 'support_mesh' : 'anti_overhang_mesh';
  texts.push(object(bodies.length + 1, 'eraser', meta(kind, 'True'), modifierOf(bodies)));
  const items = texts.map((_, i) => `<item objectid="${i + 1}" ${onPlate}/>`);
  const spaces = ' xmlns:cura="http://software.ultimaker.com/xml/cura/3mf/2015/10"';
  return packed({
    '3D/3dmodel.model': modelText(
      texts.join('\n'),
      items.join(''),
      spaces,
      '<metadata name="Application">Ultimaker Cura 5.8.0</metadata>',
    ),
  });
}

/**
 * Ways to write a scene: the file's extension, and whether PrusaSlicer 2.5 opens it, which does not follow components into
 * other part files.
 * @type {{ name: string, extension: string, write: Writer, opensInPrusaSlicer: boolean }[]}
 */
export const manners = [
  { name: 'shells of an STL', extension: 'stl', write: stl, opensInPrusaSlicer: false },
  { name: 'objects of an OBJ', extension: 'obj', write: obj('o'), opensInPrusaSlicer: false },
  { name: 'groups of an OBJ', extension: 'obj', write: obj('g'), opensInPrusaSlicer: false },
  { name: 'objects of a 3MF', extension: '3mf', write: objects, opensInPrusaSlicer: true },
  { name: 'components of a 3MF', extension: '3mf', write: components, opensInPrusaSlicer: true },
  { name: 'volumes of PrusaSlicer', extension: '3mf', write: prusaSlicer, opensInPrusaSlicer: true },
  { name: 'parts of Bambu Studio', extension: '3mf', write: bambuStudio(false), opensInPrusaSlicer: true },
  { name: 'parts of OrcaSlicer in a part file', extension: '3mf', write: bambuStudio(true), opensInPrusaSlicer: false },
  { name: 'objects of Cura', extension: '3mf', write: cura, opensInPrusaSlicer: true },
];
