// SPDX-License-Identifier: GPL-3.0-or-later
// The page's only access to the module: one promise per verb. The module runs in a worker, else in the page.
import { EngineFailure, crash, describeThrown, hung, internal } from './engine_error.js';
import { message } from './message.js';

/** @typedef {import('./types.js').HostEvent} HostEvent */
/** @typedef {import('./types.js').EngraveProgress} EngraveProgress */
/** @typedef {import('./types.js').ViewAction} ViewAction */
/** @typedef {import('./types.js').ViewSize} ViewSize */
/** @typedef {import('./types.js').Settings} Settings */

const kCancelPatienceMs = 4000; // replace a worker that takes longer to end its step
const kTickMs = 5000; // interval at which a worker's silence is checked
const kSilenceMs = 120_000; // a worker that is silent for longer hangs;
const kLoadBytesPerMs = 100; // the limit grows by 1 ms for this many bytes of a file to read

/**
 * Options of a job. Aborting settles the promise at once. The module ends its step and keeps the model; it is replaced
 * if that takes too long.
 * @typedef {{ signal: AbortSignal, onProgress: (progress: EngraveProgress) => void }} JobOptions
 */

/**
 * Options of an engraving. `next`: carve with the change of nextStep(); `print`: look at prints, true by default;
 * `fixed`: keys of settings that must not change.
 * @typedef {{ next?: boolean, print?: boolean, fixed?: string[] }} PlanOptions
 */

/** @typedef {{ resolve: (value: any) => void, reject: (reason: unknown) => void }} Pending */

/**
 * Runs the verbs: in a worker, or in the page.
 * @typedef {{ send: (verb: string, args: any[], transfer: Transferable[]) => Promise<any>, end: () => void }} Backend
 */

/** Tells whether a promise was rejected because the worker was replaced. Do not show this as an error. */
export const isReplaced = (/** @type {unknown} */ thrown) =>
  thrown instanceof EngineFailure && thrown.code === 'engine-replaced';

const kReplaced = internal(message('engine-replaced'));

export class EngineClient {
  /**
   * @param {object} options
   * @param {() => HTMLCanvasElement | OffscreenCanvas} options.makeCanvas  puts a fresh canvas in place of the last one
   * @param {(event: HostEvent) => void} options.onEvent
   *   called when the context is lost or something fails outside any verb
   * @param {(search: import('./types.js').SearchMaps) => void} [options.onSearch]  called during a depth search
   * @param {(state: import('./types.js').ViewState) => void} [options.onView]
   *   called after a frame that changed the view state
   * @param {() => void} [options.onReplaced]
   *   called with a new module, which has no model and no settings yet
   * @param {boolean} [options.draws]                     false: the canvas is never visible
   */
  constructor({ makeCanvas, onEvent, onView = () => {}, onSearch = () => {}, onReplaced = () => {}, draws = true }) {
    this.makeCanvas_ = makeCanvas;
    this.onEvent_ = onEvent;
    this.onView_ = onView;
    this.onSearch_ = onSearch;
    this.onReplaced_ = onReplaced;
    this.draws_ = draws;
    /** @type {Backend | undefined} */ this.backend_ = undefined;
    /** @type {((progress: EngraveProgress) => void) | undefined} */ this.onProgress_ = undefined;
    /** @type {((job: import('./types.js').PrintJob | null) => void) | undefined} */ this.onPrintable_ = undefined;
  }

  /** Loads and starts the module. @returns {Promise<import('./types.js').Capabilities>} */
  async start() {
    if (typeof WebAssembly !== 'object') throw new EngineFailure(internal(message('no-webassembly')));
    this.backend_ = await this.startBackend_();
    return this.call_('capabilities');
  }

  /**
   * Terminates the worker, even a busy one, and rejects its pending verbs with an error that `isReplaced` recognises.
   */
  end() {
    this.backend_?.end();
    this.backend_ = undefined;
  }

