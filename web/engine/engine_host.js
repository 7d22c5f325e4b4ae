// SPDX-License-Identifier: GPL-3.0-or-later
// Owns the module and its canvas: in the worker, or in the page where there is no OffscreenCanvas.
import { EngineFailure, describeThrown, internal } from './engine_error.js';
import { Frames, contextOf } from './frames.js';
import { InspectorLink } from './inspector_link.js';
import { JobRunner } from './job_runner.js';
import { message } from './message.js';
import { loadModule } from './module.js';
import { callsOf } from './module_calls.js';
import { kBatchVerbs, kFactVerbs, kHostVerbs, kInnerVerbs, kPageVerbs } from './verbs.js';

/** @typedef {import('./types.js').HostEvent} HostEvent */
/** @typedef {import('./types.js').PrintChange} PrintChange */
/** @typedef {import('./types.js').ViewAction} ViewAction */
/** @typedef {import('./types.js').ViewSize} ViewSize */

const kDragged = new Set(['orbit', 'pan', 'zoom']); // actions that the inspector's window intercepts
const kPictureMs = 1500; // time to refine a picture

/**
 * Answers the verbs of the page: the module's own, and those of kHostVerbs by its methods.
 */
export class EngineHost {
  /**
   * @param {object} options
   * @param {import('./module.js').QReliefModule} options.module
   * @param {HTMLCanvasElement | OffscreenCanvas | null} options.canvas  null: no verb that draws may be called
   * @param {WebGL2RenderingContext | null} options.gl  of the canvas
   * @param {(event: HostEvent) => void} options.notify
   * @param {boolean} options.draws  false: the canvas is never visible
   */
  constructor({ module, canvas, gl, notify, draws }) {
    this.module_ = module;
    this.object_ = new module.Engine();
    this.engine_ = callsOf(this.object_, { ...kPageVerbs, ...kInnerVerbs });
    this.facts_ = callsOf(new module.Facts(), kFactVerbs);
    /** @type {import('./verbs.js').Calls<typeof kBatchVerbs> | undefined} */ this.batch_ = undefined;
    this.canvas_ = /** @type {HTMLCanvasElement | OffscreenCanvas} */ (canvas);
    this.notify_ = notify;
    this.jobs_ = new JobRunner(this.engine_, (progress) => notify({ event: 'progress', progress }));
    this.inspector_ = new InspectorLink(this.engine_, (state) => notify({ event: 'inspector', state }));
    this.frames_ = new Frames({
      gl,
      draw: () => this.drawFrame_(),
      onFailure: (thrown) => notify({ event: 'failure', error: describeThrown(thrown) }),
      isVisible: draws,
    });
    this.hovers_ = 0;
    this.viewState_ = '';
    /** @type {ViewSize} */ this.size_ = { width: 1, height: 1, devicePixelRatio: 1 };
  }

