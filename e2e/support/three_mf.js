// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the 3MF files from the page without the page's own code.
import { inflateRawSync } from 'node:zlib';

/** @typedef {import('../../web/samples/solid.js').Mesh} Mesh */
/** @typedef {{ name: string, colour: string, cura: string, mesh: Mesh }} Body */

/**
 * Returns the files of an archive, from its central directory.
 * @param {Uint8Array} bytes
 * @returns {Map<string, Buffer>}
 */
export function filesOf(bytes) {
  const data = Buffer.from(bytes);
  const end = data.lastIndexOf('PK\x05\x06');
  /** @type {Map<string, Buffer>} */ const files = new Map();
  let at = data.readUInt32LE(end + 16);
  for (let left = data.readUInt16LE(end + 10); left > 0; left -= 1) {
    const [packedSize, nameSize, extraSize, commentSize, header] = [
      data.readUInt32LE(at + 20),
      data.readUInt16LE(at + 28),
      data.readUInt16LE(at + 30),
      data.readUInt16LE(at + 32),
      data.readUInt32LE(at + 42),
    ];
    const begin = header + 30 + data.readUInt16LE(header + 26) + data.readUInt16LE(header + 28);
    const packed = data.subarray(begin, begin + packedSize);
    const content = data.readUInt16LE(at + 10) === 8 ? inflateRawSync(packed) : packed;
    files.set(data.toString('utf8', at + 46, at + 46 + nameSize), content);
    at += 46 + nameSize + extraSize + commentSize;
  }
  return files;
}

/** Returns the files of an archive as text. @param {Uint8Array} bytes */
export const unzip = (bytes) => new Map([...filesOf(bytes)].map(([name, content]) => [name, content.toString('utf8')]));

/**
 * Returns the attributes of every element with this name.
 * @param {string} xml
 * @param {string} name
 * @returns {Record<string, string>[]}
 */
const elements = (xml, name) =>
  [...xml.matchAll(new RegExp(`<${name}\\b([^>]*)>`, 'g'))].map(([, attributes]) =>
    Object.fromEntries([...attributes.matchAll(/([\w:]+)="([^"]*)"/g)].map(([, key, value]) => [key, value])),
  );

/**
 * Returns every object with a mesh, by id.
 * @param {string} model
 * @returns {Map<string, Body>}
 */
export function bodiesOf(model) {
  const colours = new Map(
    [...model.matchAll(/<m:colorgroup id="(\d+)">\s*<m:color color="([^"]*)"/g)].map(([, id, colour]) => [id, colour]),
  );
  /** @type {Map<string, Body>} */ const bodies = new Map();
  for (const [text] of model.matchAll(/<object\b.*?<\/object>/gs)) {
    if (!text.includes('<mesh>')) continue;
    const [{ id, name, pid }] = elements(text, 'object');
    bodies.set(id, {
      name,
      colour: colours.get(pid) ?? '',
      cura: /name="cura:extruder_nr"[^>]*>(\d+)</.exec(text)?.[1] ?? '',
      mesh: {
        positions: elements(text, 'vertex').map(({ x, y, z }) => [Number(x), Number(y), Number(z)]),
        triangles: elements(text, 'triangle').map(({ v1, v2, v3 }) => [Number(v1), Number(v2), Number(v3)]),
      },
    });
  }
  return bodies;
}

/** Returns the text of all model parts of a file, the root last. @param {Map<string, string>} files */
export const modelsOf = (files) =>
  [...files]
    .filter(([name]) => name.endsWith('.model'))
    .sort(([a], [b]) => Number(a === '3D/3dmodel.model') - Number(b === '3D/3dmodel.model'))
    .map(([, text]) => text)
    .join('\n');

/** Returns the colours of the colour groups. @param {string} models */
export const coloursOf = (models) => new Set(elements(models, 'm:color').map(({ color }) => color));

/** Counts the facets that are painted, by each slicer's attribute. @param {string} models */
export function paintedIn(models) {
  const triangles = elements(models, 'triangle');
  const count = (/** @type {string} */ attribute) => triangles.filter((triangle) => attribute in triangle).length;
  return { prusa: count('slic3rpe:mmu_segmentation'), bambu: count('paint_color') };
}

/**
 * Returns the ids of the bodies in each object on the plate.
 * @param {string} model
 */
export function itemsOf(model) {
  const objects = new Map(
    [...model.matchAll(/<object\b.*?<\/object>/gs)].map(([text]) => [
      elements(text, 'object')[0].id,
      elements(text, 'component').map(({ objectid }) => objectid),
    ]),
  );
  return elements(model, 'item').map(({ objectid }) => objects.get(objectid));
}

/**
 * Returns the extruder of each body in the slicers' own settings, by the body's id.
 * @param {Map<string, string>} files
 */
export function extrudersOf(files) {
  const bambu = [
    ...(files.get('Metadata/model_settings.config') ?? '').matchAll(
      /<part id="(\d+)"(?:(?!<\/part>).)*key="extruder" value="(\d+)"/gs,
    ),
  ];
  const prusa = [
    ...(files.get('Metadata/Slic3r_PE_model.config') ?? '').matchAll(
      /<object id="(\d+)"(?:(?!<\/object>).)*?key="extruder" value="(\d+)"/gs,
    ),
  ];
  const byId = (/** @type {RegExpMatchArray[]} */ found) =>
    Object.fromEntries(found.map(([, id, number]) => [id, number]));
  return { bambu: byId(bambu), prusa: byId(prusa) };
}