  /** Terminates the worker, even a busy one, and starts a new one. */
  async replace() {
    this.end();
    try {
      await this.start();
    } catch (thrown) {
      this.onEvent_({ event: 'failure', error: describeThrown(thrown) });
      return;
    }
    this.onReplaced_();
  }

  /**
   * Loads a model from a file.
   * @param {Uint8Array} bytes  remains usable: the worker gets a copy
   * @param {string} fileName
   * @param {number} scaleToMm
   * @param {{ signal?: AbortSignal }} [options]  aborting replaces the worker
   * @returns {Promise<import('./types.js').ModelInfo>}
   */
  loadModel(bytes, fileName, scaleToMm, { signal } = {}) {
    const replace = () => void this.replace();
    signal?.addEventListener('abort', replace, { once: true });
    return this.call_('loadModel', bytes, fileName, scaleToMm).finally(() =>
      signal?.removeEventListener('abort', replace),
    );
  }

  /**
   * Carves the code.
   * @param {JobOptions & { plan?: PlanOptions, withOverrides?: boolean, onPrintable?: (job: import('./types.js').PrintJob | null) => void }} options
   *   `withOverrides`: use the inspector's settings; `onPrintable`: gets the result of printJob() before the carving
   *   finishes
   * @returns {Promise<boolean>}  false if cancelled
   */
  async engrave({ plan = {}, withOverrides = false, onPrintable, ...options }) {
    this.onPrintable_ = onPrintable;
    try {
      return (await this.runJob_('engrave', options, plan, withOverrides, onPrintable !== undefined)) ?? false;
    } finally {
      if (this.onPrintable_ === onPrintable) this.onPrintable_ = undefined;
    }
  }

  /**
   * Searches for the best spots.
   * @param {JobOptions} options
   * @returns {Promise<import('./types.js').Spots | undefined>}  undefined if cancelled
   */
  async findSpots(options) {
    return (await this.runJob_('findSpots', options)) ?? undefined;
  }

  /**
   * Runs a verb as a job that reports progress and can be aborted.
   * @param {string} verb
   * @param {JobOptions} options
   * @param {any[]} args  of the verb
   * @returns {Promise<any>}  undefined if cancelled
   */
  async runJob_(verb, { signal, onProgress }, ...args) {
    if (signal.aborted) return undefined;
    this.onProgress_ = onProgress;
    const job = this.call_(verb, ...args);
    /** @type {() => void} */ let stop = () => {};
    const stopped = new Promise((resolve) => {
      stop = () => {
        this.stopJob_(job);
        resolve(undefined);
      };
      signal.addEventListener('abort', stop, { once: true });
    });
    try {
      return await Promise.race([job, stopped]);
    } finally {
      signal.removeEventListener('abort', stop);
      if (this.onProgress_ === onProgress) this.onProgress_ = undefined;
    }
  }

  /** Cancels a job; replaces the worker if the job does not end soon. @param {Promise<any>} job */
  stopJob_(job) {
    const patience = setTimeout(() => void this.replace(), kCancelPatienceMs);
    job.catch(() => {}).finally(() => clearTimeout(patience));
    this.call_('cancel').catch(() => {}); // rejected only if the worker is replaced
  }

  /**
   * Places the code at a spot.
   * @param {number} index  into the spots found last
   * @returns {Promise<import('./types.js').PickResult>}
   */
  chooseSpot(index) {
    return this.call_('chooseSpot', index);
  }

  /**
   * Shows or hides the largest possible code sizes as colours on the model.
   * @param {boolean} shown
   * @returns {Promise<void>}
   */
  showSizes(shown) {
    return this.call_('showSizes', shown);
  }

  /** @param {Settings} settings @returns {Promise<void>} */
  configure(settings) {
    return this.call_('configure', settings);
  }

  /**
   * Returns the symbol that these settings engrave.
   * @param {Settings} settings
   * @returns {Promise<import('./types.js').SymbolFacts>}
   */
  symbol(settings) {
    return this.call_('symbol', settings);
  }

