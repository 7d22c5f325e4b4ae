// SPDX-License-Identifier: GPL-3.0-or-later
// Owns the module and its canvas: in the worker, or in the page where there is no OffscreenCanvas.
import { copyOf, parseAnswer } from './answers.js';
import { makeBatchVerbs } from './batch_verbs.js';
import { EngineFailure, describeThrown, internal } from './engine_error.js';
import { drawGlyphs } from './glyphs.js';
import { message } from './message.js';
import { loadModule } from './module.js';

/** @typedef {import('./types.js').Engine} Engine */
/** @typedef {import('./types.js').HostEvent} HostEvent */
/** @typedef {import('./types.js').ViewAction} ViewAction */
/** @typedef {import('./types.js').ViewSize} ViewSize */
/**
 * A job of the module that runs in steps.
 * @typedef {{ start: () => string, advance: () => string, cancel: () => void, watch?: (progress: import('./types.js').EngraveProgress) => void }} Job
 *   `watch`: called between slices
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

/** Translates verbs to calls of the module, draws on demand, and runs jobs in slices. */
export class EngineHost {
  /**
   * @param {object} options
   * @param {import('./types.js').QReliefModule} options.module
   * @param {() => Promise<void>} options.loadInspector
   * @param {HTMLCanvasElement | OffscreenCanvas} options.canvas
   * @param {WebGL2RenderingContext} options.gl  of the canvas
   * @param {(event: HostEvent) => void} options.notify
   * @param {boolean} options.draws  false: the canvas is never visible
   */
  constructor({ module, loadInspector, canvas, gl, notify, draws }) {
    this.module_ = module;
    this.loadInspector_ = loadInspector;
    /** @type {Engine} */ this.engine_ = new module.Engine();
    this.canvas_ = canvas;
    this.gl_ = gl;
    /** @type {WebGLSync | null} */ this.fence_ = null; // signals the end of the last frame
    this.notify_ = notify;
    this.draws_ = draws;
    this.frameRequested_ = false;
    /** @type {Job | undefined} */ this.job_ = undefined;
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
   * @param {HTMLCanvasElement | OffscreenCanvas} canvas
   * @param {(event: HostEvent) => void} notify
   * @param {{ draws?: boolean }} [options]  `draws`: false: the canvas is never visible
   */
  static async create(canvas, notify, { draws = true } = {}) {
    const gl = /** @type {WebGL2RenderingContext | null} */ (canvas.getContext('webgl2', kContextAttributes));
    if (!gl) throw new EngineFailure(internal(message('no-webgl2')));
    gl.getExtension('EXT_color_buffer_float');
    const { module, loadInspector } = await loadModule();
    module.GL.makeContextCurrent(module.GL.registerContext(gl, { majorVersion: 2 }));
    const host = new EngineHost({ module, loadInspector, canvas, gl, notify, draws });
    canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      host.lost_ = true;
      notify({ event: 'contextlost' });
    });
    return host;
  }

  /** All verbs that the page may call by name. */
  verbs = {
    capabilities: () => JSON.parse(this.engine_.capabilities()),

    /** @param {Uint8Array} bytes @param {string} fileName @param {number} scaleToMm */
    loadModel: (bytes, fileName, scaleToMm) => {
      const { model } = parseAnswer(this.engine_.loadModel(bytes, fileName, scaleToMm));
      this.invalidate_();
      return model;
    },

    /** @param {ViewSize} size */
    resize: ({ width, height, devicePixelRatio }) => {
      this.size_ = { width, height, devicePixelRatio };
      this.canvas_.width = Math.max(1, Math.round(width * devicePixelRatio));
      this.canvas_.height = Math.max(1, Math.round(height * devicePixelRatio));
      this.engine_.resize(width, height, devicePixelRatio);
      this.pixelRatio_ = devicePixelRatio;
      this.giveGlyphs_();
      this.drawFrame_(); // immediately: resizing cleared the canvas
    },

    /** @param {import('./types.js').Settings} settings */
    configure: (settings) => {
      parseAnswer(this.engine_.configure(JSON.stringify(settings)));
      this.invalidate_();
    },

    /** @param {import('./types.js').Settings} settings */
    symbol: (settings) => parseAnswer(this.engine_.symbol(JSON.stringify(settings))).symbol,

    /** @param {number} x @param {number} y */
    pick: (x, y) =>
      this.inspectorTakes_ || this.drawn_(this.engine_.inspectorPick(x, y))
        ? { hit: false }
        : this.drawn_(JSON.parse(this.engine_.pick(x, y))),

    /** @param {number} x @param {number} y @param {number} z */
    setCentre: (x, y, z) => this.drawn_(JSON.parse(this.engine_.setCentre(x, y, z))),

    /** @param {number} x @param {number} y */
    hover: async (x, y) => {
      const asked = (this.hovers_ += 1);
      while (this.lastFrameIsUnderWay_()) await nextFrame(); // at most one estimate per frame
      if (this.inspectorTakes_ || this.hovers_ !== asked) return { hit: false };
      const found = parseAnswer(this.engine_.hover(x, y));
      this.drawFrame_();
      return found;
    },
    endHover: () => {
      this.hovers_ += 1;
      this.drawn_(this.engine_.endHover());
    },
    settle: () => this.settle_(),
    /** @param {number} x @param {number} y */
    moveCode: (x, y) => this.drawn_(parseAnswer(this.engine_.moveCode(x, y))),
    /** @param {number} rotateDeg @param {number} symbolMm */
    adjustCode: (rotateDeg, symbolMm) => this.drawn_(parseAnswer(this.engine_.adjustCode(rotateDeg, symbolMm)).code),

    placement: () => {
      try {
        return parseAnswer(this.engine_.placement()).placement;
      } finally {
        this.invalidate_(); // a failed placement removes the square
      }
    },

    findSpots: async () => ((await this.findSpots_()) ? parseAnswer(this.engine_.spots()) : null),
    /** @param {number} index */
    chooseSpot: (index) => this.drawn_(parseAnswer(this.engine_.chooseSpot(index))),
    /** @param {boolean} shown */
    showSizes: (shown) => this.drawn_(this.engine_.showSizes(shown)),
    /** @param {number} index @param {number} width @param {number} height */
    spotPicture: (index, width, height) => {
      const picture = this.engine_.spotPicture(index, width, height);
      return { width: picture.width, height: picture.height, pixels: picture.pixels.slice() };
    },
    /** @param {boolean} shown @param {number} offset */
    showSection: (shown, offset) => this.drawn_(this.engine_.showSection(shown, offset)),
    /** @param {boolean} shown */
    showDepths: (shown) => this.drawn_(parseAnswer(this.engine_.showDepths(shown))),

    prepareEngrave: async () => {
      while (!this.job_ && !parseAnswer(this.engine_.prepareEngrave()).done) await yieldToMessages();
    },
    /**
     * @param {import('./client.js').PlanOptions} [plan]
     * @param {boolean} [withOverrides]  use the inspector's settings
     * @param {boolean} [printsEarly]    send the print job as soon as the file is written
     */
    engrave: (plan = {}, withOverrides = false, printsEarly = false) => this.engrave_(plan, withOverrides, printsEarly),
    nextStep: () => parseAnswer(this.engine_.nextStep()),
    cancel: () => {
      this.job_?.cancel();
      this.job_ = undefined;
      this.engine_.showCarved(false); // the job may have finished just now
      this.drawn_(this.engine_.showSizes(false));
    },
    memory: () => this.memory_(),

    carving: () => this.engine_.carving(),
    /** @param {number} number */
    useCarving: (number) => this.drawn_(this.engine_.useCarving(number)),
    report: () => parseAnswer(this.engine_.report()),
    readerImage: () => copyOf(this.engine_.readerImage()),
    /** @param {import('./types.js').JobMapName} name */
    jobMap: (name) => this.engine_.jobMap(name),
    readingPictures: () => this.engine_.readingPictures().map(copyOf),
    /** @param {string[]} texts @param {string} reader */
    setReadings: (texts, reader) => parseAnswer(this.engine_.setReadings(JSON.stringify(texts), reader)),
    /** @param {import('./types.js').PrintChange} changed @returns {import('./types.js').PrintJob | null} */
    printJob: (changed) => {
      const { order } = parseAnswer(this.engine_.printOrder(JSON.stringify(changed)));
      return order && { order, stl: this.engine_.stlToPrint().slice() };
    },
    /** @param {number} number  of the carving @param {string[]} texts @param {number} facingDeg */
    setPrintedReadings: (number, texts, facingDeg) => {
      if (this.engine_.carving() !== number) return null;
      const { passed } = parseAnswer(this.engine_.setPrintedReadings(JSON.stringify(texts), facingDeg));
      return { passed, report: parseAnswer(this.engine_.report()) };
    },
    /** @param {number} number  of the carving @returns {import('./types.js').PrintChange[]} */
    otherPrints: (number) => (this.engine_.carving() === number ? parseAnswer(this.engine_.otherPrints()).others : []),
    /**
     * @param {number} number  of the carving
     * @param {import('./types.js').PrintChange} changed
     * @param {string[]} texts
     * @param {number} facingDeg
     */
    judgePrint: (number, changed, texts, facingDeg) =>
      this.engine_.carving() === number
        ? parseAnswer(this.engine_.judgePrint(JSON.stringify(changed), JSON.stringify(texts), facingDeg)).prints
        : null,
    startViewTrials: () => parseAnswer(this.engine_.startViewTrials()).all,
    viewTrialPictures: () => this.engine_.viewTrialPictures().map(copyOf),
    /** @param {boolean} read */
    noteViewTrial: (read) => parseAnswer(this.engine_.noteViewTrial(read)),
    /** @param {string} format */
    exportModel: (format) => {
      const bytes = this.engine_.exportModel(format);
      if (bytes.length > 0) return bytes.slice();
      throw new EngineFailure(internal(message('model-not-written', { format: { term: format.toUpperCase() } })));
    },

    ...makeBatchVerbs(
      () => this.engine_,
      () => new this.module_.PlannedBatch(),
    ),

    picture: () => this.picture_(),

    /** @param {boolean} dark */
    setTheme: (dark) => this.drawn_(this.engine_.setTheme(dark)),
    /** @param {import('./types.js').UpAxis} axis */
    setUpAxis: (axis) => this.drawn_(this.engine_.setUpAxis(axis)),
    /** @param {boolean} carved */
    showCarved: (carved) => this.drawn_(this.engine_.showCarved(carved)),
    /** Loads the inspector without showing it. Call this before all other inspector verbs. */
    openInspector: async () => {
      await this.loadInspector_();
      this.engine_.openInspector();
    },
    /** @param {boolean} shown */
    setInspector: (shown) => {
      this.inspectorShown_ = shown;
      this.inspectorFrames_ = 0;
      this.inspectorTakes_ = false;
      this.inspectorState_ = '';
      this.inspectorStill_ = false;
      this.drawn_(this.engine_.showInspector(shown));
      this.giveGlyphs_();
    },
    /** @param {Record<string, string>} texts  translations, by English text */
    inspectorTexts: (texts) => this.drawn_(this.engine_.inspectorTexts(JSON.stringify(texts))),
    /** @param {{ x: number, y: number, width: number, height: number }} area  that no control covers */
    inspectorArea: ({ x, y, width, height }) => this.drawn_(this.engine_.inspectorArea(x, y, width, height)),
    /** @param {ViewAction} action */
    act: (action) => this.act_(action),
  };

  /** @param {ViewAction} action */
  act_(action) {
    if (action.kind === 'pointer') {
      if (!this.inspectorShown_) return;
      this.inspectorTakes_ = this.engine_.inspectorPointer(action.x, action.y, action.buttons, action.wheel);
    } else if (action.kind === 'key') {
      this.engine_.inspectorKey(action.key, action.control, action.shift);
    } else if (this.inspectorTakes_ && kDragged.has(action.kind)) {
      return;
    } else if (action.kind === 'standard') {
      this.engine_.standardView(action.name);
    } else if (action.kind === 'faceSection') {
      this.engine_.faceSection();
    } else if (action.kind === 'orbit') {
      this.engine_.orbit(action.dx, action.dy);
    } else if (action.kind === 'pan') {
      this.engine_.pan(action.dx, action.dy);
    } else if (action.kind === 'zoom') {
      this.engine_.zoom(action.factor, action.x, action.y);
    } else if (action.kind === 'fit') {
      this.engine_.fit();
    } else if (action.kind === 'face') {
      this.engine_.faceCode();
    } else {
      this.engine_.readerView();
    }
    this.invalidate_();
  }

  /** @param {import('./client.js').PlanOptions} plan @param {boolean} withOverrides @param {boolean} printsEarly */
  engrave_(plan, withOverrides, printsEarly) {
    let isTold = !printsEarly;
    return this.runJob_({
      start: () => this.engine_.startEngrave(JSON.stringify(plan), withOverrides),
      advance: () => {
        const answer = this.engine_.advance();
        if (!isTold && parseAnswer(answer).printable) {
          isTold = true;
          this.notify_({ event: 'printable', job: this.verbs.printJob({}) });
        }
        return answer;
      },
      watch: ({ stage }) => this.tellSearch_(stage),
      cancel: () => this.engine_.cancel(),
    });
  }

  /** Sends the current maps of a depth search. @param {import('./types.js').EngraveProgress['stage']} stage */
  tellSearch_(stage) {
    if (stage?.code !== 'finding-depth') return;
    const [luminance, depths] = [this.engine_.jobMap('search-luminance'), this.engine_.jobMap('search-depths')];
    if (luminance && depths) this.notify_({ event: 'search', search: { luminance, depths } });
  }

  findSpots_() {
    return this.runJob_({
      start: () => this.engine_.startSpotSearch(),
      advance: () => this.engine_.advanceSpotSearch(),
      cancel: () => this.engine_.cancelSpotSearch(),
    });
  }

  /**
   * Finds the exact placement of the code under the pointer.
   * @returns {Promise<import('./types.js').HoverResult | null>}  null if the pointer moved meanwhile
   */
  async settle_() {
    const { hovers_: asked } = this;
    parseAnswer(this.engine_.startSettling());
    for (;;) {
      const sliceEnd = performance.now() + kSettleSliceMs;
      do {
        const found = parseAnswer(this.engine_.advanceSettling());
        if (found.done) return this.drawn_(found);
      } while (performance.now() < sliceEnd);
      await yieldToMessages();
      if (this.hovers_ !== asked) return null;
    }
  }

  /**
   * Runs a job in slices.
   * @param {Job} job
   * @returns {Promise<boolean>}  false: cancelled
   */
  async runJob_(job) {
    if (this.job_) throw new EngineFailure(internal(message('engine-busy')));
    this.job_ = job;
    try {
      const tell = (/** @type {import('./types.js').EngraveProgress} */ { stage, fraction }) =>
        this.notify_({ event: 'progress', progress: { stage, fraction } });
      const begun = parseAnswer(job.start());
      if (begun.stage) tell(begun);
      let told = begun.stage?.code;
      for (let done = false; !done;) {
        const sliceEnd = performance.now() + kSliceMs;
        let progress;
        do {
          progress = parseAnswer(job.advance());
          if (progress.stage?.code !== told) tell(progress); // even if the previous stage ended in the same slice
          told = progress.stage?.code;
        } while (!progress.done && performance.now() < sliceEnd);
        tell(progress);
        job.watch?.(progress);
        done = progress.done;
        if (this.inspectorShown_) this.invalidate_();
        await yieldToMessages();
        if (this.job_ !== job) return done; // a message cancelled it; the next job may already run
      }
      return true;
    } finally {
      if (this.job_ === job) this.job_ = undefined;
      this.invalidate_();
    }
  }

  /** @returns {import('./types.js').MemoryUse} */
  memory_() {
    const { GL, HEAPU8 } = this.module_;
    const { buffers, programs, framebuffers, renderbuffers, textures, shaders, vaos, queries, syncs } = GL;
    const tables = { buffers, programs, framebuffers, renderbuffers, textures, shaders, vaos, queries, syncs };
    const glKinds = Object.fromEntries(
      Object.entries(tables).map(([kind, table]) => [kind, table.filter(Boolean).length]),
    );
    const glObjects = Object.values(glKinds).reduce((sum, count) => sum + count, 0);
    return { usedBytes: this.engine_.memoryInUse(), heapBytes: HEAPU8.length, glObjects, glKinds };
  }

  /** Refines the view for up to kPictureMs and returns it as PNG. */
  async picture_() {
    this.verbs.resize(this.size_); // redraws: the presented frame can no longer be read
    const until = performance.now() + kPictureMs;
    do this.waitForFrame_();
    while (!this.lost_ && performance.now() < until && this.engine_.draw());
    const blob = await canvasAsPng(this.canvas_); // starts in the same task as drawing, while the picture still exists
    return new Uint8Array(await blob.arrayBuffer());
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
   */
  tellInspector_() {
    const state = this.engine_.inspectorState();
    const still = state === this.inspectorState_;
    if (!still) this.invalidate_();
    if (still && this.inspectorStill_) return;
    this.inspectorState_ = state;
    this.inspectorStill_ = still;
    this.notify_({ event: 'inspector', state: { ...JSON.parse(state), still } });
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

  /** Reports the view state if it has changed. */
  tellView_() {
    const state = this.engine_.viewState();
    if (state === this.viewState_) return;
    this.viewState_ = state;
    this.notify_({ event: 'view', state: JSON.parse(state) });
  }

  drawFrame_() {
    if (this.lost_) return;
    try {
      const wantsAnother = this.engine_.draw();
      this.gl_.deleteSync(this.fence_);
      this.fence_ = this.gl_.fenceSync(this.gl_.SYNC_GPU_COMMANDS_COMPLETE, 0);
      this.gl_.flush();
      this.tellView_();
      if (this.inspectorShown_ && ++this.inspectorFrames_ > 1) this.tellInspector_(); // not after its first layout
      if (wantsAnother && !this.job_) this.invalidate_(); // no refinement during a job
    } catch (thrown) {
      this.lost_ = true;
      this.notify_({ event: 'failure', error: describeThrown(thrown) });
    }
  }
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
  return [];
}