  /**
   * Loads the module and creates its host.
   * @param {HTMLCanvasElement | OffscreenCanvas | null} canvas  null: engraves with the processor and draws nothing
   * @param {(event: HostEvent) => void} notify
   * @param {{ draws?: boolean }} [options]  `draws`: false: the canvas is never visible
   */
  static async create(canvas, notify, { draws = true } = {}) {
    const gl = canvas && contextOf(canvas);
    const module = await loadModule();
    if (gl) module.GL.makeContextCurrent(module.GL.registerContext(gl, { majorVersion: 2 }));
    const host = new EngineHost({ module, canvas, gl, notify, draws });
    canvas?.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      host.frames_.lose();
      notify({ event: 'contextlost' });
    });
    return host;
  }

  /**
   * Answers a verb of the page.
   * @param {string} verb
   * @param {any[]} given
   * @returns {any}
   */
  answer(verb, given) {
    const own = /** @type {Record<string, (...given: any[]) => any>} */ (/** @type {unknown} */ (this));
    if (kHostVerbs.some((known) => known === verb)) return own[verb](...given);
    const calls = verb in kBatchVerbs ? this.planned_() : verb in kFactVerbs ? this.facts_ : this.engine_;
    try {
      return /** @type {Record<string, (...given: any[]) => any>} */ (calls)[verb](...given);
    } finally {
      const row = /** @type {Record<string, import('./verbs.js').Verb<any>>} */ (kPageVerbs)[verb];
      if (row?.draws) this.frames_.request(); // after a failure, too: a failed placement removes the square
    }
  }

  planned_() {
    this.batch_ ??= callsOf(new this.module_.PlannedBatch(), kBatchVerbs);
    return this.batch_;
  }

  /** Sets the size of the canvas and draws at once, because that cleared it. @param {ViewSize} size */
  resize({ width, height, devicePixelRatio }) {
    this.size_ = { width, height, devicePixelRatio };
    this.canvas_.width = Math.max(1, Math.round(width * devicePixelRatio));
    this.canvas_.height = Math.max(1, Math.round(height * devicePixelRatio));
    this.engine_.resize(width, height, devicePixelRatio);
    this.inspector_.giveGlyphs(devicePixelRatio);
    this.frames_.draw();
  }

  /**
   * Puts the centre there, unless the inspector uses the position.
   * @param {import('./types.js').CentreChoice} where
   * @returns {import('./types.js').PickResult}
   */
  setCentre(where) {
    if ('at' in where) {
      const [x, y] = where.at;
      if (this.inspector_.takesPointer || this.drawn_(this.engine_.inspector({ kind: 'pick', x, y })))
        return { hit: false };
    }
    return this.drawn_(this.engine_.setCentre(where));
  }

  /**
   * Finds how to lay the face at a position on the printer's plate, unless the inspector uses the position.
   * @param {[number, number]} at
   * @returns {import('./types.js').LaidFace}
   */
  layFace(at) {
    return this.inspector_.takesPointer ? { hit: false } : this.engine_.layFace(at);
  }

  /**
   * Previews the code at an estimated placement.
   * @param {[number, number] | null} at  on the canvas; null: hides the preview
   * @returns {Promise<import('./types.js').HoverResult>}
   */
  async hover(at) {
    const hover = (this.hovers_ += 1);
    if (!at) return this.drawn_(this.engine_.hover(null));
    await this.frames_.lastDrawn(); // at most one estimate per frame
    if (this.inspector_.takesPointer || this.hovers_ !== hover) return { hit: false };
    const result = this.engine_.hover(at);
    this.frames_.draw();
    return result;
  }

  /**
   * Finds the exact placement of the preview.
   * @returns {Promise<import('./types.js').HoverResult | null>}  null if the pointer moved meanwhile
   */
  async settle() {
    const { hovers_: hover } = this;
    const result = await this.jobs_.settle(() => this.hovers_ !== hover);
    return result && this.drawn_(result);
  }

  /**
   * Searches for the best spots.
   * @returns {Promise<import('./types.js').Spots | null>}  null if cancelled
   */
  findSpots() {
    return this.runJob_({ name: 'spots' });
  }

  /**
   * Does work that the next carving needs, unless a job runs.
   * @param {import('./job_runner.js').Preparation} extent  `search`: also the first search for depths, which shows the
   *   code as it will be carved
   * @returns {Promise<import('./types.js').FoundDepths | null>}  null: nothing is shown
   */
  async prepareEngrave(extent) {
    const depths = await this.jobs_.prepare(extent);
    return depths && this.drawn_(depths);
  }

  /**
   * Searches the depths of the preview, once its exact placement is found, and shows it as it will be carved.
   * @param {boolean} untilShown  see Preparation
   * @returns {Promise<import('./types.js').FoundDepths | null>}  null: nothing is shown, or the pointer moved meanwhile
   */
  async carvePreview(untilShown) {
    const { hovers_: hover } = this;
    const extent = { search: true, hovered: true, untilShown };
    const depths = await this.jobs_.prepare(extent, () => this.hovers_ !== hover);
    return depths && this.drawn_(depths);
  }

  /**
   * Engraves the code until the engraving needs something, or to its end.
   * @param {import('./types.js').EngraveOptions} [options]
   * @param {boolean} [withOverrides]  use the inspector's settings
   * @param {boolean} [printsEarly]    send each attempt's print job as soon as its file is written
   * @returns {Promise<import('./types.js').EngraveAnswer | null>}  null: cancelled
   */
  engrave(options = {}, withOverrides = false, printsEarly = false) {
    return this.runEngraving_({ options: { ...options, withOverrides } }, printsEarly);
  }

  /**
   * Continues an engraving with what it needed. The texts of a print: see setPrintedReadings().
   * @param {{ texts: string[], reader: string } | undefined} read  text decoded in each try on its pictures, '' if none
   * @param {boolean} [printsEarly]  see engrave()
   * @returns {Promise<import('./types.js').EngraveAnswer | null>}  null: cancelled
   */
  async continueEngrave(read, printsEarly = false) {
    if (read) this.engine_.setReadings(read.texts, read.reader);
    return this.runEngraving_({ isBegun: true }, printsEarly);
  }

  /**
   * Ends an engraving early.
   * @returns {import('./types.js').Delivery | null}  its best carving so far; null: none yet
   */
  endEngrave() {
    this.engine_.cancelJob('engrave');
    return this.engine_.carving() > 0 ? this.delivery_() : null;
  }

  /** @param {Partial<import('./job_runner.js').Job<'engrave'>>} job @param {boolean} printsEarly */
  async runEngraving_(job, printsEarly) {
    let isSent = !printsEarly;
    const last = await this.runJob_({
      ...job,
      name: 'engrave',
      onStep: ({ printable }) => {
        if (printable && !isSent) this.notify_({ event: 'printable', job: this.printJob() });
        isSent = !printsEarly || printable;
      },
      onSlice: ({ stage }) => this.tellSearch_(stage),
    });
    if (!last) return null;
    const { needs, carving, best, changes } = last;
    const pictures = needs === 'texts' ? this.engine_.pictures('reading') : [];
    return { needs, carving, best, changes, pictures, ...(needs !== 'texts' && { delivery: this.delivery_() }) };
  }

  /** The current carving. */
  delivery_() {
    const [seen] = this.engine_.pictures('reader');
    return { number: this.engine_.carving(), report: this.engine_.report(), seen };
  }

  /**
   * Starts test-decoding the code from other viewing directions and distances.
   * @returns {number}  trials at most
   */
  startViewTrials() {
    return this.engine_.startJob('view-trials', {}).all ?? 0;
  }

  /** Reports the outcome of the trial. @param {boolean} read */
  noteViewTrial(read) {
    return this.engine_.advanceJob('view-trials', { read });
  }

  cancel() {
    this.jobs_.cancel();
    this.drawn_(this.engine_.show({ carved: false, sizes: false })); // the job may have finished just now
  }

  /** @returns {import('./types.js').MemoryUse} */
  memory() {
    const { GL, HEAPU8 } = this.module_;
    const { buffers, programs, framebuffers, renderbuffers, textures, shaders, vaos, queries, syncs } = GL;
    const tables = { buffers, programs, framebuffers, renderbuffers, textures, shaders, vaos, queries, syncs };
    const glKinds = Object.fromEntries(
      Object.entries(tables).map(([kind, table]) => [kind, table.filter(Boolean).length]),
    );
    const glObjects = Object.values(glKinds).reduce((sum, count) => sum + count, 0);
    return { usedBytes: this.object_.memoryInUse(), heapBytes: HEAPU8.length, glObjects, glKinds };
  }

  /**
   * Returns the print job of the carving.
   * @param {PrintChange} [changed]  changes to the settings of the carving
   * @returns {import('./types.js').PrintJob | null}  null: no print process is chosen
   */
  printJob(changed = {}) {
    const order = this.engine_.printOrder(changed);
    return order && { order, stl: this.engine_.exportModel('stl', 'any', 0) };
  }

  /**
   * Returns other ways to print a carving that are worth trying, the cheapest first.
   * @param {number} number  of the carving
   * @returns {PrintChange[]}  empty if the carving is not the current one
   */
  otherPrints(number) {
    return this.engine_.carving() === number ? this.engine_.otherPrints() : [];
  }

  /**
   * Judges a print made with changed settings.
   * @param {number} number     of the carving that was printed
   * @param {PrintChange} changed
   * @param {string[]} texts    text decoded in each try on the print's pictures
   * @param {number} facingDeg  see Print
   * @returns {import('./types.js').Aspect | null}  null if the carving is not the current one
   */
  judgePrint(number, changed, texts, facingDeg) {
    return this.engine_.carving() === number ? this.engine_.judgePrint(changed, texts, facingDeg) : null;
  }

  /**
   * Reports the decoded texts of a print's pictures.
   * @param {number} number     of the carving that was printed
   * @param {string[]} texts    text decoded in each try, '' if none
   * @param {number} facingDeg  see Print
   * @returns {import('./types.js').PrintedResult | null}  null if the carving is not the current one
   */
  setPrintedReadings(number, texts, facingDeg) {
    if (this.engine_.carving() !== number) return null;
    return { ...this.engine_.setPrintedReadings(texts, facingDeg), report: this.engine_.report() };
  }

  /**
   * Returns the carved model as a file, see Engine::exportModel().
   * @param {string} format
   * @param {import('./types.js').Slicer} [slicer]
   * @param {number} [carving]  number of the last carving or the previous one; 0: the current one
   */
  exportModel(format, slicer = 'any', carving = 0) {
    return written(this.engine_.exportModel(format, slicer, carving), format);
  }

  /**
   * Returns the carved model as files, the named one first, see Engine::exportFiles().
   * @param {string} name
   * @param {number} [carving]  see exportModel()
   */
  exportFiles(name, carving = 0) {
    const files = this.engine_.exportFiles(name, carving);
    written(files[0]?.bytes ?? new Uint8Array(), name.slice(name.lastIndexOf('.') + 1));
    return files;
  }

  /** Returns the plate as 3MF and empties it. @param {string} title */
  exportPlate(title) {
    return written(this.engine_.exportPlate(title), '3mf');
  }

  /** Refines the view for up to kPictureMs and returns it as PNG. */
  async picture() {
    this.resize(this.size_); // redraws: the presented frame can no longer be read
    const until = performance.now() + kPictureMs;
    do this.frames_.waitForLast();
    while (!this.frames_.isLost && performance.now() < until && this.engine_.draw().more);
    const blob = await canvasAsPng(this.canvas_); // starts in the same task as drawing, while the picture still exists
    return new Uint8Array(await blob.arrayBuffer());
  }

  /** Tells the inspector of an event. @param {import('./types.js').InspectorEvent} event */
  inspector(event) {
    this.inspector_.handle(event, this.size_.devicePixelRatio);
    this.frames_.request();
  }

  /** Moves the camera, unless the inspector uses the event. @param {ViewAction} action */
  act(action) {
    if (action.kind === 'pointer') {
      if (!this.inspector_.isShown) return;
      this.inspector_.point(action);
    } else if (action.kind === 'key') {
      this.engine_.inspector(action);
    } else {
      if (this.inspector_.takesPointer && kDragged.has(action.kind)) return;
      this.engine_.look(action);
    }
    this.frames_.request();
  }

  /** Sends the current maps of a depth search. @param {import('./types.js').EngraveProgress['stage']} stage */
  tellSearch_(stage) {
    if (stage?.code !== 'finding-depth') return;
    const [luminance, depths] = [this.engine_.jobMap('search-luminance'), this.engine_.jobMap('search-depths')];
    if (luminance && depths) this.notify_({ event: 'search', search: { luminance, depths } });
  }

  /**
   * Runs a job.
   * @template {'engrave' | 'spots'} Name
   * @param {import('./job_runner.js').Job<Name>} job
   */
  async runJob_(job) {
    try {
      return await this.jobs_.run({
        ...job,
        onSlice: (progress) => {
          job.onSlice?.(progress);
          if (this.inspector_.isShown) this.frames_.request();
        },
      });
    } finally {
      this.frames_.request();
    }
  }

  /**
   * Requests a frame and returns the value.
   * @template T
   * @param {T} value
   * @returns {T}
   */
  drawn_(value) {
    this.frames_.request();
    return value;
  }

  /** Reports the view state if it has changed. @param {import('./types.js').ViewState} state */
  tellView_(state) {
    const text = JSON.stringify(state);
    if (text === this.viewState_) return;
    this.viewState_ = text;
    this.notify_({ event: 'view', state });
  }

  drawFrame_() {
    const { more, view, inspector } = this.engine_.draw();
    return () => {
      this.tellView_(view);
      const isUnsettled = inspector !== null && this.inspector_.report(inspector);
      return isUnsettled || (more && !this.jobs_.isRunning); // no refinement during a job
    };
  }
}