  /**
   * Puts the centre at a position on the canvas.
   * @param {number} x
   * @param {number} y
   * @returns {Promise<import('./types.js').PickResult>}
   */
  pick(x, y) {
    return this.call_('pick', x, y);
  }

  /** @param {[number, number, number]} centreMm @returns {Promise<import('./types.js').PickResult>} */
  setCentre(centreMm) {
    return this.call_('setCentre', ...centreMm);
  }

  /** Finds the placement at the centre. @returns {Promise<import('./types.js').Placement>} */
  placement() {
    return this.call_('placement');
  }

  /** Starts work that the next carving needs, unless a job runs. @returns {Promise<void>} */
  async prepareEngrave() {
    // Without a worker, it would block the page.
    if (this.backend_ instanceof WorkerBackend) await this.call_('prepareEngrave');
  }

  /**
   * Returns the number of the finished carving that can be reported and exported.
   * @returns {Promise<number>}  0: none
   */
  carving() {
    return this.call_('carving');
  }

  /** Returns what to do next for the engraving. @returns {Promise<import('./types.js').EngraveStep>} */
  nextStep() {
    return this.call_('nextStep');
  }

  /**
   * Restores a carving.
   * @param {number} number  of the last carving or the one before it
   * @returns {Promise<boolean>}  false: gone
   */
  useCarving(number) {
    return this.call_('useCarving', number);
  }

  /**
   * Previews the code at an estimated placement.
   * @param {number} x
   * @param {number} y
   * @returns {Promise<import('./types.js').HoverResult>}
   */
  hover(x, y) {
    return this.call_('hover', x, y);
  }

  /** @returns {Promise<void>} */
  endHover() {
    return this.call_('endHover');
  }

  /**
   * Finds the exact placement of the preview.
   * @returns {Promise<import('./types.js').HoverResult | null>}  null if the pointer moved
   */
  settle() {
    return this.call_('settle');
  }

  /** @param {number} x @param {number} y @returns {Promise<import('./types.js').HoverResult>} */
  moveCode(x, y) {
    return this.call_('moveCode', x, y);
  }

  /** @param {number} rotateDeg @param {number} symbolMm @returns {Promise<import('./types.js').CodeFacts>} */
  adjustCode(rotateDeg, symbolMm) {
    return this.call_('adjustCode', rotateDeg, symbolMm);
  }

  /**
   * Draws a spot.
   * @param {number} index
   * @param {number} width
   * @param {number} height
   * @returns {Promise<import('./types.js').ColourImage>}
   */
  spotPicture(index, width, height) {
    return this.call_('spotPicture', index, width, height);
  }

  /**
   * Shows or hides a section through the code.
   * @param {boolean} shown
   * @param {number} offset  from its centre, -1 … 1
   * @returns {Promise<void>}
   */
  showSection(shown, offset) {
    return this.call_('showSection', shown, offset);
  }

  /**
   * Shows or hides the depths as colours on the carved model.
   * @param {boolean} shown
   * @returns {Promise<{ topMm: number, deepestMm: number }>}
   *   depth of the last colour and of the deepest pocket; 0 without a carved model
   */
  showDepths(shown) {
    return this.call_('showDepths', shown);
  }

  /** @returns {Promise<import('./types.js').Report>} */
  report() {
    return this.call_('report');
  }

  /** @returns {Promise<import('./types.js').GreyImage>} */
  readerImage() {
    return this.call_('readerImage');
  }

  /**
   * @param {import('./types.js').JobMapName} name
   * @returns {Promise<import('./types.js').JobMap | null>}  null before the first one
   */
  jobMap(name) {
    return this.call_('jobMap', name);
  }

  /** Draws the pictures to decode. @returns {Promise<import('./types.js').GreyImage[]>} */
  readingPictures() {
    return this.call_('readingPictures');
  }

  /**
   * Reports the decoded texts of the reading pictures.
   * @param {string[]} texts  text decoded in each try, '' if none
   * @param {string} reader   name of the decoder
   * @returns {Promise<import('./types.js').ReadingResult>}
   */
  setReadings(texts, reader) {
    return this.call_('setReadings', texts, reader);
  }

