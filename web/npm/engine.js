// SPDX-License-Identifier: GPL-3.0-or-later
// The engine for other programs: an EngineClient without a view, and a carver that decodes every result.
import { Carver } from '../batch/carver.js';
import { dismissReader } from '../decoder/reader.js';
import { EngineClient } from '../engine/client.js';
import { EngineFailure, internal } from '../engine/engine_error.js';
import { makeHiddenCanvas } from '../engine/hidden_canvas.js';
import { message } from '../engine/message.js';
import { dismissPrinter } from '../engine/printer.js';
import {
  bytesOf,
  checkFormat,
  checkFormats,
  checkIndex,
  checkOutputName,
  checkPoint,
  checkText,
  fileNameOf,
  kModelName,
} from './arguments.js';

/**
 * Settings by key, see options.md. A missing key has its default. The top of the code is not among them: see `up`
 * of `loadModel`.
 * @typedef {Partial<import('../engine/types.js').Settings> & Partial<Record<import('../generated/settings.js').SettingKey, unknown>>} Settings
 */
/** @typedef {[number, number, number]} Point  mm, in the model's coordinates */
/** @typedef {import('../engine/types.js').EngraveProgress} Progress  `fraction`: 0 … 1 of the whole, never decreases */
/**
 * Options of a job. Aborting rejects its promise with the signal's reason.
 * @typedef {{ signal?: AbortSignal, onProgress?: (progress: Progress) => void }} JobOptions
 */
/** @typedef {import('./arguments.js').Bytes} Bytes */
/** @typedef {import('./arguments.js').Format} Format */
/**
 * A finished engraving. `settings`: it was carved with; a deeper preset if the one you chose did not decode.
 * @typedef {{ verdict: import('../engine/types.js').Verdict, report: import('../engine/types.js').Report, settings: Settings }} Engraved
 */

/** Engines that share the decoder's workers. @type {Set<Engine>} */ const running = new Set();

/**
 * One engraving module in its own worker, with one model. Its verbs run one after the other. Every failure rejects with
 * an EngineError; arguments of a wrong kind reject with a TypeError or RangeError.
 */
export class Engine {
  // Private to the language, too: their types need those of the DOM, which package users may lack.
  /** @type {EngineClient} */ #client;
  /** @type {Settings} */ #settings = {};

  /**
   * Starts an engine, in a page, in a worker or in Node. It uses the GPU through WebGL 2 if it can, else the processor.
   * @returns {Promise<Engine>}
   */
  static async start() {
    const engine = new Engine();
    running.add(engine);
    const { problems } = await engine.#client.start();
    if (problems.length === 0) return engine;
    engine.end();
    throw new EngineFailure(internal(message('no-graphics', { why: { cause: problems[0] } })));
  }