/**
 * Returns the bytes of a file.
 * @param {Uint8Array<ArrayBuffer>} bytes
 * @param {string} format
 * @throws {EngineFailure} if the module has written none
 */
function written(bytes, format) {
  if (bytes.length > 0) return bytes;
  throw new EngineFailure(internal(message('model-not-written', { format: { term: format.toUpperCase() } })));
}

/** @param {HTMLCanvasElement | OffscreenCanvas} canvas @returns {Promise<Blob>} */
function canvasAsPng(canvas) {
  if (!('toBlob' in canvas)) return canvas.convertToBlob({ type: 'image/png' });
  return new Promise((resolve, reject) => {
    canvas.toBlob(
      (blob) => (blob ? resolve(blob) : reject(new EngineFailure(internal(message('no-picture'))))),
      'image/png',
    );
  });
}

/**
 * Returns the buffers to transfer instead of copying.
 * @param {any} value
 * @returns {Transferable[]}
 */
export function transferables(value) {
  if (value instanceof Uint8Array) return [value.buffer];
  if (value?.stl instanceof Uint8Array) return [value.stl.buffer];
  if (value?.pixels instanceof Uint8Array) return [value.pixels.buffer];
  if (value?.[0]?.bytes instanceof Uint8Array) return value.map((/** @type {any} */ file) => file.bytes.buffer);
  return [];
}