  /**
   * Returns the print job of the carving.
   * @param {import('./types.js').PrintChange} [changed]  changes to the settings of the carving
   * @returns {Promise<import('./types.js').PrintJob | null>}  null: no print process is chosen
   */
  printJob(changed = {}) {
    return this.call_('printJob', changed);
  }

  /**
   * Returns other ways to print a carving that are worth trying, the cheapest first.
   * @param {number} number  of the carving
   * @returns {Promise<import('./types.js').PrintChange[]>}  empty if the carving is not the current one
   */
  otherPrints(number) {
    return this.call_('otherPrints', number);
  }

  /**
   * Judges a print made with changed settings.
   * @param {number} number     of the carving that was printed
   * @param {import('./types.js').PrintChange} changed
   * @param {string[]} texts    text decoded in each try on the print's pictures
   * @param {number} facingDeg  see Print
   * @returns {Promise<import('./types.js').Aspect | null>}  null if the carving is not the current one
   */
  judgePrint(number, changed, texts, facingDeg) {
    return this.call_('judgePrint', number, changed, texts, facingDeg);
  }

  /**
   * Reports the decoded texts of a print's pictures.
   * @param {number} number     of the carving that was printed
   * @param {string[]} texts    text decoded in each try, '' if none
   * @param {number} facingDeg  see Print
   * @returns {Promise<import('./types.js').PrintedResult | null>}  null if the carving is not the current one
   */
  setPrintedReadings(number, texts, facingDeg) {
    return this.call_('setPrintedReadings', number, texts, facingDeg);
  }

  /**
   * Starts test-decoding the code from other viewing directions and distances.
   * @returns {Promise<number>}  trials at most
   */
  startViewTrials() {
    return this.call_('startViewTrials');
  }

  /**
   * Draws the pictures of the next trial; decoding one of them is enough.
   * @returns {Promise<import('./types.js').GreyImage[]>}
   */
  viewTrialPictures() {
    return this.call_('viewTrialPictures');
  }

  /**
   * Reports the outcome of the trial.
   * @param {boolean} read
   * @returns {Promise<import('./types.js').ViewTrialProgress>}
   */
  noteViewTrial(read) {
    return this.call_('noteViewTrial', read);
  }

  /** @param {string} format @returns {Promise<Uint8Array<ArrayBuffer>>} */
  exportModel(format) {
    return this.call_('exportModel', format);
  }

  /**
   * Reads a list and checks it as a whole. The other batch verbs refer to its rows.
   * @param {Uint8Array} list  remains usable: the worker gets a copy
   * @param {import('./types.js').WantedBatch} wanted
   * @returns {Promise<import('./types.js').BatchPlan>}
   */
  planBatch(list, wanted) {
    return this.call_('planBatch', list, wanted);
  }

  /** @param {number} from @param {number} count  at most @returns {Promise<import('./types.js').BatchRowName[]>} */
  batchRows(from, count) {
    return this.call_('batchRows', from, count);
  }

  /** @param {number} index  from 0 @returns {Promise<import('./types.js').BatchRow>} */
  batchRow(index) {
    return this.call_('batchRow', index);
  }

  /**
   * Returns all settings of a row as one text.
   * @param {number} index
   * @param {{ centre: number[], others: string }} placed  further inputs of the row's file
   * @returns {Promise<string>}  text to hash as the row's settings for the manifest
   */
  batchRowToHash(index, placed) {
    return this.call_('batchRowToHash', index, placed);
  }

  /**
   * Formats a manifest line.
   * @param {import('./types.js').ManifestEntry} entry
   * @returns {Promise<string>}  without line break
   */
  manifestLine(entry) {
    return this.call_('manifestLine', entry);
  }

  /** Converts manifest lines to CSV. @param {string} lines @param {boolean} withHeader @returns {Promise<string>} */
  manifestCsv(lines, withHeader) {
    return this.call_('manifestCsv', lines, withHeader);
  }

