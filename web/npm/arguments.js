// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the arguments of callers before any work begins. The engine checks settings and contents of files itself.
import { EngineFailure } from '../engine/engine_error.js';
import { message } from '../engine/message.js';

/** @typedef {'stl' | 'obj' | 'ply' | '3mf' | '3mf-inlay'} Format  `3mf-inlay`: with the body that fills the pockets */
/** The content of a file; a Node `Buffer` is one, too. @typedef {ArrayBuffer | ArrayBufferView} Bytes */

/** @type {readonly Format[]} */
export const kFormats = ['stl', 'obj', 'ply', '3mf', '3mf-inlay'];
const kExtensions = kFormats.filter((format) => format !== '3mf-inlay');

/** The file name of a model without one: its content tells the format. */
export const kModelName = 'model';

/**
 * Returns the bytes of a file without copying them.
 * @param {Bytes} value
 * @returns {Uint8Array}
 * @throws {TypeError} if it has no bytes
 */
export function bytesOf(value) {
  if (ArrayBuffer.isView(value)) return new Uint8Array(value.buffer, value.byteOffset, value.byteLength);
  if (isArrayBuffer(value)) return new Uint8Array(value);
  throw new TypeError(
    `The content of a file must be an ArrayBuffer, a typed array or a Buffer, not ${kindOf(value)}. Read the file first.`,
  );
}

/** Returns the name of a file. @param {string} value @throws {TypeError} if it is no string */
export function fileNameOf(value) {
  if (typeof value === 'string') return value;
  throw new TypeError(`The name of a file must be a string, not ${kindOf(value)}`);
}

/** @param {unknown} formats @throws {TypeError | RangeError} if it is no list, or has an unknown format */
export function checkFormats(formats) {
  if (!Array.isArray(formats)) throw new TypeError(`The formats must be an array, not ${kindOf(formats)}`);
  formats.forEach(checkFormat);
}

/** @param {unknown} format @throws {RangeError} if there is no such format */
export function checkFormat(format) {
  if (/** @type {readonly unknown[]} */ (kFormats).includes(format)) return;
  throw new RangeError(`There is no format ${JSON.stringify(format)}. The formats are ${kFormats.join(', ')}.`);
}

/** @param {string} name @throws {TypeError | RangeError} if its extension is no format */
export function checkOutputName(name) {
  const extension = /\.(\w+)$/.exec(fileNameOf(name))?.[1].toLowerCase() ?? '';
  if (/** @type {readonly string[]} */ (kExtensions).includes(extension)) return;
  throw new RangeError(`The file name ${JSON.stringify(name)} must end in one of .${kExtensions.join(', .')}.`);
}

/** @param {{ text?: unknown }} settings @throws {EngineFailure} if there is no text to engrave */
export function checkText({ text }) {
  if (text === undefined || text === '') throw new EngineFailure({ kind: 'BadUsage', ...message('text-empty') });
}

/** @param {number} index @throws {TypeError} if it counts nothing */
export function checkIndex(index) {
  if (!Number.isInteger(index) || index < 0)
    throw new TypeError(`An index must be a whole number from 0, not ${writtenOf(index)}`);
}

/** @param {unknown} point @throws {TypeError} if it is no list of three numbers */
export function checkPoint(point) {
  if (!Array.isArray(point) || point.length !== 3 || !point.every(Number.isFinite))
    throw new TypeError(`A point must be an array of three numbers, not ${writtenOf(point)}`);
}

/** Recognises buffers of other realms, too. @param {unknown} value @returns {value is ArrayBuffer} */
const isArrayBuffer = (value) => Object.prototype.toString.call(value) === '[object ArrayBuffer]';

/** @param {unknown} value */
const writtenOf = (value) => (typeof value === 'number' ? String(value) : kindOf(value));

/** Names the kind of a value: "undefined", "a string", "a Blob". @param {any} value */
function kindOf(value) {
  if (value === undefined || value === null) return String(value);
  const kind = typeof value === 'object' ? (value.constructor?.name ?? 'Object') : typeof value;
  return `${/^[aeiou]/i.test(kind) ? 'an' : 'a'} ${kind}`;
}