  /** Call `Engine.start` instead. */
  constructor() {
    this.#client = new EngineClient({
      makeCanvas: makeHiddenCanvas,
      onEvent: ({ event }) => {
        if (event === 'contextlost' || event === 'failure') this.end();
      },
      onReplaced: () => this.end(),
      draws: false,
    });
  }

  /**
   * Ends the worker, even a busy one. Every pending and later verb rejects with the code `engine-replaced`. An engine
   * also ends by itself if its module crashes, or needs more than 4 s to obey an aborted job.
   */
  end() {
    this.#client.end();
    if (!running.delete(this) || running.size > 0) return;
    dismissPrinter();
    dismissReader();
  }

  /**
   * Loads, checks and repairs a model. The `centre` it returns is only the middle of a first view, and a code may not fit
   * there: choose a spot or a centre before you engrave.
   * @param {Bytes} bytes        of an STL, OBJ, PLY, OFF or 3MF file
   * @param {string} [fileName]  its extension tells the format; without it, the content does
   * @param {{ scaleToMm?: number, up?: import('../engine/types.js').UpAxis }} [options]
   *   `scaleToMm`: file units → mm; default: as the file says (3MF), else 1; `up`: the model's upward axis, to which the
   *   top of the code points; default: z
   * @returns {Promise<import('../engine/types.js').ModelInfo>}
   */
  async loadModel(bytes, fileName = kModelName, { scaleToMm = 0, up = 'z' } = {}) {
    const [content, name] = [bytesOf(bytes), fileNameOf(fileName)];
    await this.#client.show({ upAxis: up });
    return this.#client.loadModel(content, name, scaleToMm);
  }

  /**
   * Sets all settings of the next search or engraving.
   * @param {Settings} [settings]
   */
  async configure(settings = {}) {
    await this.#client.configure(asFull(settings));
    this.#settings = { ...settings };
  }

  /**
   * Describes the symbol that the settings give, or the letters of a text alone.
   * @returns {Promise<import('../engine/types.js').SymbolFacts | { letters: import('../engine/types.js').LetterFacts }>}
   */
  symbol() {
    return this.#client.symbol(asFull(this.#settings));
  }

  /**
   * Searches for the best spots.
   * @param {JobOptions} [options]
   * @returns {Promise<import('../engine/types.js').Spots>}  best first
   */
  async findSpots(options) {
    const job = jobOf(options);
    const spots = await this.#client.findSpots(job);
    job.signal.throwIfAborted();
    return /** @type {import('../engine/types.js').Spots} */ (spots);
  }

  /**
   * Chooses a spot of the last search, with the viewing direction that was found for it.
   * @param {number} index  from 0; the sentence of an error counts from 1
   */
  async chooseSpot(index) {
    checkIndex(index);
    await this.#client.setCentre({ spot: index });
  }

  /**
   * Chooses the surface point nearest to a point as the centre of the code.
   * @param {Point} centre
   * @returns {Promise<Point>}  the surface point
   */
  async setCentre(centre) {
    checkPoint(centre);
    const { centre: point } = await this.#client.setCentre({ mm: centre });
    if (!point) throw new EngineFailure({ kind: 'BadUsage', ...message('no-centre') });
    return point;
  }

  /**
   * Finds direction and size of the code at the centre, as an engraving will.
   * @returns {Promise<import('../engine/types.js').Placement>}
   */
  placement() {
    return this.#client.placement();
  }

  /**
   * Engraves the code at the centre and decodes the result. Carves with a deeper preset while the code does not decode
   * (unless `keepPreset` is set).
   * @param {JobOptions & { simulatesPrint?: boolean }} [options]
   *   `simulatesPrint`: also simulate the print, and carve deeper if its print barely decodes; default: true
   * @returns {Promise<Engraved>}
   */
  async engrave({ simulatesPrint = true, ...options } = {}) {
    const job = jobOf(options);
    job.signal.throwIfAborted();
    const carver = new Carver({ client: this.#client });
    const settings = await carver.carve(asFull(this.#settings), simulatesPrint, job);
    const report = await this.#client.report();
    return { verdict: report.verification.verdict, report, settings };
  }

  /**
   * Writes the engraved model, after it was read back and compared. See `exportFiles` for codes in two colours.
   * @param {Format} format
   * @returns {Promise<Uint8Array<ArrayBuffer>>}
   */
  async exportModel(format) {
    checkFormat(format);
    await this.#requireEngraved();
    return this.#client.exportModel(format);
  }

  /**
   * Writes the engraved model like `exportModel`, with the file that a code in two colours needs beside it: the body of
   * the second colour for STL (`part-2.stl`), the materials for OBJ (`part.mtl`).
   * @param {string} name  of the first file; its extension tells the format: .stl, .obj, .ply or .3mf
   * @returns {Promise<import('../engine/types.js').NamedFile[]>}
   */
  async exportFiles(name) {
    checkOutputName(name);
    await this.#requireEngraved();
    return this.#client.exportFiles(name);
  }

  async #requireEngraved() {
    if ((await this.#client.carving()) === 0)
      throw new EngineFailure({ kind: 'BadUsage', ...message('nothing-engraved') });
  }
}

/**
 * @typedef {object} EngraveOptions
 * @property {Settings} [settings]     `text` at least, or the promise rejects
 * @property {string} [fileName]       its extension tells the format; without it, the content does
 * @property {number} [scaleToMm]      see `Engine.loadModel`
 * @property {import('../engine/types.js').UpAxis} [up]
 * @property {Point} [centre]          default: the best spot
 * @property {Format[]} [formats]      default: STL
 * @property {boolean} [simulatesPrint]
 * @property {AbortSignal} [signal]
 * @property {(progress: Progress) => void} [onProgress]
 */

/**
 * Engraves a code into a model, in an engine of its own.
 * @param {Bytes} bytes  of the model's file
 * @param {EngraveOptions} [options]
 * @returns {Promise<Engraved & { files: Partial<Record<Format, Uint8Array<ArrayBuffer>>> }>}
 */
export async function engrave(bytes, options = {}) {
  const { settings = {}, fileName, scaleToMm, up, centre, formats = ['stl'], signal } = options;
  bytesOf(bytes);
  checkText(settings);
  checkFormats(formats);
  if (centre) checkPoint(centre);
  signal?.throwIfAborted();
  const engine = await Engine.start();
  const end = () => engine.end();
  signal?.addEventListener('abort', end, { once: true });
  try {
    await engine.configure(settings);
    await engine.loadModel(bytes, fileName, { scaleToMm, up });
    if (centre) {
      await engine.setCentre(centre);
    } else {
      await engine.findSpots(options);
      await engine.chooseSpot(0);
    }
    const engraved = await engine.engrave(options);
    /** @type {Partial<Record<Format, Uint8Array<ArrayBuffer>>>} */ const files = {};
    for (const format of formats) files[format] = await engine.exportModel(format);
    return { ...engraved, files };
  } catch (thrown) {
    signal?.throwIfAborted(); // the end of the engine is only how it was aborted
    throw thrown;
  } finally {
    signal?.removeEventListener('abort', end);
    engine.end();
  }
}

/** Completes the options of a job. @param {JobOptions} [options] @returns {Required<JobOptions>} */
const jobOf = ({ signal = new AbortController().signal, onProgress = () => {} } = {}) => ({ signal, onProgress });

/** The module completes settings itself. @param {Settings} settings */
const asFull = (settings) => /** @type {import('../engine/types.js').Settings} */ (settings);