  /** Begins a plate; discards an earlier one. @param {number} copies  on the plate @returns {Promise<void>} */
  startPlate(copies) {
    return this.call_('startPlate', copies);
  }

  /**
   * Puts the current carving on the plate.
   * @param {number} place  from 0
   * @param {string} id
   * @returns {Promise<void>}
   */
  addToPlate(place, id) {
    return this.call_('addToPlate', place, id);
  }

  /** Exports the plate as 3MF and empties it. @param {string} title @returns {Promise<Uint8Array<ArrayBuffer>>} */
  exportPlate(title) {
    return this.call_('exportPlate', title);
  }

  /**
   * Describes the current carving for the manifest.
   * @param {number} totalMs
   * @returns {Promise<import('./types.js').DescribedRow>}
   */
  describeRow(totalMs) {
    return this.call_('describeRow', totalMs);
  }

  /** Takes a picture of the current view. @returns {Promise<Uint8Array<ArrayBuffer>>}  PNG */
  picture() {
    return this.call_('picture');
  }

  /** @param {boolean} dark @returns {Promise<void>} */
  setTheme(dark) {
    return this.call_('setTheme', dark);
  }

  /**
   * @param {import('./types.js').UpAxis} axis  of the model; the code's top points along it
   * @returns {Promise<void>}
   */
  setUpAxis(axis) {
    return this.call_('setUpAxis', axis);
  }

  /** @param {boolean} carved @returns {Promise<void>} */
  showCarved(carved) {
    return this.call_('showCarved', carved);
  }

  /** Loads the inspector without showing it. @returns {Promise<void>} */
  openInspector() {
    return this.call_('openInspector');
  }

  /** @param {boolean} shown @returns {Promise<void>} */
  setInspector(shown) {
    return this.call_('setInspector', shown);
  }

  /** @param {Record<string, string>} texts  translations, by English text @returns {Promise<void>} */
  inspectorTexts(texts) {
    return this.call_('inspectorTexts', texts);
  }

  /** @param {import('./types.js').Area} area  of the canvas that no control covers @returns {Promise<void>} */
  inspectorArea(area) {
    return this.call_('inspectorArea', area);
  }

  /** @param {ViewSize} size @returns {Promise<void>} */
  resize(size) {
    return this.call_('resize', size);
  }

  /** @param {ViewAction} action @returns {Promise<void>} */
  act(action) {
    return this.call_('act', action);
  }

  /** @returns {Promise<import('./types.js').MemoryUse>} */
  memory() {
    return this.call_('memory');
  }

  /**
   * @param {string} verb
   * @param {any[]} args
   * @returns {Promise<any>}
   */
  call_(verb, ...args) {
    if (!this.backend_) return Promise.reject(new EngineFailure(kReplaced));
    return this.backend_.send(verb, args, []);
  }

  /** @returns {Promise<Backend>} */
  async startBackend_() {
    let visible = this.makeCanvas_();
    if (typeof OffscreenCanvas === 'function' && (visible instanceof OffscreenCanvas || canBeTransferred(visible))) {
      const canvas = visible instanceof OffscreenCanvas ? visible : visible.transferControlToOffscreen();
      const backend = new WorkerBackend((event) => this.receive_(event));
      try {
        await backend.send('start', [canvas, { draws: this.draws_ }], [canvas]);
        return backend;
      } catch (thrown) {
        backend.end();
        if (!(thrown instanceof EngineFailure && thrown.code === 'no-webgl2')) throw thrown;
        // Some browsers have OffscreenCanvas without WebGL: run the module in the page.
        visible = this.makeCanvas_();
      }
    }
    const { EngineHost } = await import('./engine_host.js');
    return new PageBackend(await EngineHost.create(visible, (event) => this.receive_(event), { draws: this.draws_ }));
  }

