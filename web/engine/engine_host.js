// SPDX-License-Identifier: GPL-3.0-or-later
// Owns the module and its canvas: in the worker, or in the page where there is no OffscreenCanvas.
import { EngineFailure, describeThrown, internal } from './engine_error.js';
import { drawGlyphs } from './glyphs.js';
import { message } from './message.js';
import { loadModule } from './module.js';
import { callsOf } from './module_calls.js';
import { kBatchVerbs, kHostVerbs, kInnerVerbs, kPageVerbs } from './verbs.js';

/** @typedef {import('./types.js').HostEvent} HostEvent */
/** @typedef {import('./types.js').PrintChange} PrintChange */
/** @typedef {import('./types.js').ViewAction} ViewAction */
/** @typedef {import('./types.js').ViewSize} ViewSize */
/** @typedef {import('./verbs.js').JobAnswers} JobAnswers */
/**
 * A job of the module that runs in steps, with progress for the page. `onStep`: gets the answer of each step;
 * `onSlice`: is called between slices.
 * @template {'engrave' | 'spots'} Name
 * @typedef {{ name: Name, options?: import('./verbs.js').JobOptions, onStep?: (progress: JobAnswers[Name]) => void,
 *   onSlice?: (progress: JobAnswers[Name]) => void }} Job
 */

const kDragged = new Set(['orbit', 'pan', 'zoom']); // actions that the inspector's window intercepts
const kInspectorFontPx = 14;
const kPictureMs = 1500; // time to refine a picture
const kSliceMs = 40; // work between message checks: a cancel takes effect within one slice plus one step

const kSettleSliceMs = 8; // the same while the pointer may move

/** @type {WebGLContextAttributes} */
const kContextAttributes = {
  antialias: false,
  alpha: false,
  depth: false,
  stencil: false,
  powerPreference: 'high-performance',
};

/** @param {HTMLCanvasElement | OffscreenCanvas} canvas */
function contextOf(canvas) {
  const gl = /** @type {WebGL2RenderingContext | null} */ (canvas.getContext('webgl2', kContextAttributes));
  if (!gl) throw new EngineFailure(internal(message('no-webgl2')));
  gl.getExtension('EXT_color_buffer_float');
  return gl;
}

/**
 * Lets the event loop handle pending messages. Unlike a timer, this is not throttled and takes microseconds.
 * @returns {Promise<void>}
 */
function yieldToMessages() {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
}

/** @returns {Promise<void>} */
const nextFrame = () => new Promise((resolve) => onNextFrame(() => resolve()));

/** @param {() => void} run */
function onNextFrame(run) {
  if (typeof requestAnimationFrame === 'function') requestAnimationFrame(run);
  else setTimeout(run, 16);
}

/**
 * Answers the verbs of the page: the module's own, and those of kHostVerbs by its methods. Draws on demand, and runs jobs
 * in slices.
 */
