// SPDX-License-Identifier: GPL-3.0-or-later
// Reads model files without the project's own code: the bodies of each object, with names, extruders and paint.
import { unzip } from '../../e2e/support/three_mf.js';

/** @typedef {import('./solids.mjs').Mesh} Mesh */
/** @typedef {{ name: string, object: string, extruder: string, isModel: boolean, mesh: Mesh, transforms: string, paint: string[] }} FileBody */
/** @typedef {{ begin: number, end: number, tag: Record<string, string>, inside: string }} Element */

/** Returns a tag's attributes. @param {string} text @returns {Record<string, string>} */
const attributesOf = (text) =>
  Object.fromEntries([...text.matchAll(/([\w:]+)="([^"]*)"/g)].map(([, key, value]) => [key, value]));

/** Returns the elements of a name that have content or end at once. @param {string} xml @param {string} name */
const elements = (xml, name) =>
  [...xml.matchAll(new RegExp(`<${name}\\b([^>]*?)(?:/>|>(.*?)</${name}>)`, 'gs'))].map(([, tag, inside]) => ({
    tag: attributesOf(tag),
    inside: inside ?? '',
  }));

/** Returns the value of a slicer's setting. @param {string} xml @param {string} key */
const settingOf = (xml, key) => elements(xml, 'metadata').find(({ tag }) => tag.key === key)?.tag.value ?? '';

/** @param {string} inside */
function meshOf(inside) {
  /** @type {Mesh} */ const mesh = { positions: [], triangles: [] };
  /** @type {string[]} */ const paint = [];
  for (const [, x, y, z] of inside.matchAll(/<vertex x="([^"]*)" y="([^"]*)" z="([^"]*)"/g))
    mesh.positions.push([Number(x), Number(y), Number(z)]);
  for (const [, a, b, c, rest] of inside.matchAll(/<triangle v1="(\d+)" v2="(\d+)" v3="(\d+)"([^>]*)\/>/g)) {
    mesh.triangles.push([Number(a), Number(b), Number(c)]);
    paint.push(rest.replace(/ p(?:id|[123])="\d+"/g, ''));
  }
  return { mesh, paint };
}

/** Reads every object of every model part, by part and id. @param {Map<string, string>} files */
function objectsOf(files) {
  /** @type {Map<string, { tag: Record<string, string>, inside: string, mesh: Mesh, paint: string[], cura: string, kind: string, components: Record<string, string>[] }>} */
  const objects = new Map();
  for (const [part, text] of files) {
    if (!part.endsWith('.model')) continue;
    for (const { tag, inside } of elements(text, 'object')) {
      const cura = Object.fromEntries(
        [...inside.matchAll(/<metadata name="cura:(\w+)"[^>]*>([^<]*)</g)].map(([, key, value]) => [key, value]),
      );
      objects.set(`${part} ${tag.id}`, {
        tag,
        inside: '',
        ...meshOf(inside),
        cura: cura.extruder_nr === undefined ? '' : String(1 + Number(cura.extruder_nr)), // Cura counts from 0
        kind: Object.keys(cura).find((key) => key.endsWith('_mesh')) ?? '',
        components: [...inside.matchAll(/<component\b([^>]*)>/g)].map(([, text]) => attributesOf(text)),
      });
    }
  }
  return objects;
}

/** Returns the bodies of a 3MF file, in the order of the build. @param {Uint8Array} bytes @returns {FileBody[]} */
export function read3mf(bytes) {
  const files = unzip(bytes);
  const start = '3D/3dmodel.model';
  const objects = objectsOf(files);
  const prusa = elements(files.get('Metadata/Slic3r_PE_model.config') ?? '', 'object');
  const bambu = elements(files.get('Metadata/model_settings.config') ?? '', 'object');
  /** @type {FileBody[]} */ const bodies = [];
  for (const { tag: item } of elements((files.get(start) ?? '').replace(/.*<build/s, '<build'), 'item')) {
    const settings = bambu.find(({ tag }) => tag.id === item.objectid);
    const place = (/** @type {string} */ part, /** @type {string} */ id, /** @type {string} */ transforms) => {
      const object = objects.get(`${part} ${id}`);
      if (!object) throw new Error(`there is no object ${id} in ${part}`);
      const volumesOf = prusa.find(({ tag }) => tag.id === id);
      const own = settings && elements(settings.inside, 'part').find(({ tag }) => tag.id === id);
      const volumes = volumesOf ? elements(volumesOf.inside, 'volume') : [];
      const whole = { tag: { firstid: '0', lastid: String(object.mesh.triangles.length - 1) }, inside: '' };
      for (const { tag, inside } of volumes.length > 0 ? volumes : [whole]) {
        if (object.mesh.triangles.length === 0) continue;
        const range = [Number(tag.firstid), Number(tag.lastid) + 1];
        const kind = settingOf(inside, 'volume_type');
        bodies.push({
          name: settingOf(own?.inside ?? inside, 'name') || object.tag.name || '',
          object: settingOf((settings ?? volumesOf)?.inside ?? '', 'name'),
          extruder: own ? settingOf(own.inside, 'extruder') : settingOf(inside, 'extruder') || object.cura,
          isModel: ['', 'ModelPart'].includes(kind) && !own?.tag.subtype?.startsWith('modifier') && object.kind === '',
          mesh: { positions: object.mesh.positions, triangles: object.mesh.triangles.slice(...range) },
          transforms,
          paint: object.paint.slice(...range),
        });
      }
      for (const { 'p:path': path, objectid, transform } of object.components)
        place(path ? path.slice(1) : part, objectid, `${transforms}|${transform ?? ''}`);
    };
    place(start, item.objectid, item.transform ?? '');
  }
  return bodies;
}

/** Returns the triangles of a binary STL, each with corners of its own. @param {Uint8Array} bytes @returns {Mesh} */
export function readStl(bytes) {
  const data = Buffer.from(bytes);
  /** @type {Mesh} */ const mesh = { positions: [], triangles: [] };
  for (let t = 0; t < data.readUInt32LE(80); t += 1) {
    for (let k = 0; k < 3; k += 1) {
      const at = 84 + 50 * t + 12 + 12 * k;
      mesh.positions.push([data.readFloatLE(at), data.readFloatLE(at + 4), data.readFloatLE(at + 8)]);
    }
    mesh.triangles.push([3 * t, 3 * t + 1, 3 * t + 2]);
  }
  return mesh;
}

/** Returns the bodies of an OBJ file: its groups or objects, and their materials. @param {Uint8Array} bytes @returns {FileBody[]} */
export function readObj(bytes) {
  /** @type {import('./solids.mjs').Point[]} */ const positions = [];
  /** @type {FileBody[]} */ const bodies = [];
  let [name, material] = ['', ''];
  /** @type {FileBody | undefined} */ let body;
  for (const line of Buffer.from(bytes).toString('utf8').split('\n')) {
    const [keyword, ...words] = line.trim().split(/\s+/);
    if (keyword === 'v') positions.push(/** @type {any} */ (words.slice(0, 3).map(Number)));
    if (keyword === 'o' || keyword === 'g') {
      name = words.join(' ');
      body = undefined;
    }
    if (keyword === 'usemtl') material = words.join(' ');
    if (keyword !== 'f') continue;
    if (!body) {
      body = {
        name,
        object: '',
        extruder: '',
        isModel: true,
        mesh: { positions, triangles: [] },
        transforms: '',
        paint: [],
      };
      bodies.push(body);
    }
    body.mesh.triangles.push(/** @type {any} */ (words.map((word) => Number(word.split('/')[0]) - 1)));
    body.paint.push(material);
  }
  return bodies;
}

/** Returns the corners of a body in the frame of its file. @param {FileBody} body @returns {import('./solids.mjs').Point[]} */
export function worldCorners({ mesh, transforms }) {
  const rows = transforms
    .split('|')
    .filter((text) => text !== '')
    .map((text) => text.split(' ').map(Number))
    .reverse();
  return mesh.positions.map((p) =>
    rows.reduce(
      ([x, y, z], m) => /** @type {any} */ ([0, 1, 2].map((k) => x * m[k] + y * m[3 + k] + z * m[6 + k] + m[9 + k])),
      p,
    ),
  );
}