  /** @param {HostEvent} event */
  receive_(event) {
    if (event.event === 'progress') this.onProgress_?.(event.progress);
    else if (event.event === 'printable') this.onPrintable_?.(event.job);
    else if (event.event === 'view') this.onView_(event.state);
    else if (event.event === 'search') this.onSearch_(event.search);
    else this.onEvent_(event);
  }
}

/** Tells whether a worker can draw on the canvas. @param {HTMLCanvasElement} canvas */
const canBeTransferred = (canvas) => 'transferControlToOffscreen' in canvas;

/** Runs the module in a dedicated worker. */
class WorkerBackend {
  /** @param {(event: HostEvent) => void} onEvent */
  constructor(onEvent) {
    /** @type {Map<number, Pending>} */ this.pending_ = new Map();
    this.nextId_ = 1;
    this.onEvent_ = onEvent;
    /** @type {ReturnType<typeof setInterval> | undefined} */ this.clock_ = undefined;
    this.silenceMs_ = 0; // counted in ticks: while a device sleeps, neither the clock nor the worker runs
    this.allowedMs_ = 0;
    this.worker_ = new Worker(new URL('./worker.js', import.meta.url), { type: 'module', name: 'qrelief' });
    this.worker_.onmessage = ({ data }) => {
      this.silenceMs_ = 0;
      if ('event' in data) onEvent(data);
      else this.settle_(data);
    };
    this.worker_.onerror = (event) => {
      event.preventDefault();
      const error = crash(event.message || 'it could not be loaded');
      this.rejectAll_(error);
      onEvent({ event: 'failure', error });
    };
  }

  /**
   * @param {string} verb
   * @param {any[]} args
   * @param {Transferable[]} transfer
   * @returns {Promise<any>}
   */
  send(verb, args, transfer) {
    return new Promise((resolve, reject) => {
      const id = this.nextId_++;
      this.pending_.set(id, { resolve, reject });
      this.worker_.postMessage({ id, verb, args }, transfer);
      this.expectLife_(kSilenceMs + (args[0] instanceof Uint8Array ? args[0].length / kLoadBytesPerMs : 0));
    });
  }

  /** Reports a failure if the worker stays silent longer than this. @param {number} allowedMs */
  expectLife_(allowedMs) {
    this.allowedMs_ = Math.max(allowedMs, this.clock_ === undefined ? 0 : this.allowedMs_);
    if (this.clock_ !== undefined) return;
    this.silenceMs_ = 0;
    this.clock_ = setInterval(() => {
      this.silenceMs_ += kTickMs;
      if (this.silenceMs_ < this.allowedMs_) return;
      this.stopClock_();
      this.onEvent_({ event: 'failure', error: hung(this.silenceMs_) });
    }, kTickMs);
  }

  stopClock_() {
    clearInterval(this.clock_);
    this.clock_ = undefined;
  }

  end() {
    this.stopClock_();
    this.worker_.terminate();
    this.rejectAll_(kReplaced);
  }

  /** @param {{ id: number, value?: any, error?: import('./types.js').EngineError }} answer */
  settle_({ id, value, error }) {
    const pending = this.pending_.get(id);
    this.pending_.delete(id);
    if (this.pending_.size === 0) this.stopClock_();
    if (error) pending?.reject(new EngineFailure(error));
    else pending?.resolve(value);
  }

  /** @param {import('./types.js').EngineError} error */
  rejectAll_(error) {
    const waiting = [...this.pending_.values()];
    this.pending_.clear();
    this.stopClock_();
    waiting.forEach(({ reject }) => reject(new EngineFailure(error)));
  }
}

/** Runs the module in the page. */
class PageBackend {
  /** @param {import('./engine_host.js').EngineHost} host */
  constructor(host) {
    this.host_ = host;
  }

  /** @param {string} verb @param {any[]} args */
  async send(verb, args) {
    return /** @type {Record<string, (...args: any[]) => any>} */ (/** @type {unknown} */ (this.host_.verbs))[verb](
      ...args,
    );
  }

  end() {
    this.host_.verbs.cancel();
  }
}