export class EngineHost {
  /**
   * @param {object} options
   * @param {import('./types.js').QReliefModule} options.module
   * @param {() => Promise<void>} options.loadInspector
   * @param {HTMLCanvasElement | OffscreenCanvas | null} options.canvas  null: no verb that draws may be called
   * @param {WebGL2RenderingContext | null} options.gl  of the canvas
   * @param {(event: HostEvent) => void} options.notify
   * @param {boolean} options.draws  false: the canvas is never visible
   */
  constructor({ module, loadInspector, canvas, gl, notify, draws }) {
    this.module_ = module;
    this.loadInspector_ = loadInspector;
    this.object_ = new module.Engine();
    this.engine_ = callsOf(this.object_, { ...kPageVerbs, ...kInnerVerbs });
    /** @type {import('./verbs.js').Calls<typeof kBatchVerbs> | undefined} */ this.batch_ = undefined;
    this.canvas_ = /** @type {HTMLCanvasElement | OffscreenCanvas} */ (canvas);
    this.gl_ = /** @type {WebGL2RenderingContext} */ (gl);
    /** @type {WebGLSync | null} */ this.fence_ = null; // signals the end of the last frame
    this.notify_ = notify;
    this.draws_ = draws;
    this.frameRequested_ = false;
    /** @type {Job<any> | undefined} */ this.job_ = undefined;
    this.lost_ = false;
    this.inspectorShown_ = false;
    this.inspectorFrames_ = 0; // since it was opened
    this.inspectorTakes_ = false; // the inspector uses the pointer
    this.hovers_ = 0;
    this.viewState_ = '';
    this.inspectorState_ = '';
    this.inspectorStill_ = false;
    this.pixelRatio_ = 1;
    this.glyphsPx_ = 0; // size of the inspector's letters
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
    const { module, loadInspector } = await loadModule();
    if (gl) module.GL.makeContextCurrent(module.GL.registerContext(gl, { majorVersion: 2 }));
    const host = new EngineHost({ module, loadInspector, canvas, gl, notify, draws });
    canvas?.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      host.lost_ = true;
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
    const calls = verb in kBatchVerbs ? this.planned_() : this.engine_;
    try {
      return /** @type {Record<string, (...given: any[]) => any>} */ (calls)[verb](...given);
    } finally {
      const row = /** @type {Record<string, import('./verbs.js').Verb<any>>} */ (kPageVerbs)[verb];
      if (row?.draws) this.invalidate_(); // after a failure, too: a failed placement removes the square
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
    this.pixelRatio_ = devicePixelRatio;
    this.giveGlyphs_();
    this.drawFrame_();
  }

  /**
   * Puts the centre there, unless the inspector uses the position.
   * @param {import('./types.js').CentreChoice} where
   * @returns {import('./types.js').PickResult}
   */
  setCentre(where) {
    if ('at' in where) {
      const [x, y] = where.at;
      if (this.inspectorTakes_ || this.drawn_(this.engine_.inspector({ kind: 'pick', x, y }))) return { hit: false };
    }
    return this.drawn_(this.engine_.setCentre(where));
  }

  /**
   * Previews the code at an estimated placement.
   * @param {[number, number] | null} at  on the canvas; null: hides the preview
   * @returns {Promise<import('./types.js').HoverResult>}
   */
  async hover(at) {
    const asked = (this.hovers_ += 1);
    if (!at) return this.drawn_(this.engine_.hover(null));
    while (this.lastFrameIsUnderWay_()) await nextFrame(); // at most one estimate per frame
    if (this.inspectorTakes_ || this.hovers_ !== asked) return { hit: false };
    const found = this.engine_.hover(at);
    this.drawFrame_();
    return found;
  }

  /**
   * Finds the exact placement of the preview.
   * @returns {Promise<import('./types.js').HoverResult | null>}  null if the pointer moved meanwhile
   */
  async settle() {
    const { hovers_: asked } = this;
    this.engine_.startJob('settling', {});
    for (;;) {
      const sliceEnd = performance.now() + kSettleSliceMs;
      do {
        const found = this.engine_.advanceJob('settling');
        if (found.done) return this.drawn_(found);
      } while (performance.now() < sliceEnd);
      await yieldToMessages();
      if (this.hovers_ !== asked) return null;
    }
  }

  /**
   * Searches for the best spots.
   * @returns {Promise<import('./types.js').Spots | null>}  null if cancelled
   */
  findSpots() {
    return this.runJob_({ name: 'spots' });
  }

  /** Does work that the next carving needs, unless a job runs. */
  async prepareEngrave() {
    while (!this.job_ && !this.engine_.advanceJob('preparation').done) await yieldToMessages();
  }

  /**
   * Carves the code.
   * @param {import('./types.js').PlanOptions} [plan]
   * @param {boolean} [withOverrides]  use the inspector's settings
   * @param {boolean} [printsEarly]    send the print job as soon as the file is written
   * @returns {Promise<boolean>}  false: cancelled
   */
  async engrave(plan = {}, withOverrides = false, printsEarly = false) {
    let isTold = !printsEarly;
    const last = await this.runJob_({
      name: 'engrave',
      options: { ...plan, withOverrides },
      onStep: ({ printable }) => {
        if (isTold || !printable) return;
        isTold = true;
        this.notify_({ event: 'printable', job: this.printJob() });
      },
      onSlice: ({ stage }) => this.tellSearch_(stage),
    });
    return last !== null;
  }

  /**
   * Starts test-decoding the code from other viewing directions and distances.
   * @returns {number}  trials at most
   */
  startViewTrials() {
    return this.engine_.startJob('view-trials', {}).all ?? 0;
  }

  cancel() {
    if (this.job_) this.engine_.cancelJob(this.job_.name);
    this.job_ = undefined;
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
    return order && { order, stl: this.engine_.exportModel('stl', 'any') };
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
    const passed = this.engine_.setPrintedReadings(texts, facingDeg);
    return { passed, report: this.engine_.report() };
  }

  /**
   * Returns the carved model as a file, see Engine::exportModel().
   * @param {string} format
   * @param {import('./types.js').Slicer} [slicer]
   */
  exportModel(format, slicer = 'any') {
    return written(this.engine_.exportModel(format, slicer), format);
  }

  /**
   * Returns the carved model as files, the named one first, see Engine::exportFiles().
   * @param {string} name
   */
  exportFiles(name) {
    const files = this.engine_.exportFiles(name);
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
    do this.waitForFrame_();
    while (!this.lost_ && performance.now() < until && this.engine_.draw().more);
    const blob = await canvasAsPng(this.canvas_); // starts in the same task as drawing, while the picture still exists
    return new Uint8Array(await blob.arrayBuffer());
  }

  /**
   * Tells the inspector of an event.
   * @param {import('./types.js').InspectorEvent} event
   * @returns {Promise<void>}
   */
  async inspector(event) {
    if (event.kind === 'open') await this.loadInspector_();
    if (event.kind === 'show') {
      this.inspectorShown_ = event.shown;
      this.inspectorFrames_ = 0;
      this.inspectorTakes_ = false;
      this.inspectorState_ = '';
      this.inspectorStill_ = false;
    }
    this.drawn_(this.engine_.inspector(event));
    this.giveGlyphs_();
  }

  /** Moves the camera, unless the inspector uses the event. @param {ViewAction} action */
  act(action) {
    if (action.kind === 'pointer') {
      if (!this.inspectorShown_) return;
      this.inspectorTakes_ = this.engine_.inspector(action);
    } else if (action.kind === 'key') {
      this.engine_.inspector(action);
    } else {
      if (this.inspectorTakes_ && kDragged.has(action.kind)) return;
      this.engine_.look(action);
    }
    this.invalidate_();
  }

  /** Sends the current maps of a depth search. @param {import('./types.js').EngraveProgress['stage']} stage */
  tellSearch_(stage) {
    if (stage?.code !== 'finding-depth') return;
    const [luminance, depths] = [this.engine_.jobMap('search-luminance'), this.engine_.jobMap('search-depths')];
    if (luminance && depths) this.notify_({ event: 'search', search: { luminance, depths } });
  }

  /**
   * Runs a job in slices.
   * @template {'engrave' | 'spots'} Name
   * @param {Job<Name>} job
   * @returns {Promise<JobAnswers[Name] | null>}  answer of the last step; null if cancelled
   */
  async runJob_(job) {
    if (this.job_) throw new EngineFailure(internal(message('engine-busy')));
    this.job_ = job;
    try {
      const tell = (/** @type {import('./types.js').EngraveProgress} */ { stage, fraction }) =>
        this.notify_({ event: 'progress', progress: { stage, fraction } });
      const begun = this.engine_.startJob(job.name, job.options ?? {});
      if (begun.stage) tell(begun);
      let told = begun.stage?.code;
      for (;;) {
        const sliceEnd = performance.now() + kSliceMs;
        let progress;
        do {
          progress = this.engine_.advanceJob(job.name);
          job.onStep?.(progress);
          if (progress.stage?.code !== told) tell(progress); // even if the previous stage ended in the same slice
          told = progress.stage?.code;
        } while (!progress.done && performance.now() < sliceEnd);
        tell(progress);
        job.onSlice?.(progress);
        if (this.inspectorShown_) this.invalidate_();
        await yieldToMessages();
        if (progress.done) return progress;
        if (this.job_ !== job) return null; // a message cancelled it; the next job may already run
      }
    } finally {
      if (this.job_ === job) this.job_ = undefined;
      this.invalidate_();
    }
  }

  /**
   * Requests a frame and returns the value.
   * @template T
   * @param {T} value
   * @returns {T}
   */
  drawn_(value) {
    this.invalidate_();
    return value;
  }

  /** Gives the inspector the page's letters at the canvas's resolution. */
  giveGlyphs_() {
    const sizePx = kInspectorFontPx * this.pixelRatio_;
    if (!this.inspectorShown_ || this.glyphsPx_ === sizePx) return;
    const glyphs = drawGlyphs(sizePx);
    if (!glyphs) return;
    this.engine_.inspectorGlyphs(glyphs.lineHeight, glyphs.metrics, glyphs.alpha);
    this.glyphsPx_ = sizePx;
  }

  /**
   * Reports the inspector's state. Dear ImGui takes several frames to lay out a change, so draw until two are equal.
   * @param {import('./verbs.js').InspectorState} state
   */
  tellInspector_(state) {
    const text = JSON.stringify(state);
    const still = text === this.inspectorState_;
    if (!still) this.invalidate_();
    if (still && this.inspectorStill_) return;
    this.inspectorState_ = text;
    this.inspectorStill_ = still;
    this.notify_({ event: 'inspector', state: { ...state, still } });
  }

  /** Requests a frame. Requests before the next frame are merged. */
  invalidate_() {
    if (this.frameRequested_ || this.lost_ || !this.draws_) return;
    this.frameRequested_ = true;
    onNextFrame(() => {
      this.frameRequested_ = false;
      if (this.lastFrameIsUnderWay_()) this.invalidate_();
      else this.drawFrame_();
    });
  }

  /** Blocks until the last frame is drawn, by reading a pixel of it: drawing only queues commands. */
  waitForFrame_() {
    this.gl_.bindFramebuffer(this.gl_.READ_FRAMEBUFFER, null);
    this.gl_.readPixels(0, 0, 1, 1, this.gl_.RGBA, this.gl_.UNSIGNED_BYTE, new Uint8Array(4));
  }

  /** Tells whether the GPU still draws the last frame. Sending more frames now would delay everything after them. */
  lastFrameIsUnderWay_() {
    if (!this.fence_ || this.lost_) return false;
    if (this.gl_.getSyncParameter(this.fence_, this.gl_.SYNC_STATUS) !== this.gl_.SIGNALED) return true;
    this.gl_.deleteSync(this.fence_);
    this.fence_ = null;
    return false;
  }

  /** Reports the view state if it has changed. @param {import('./types.js').ViewState} state */
  tellView_(state) {
    const text = JSON.stringify(state);
    if (text === this.viewState_) return;
    this.viewState_ = text;
    this.notify_({ event: 'view', state });
  }

  drawFrame_() {
    if (this.lost_) return;
    try {
      const { more, view, inspector } = this.engine_.draw();
      this.gl_.deleteSync(this.fence_);
      this.fence_ = this.gl_.fenceSync(this.gl_.SYNC_GPU_COMMANDS_COMPLETE, 0);
      this.gl_.flush();
      this.tellView_(view);
      if (inspector && ++this.inspectorFrames_ > 1) this.tellInspector_(inspector); // not after its first layout
      if (more && !this.job_) this.invalidate_(); // no refinement during a job
    } catch (thrown) {
      this.lost_ = true;
      this.notify_({ event: 'failure', error: describeThrown(thrown) });
    }
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
