// SPDX-License-Identifier: GPL-3.0-or-later
// The page's only way to the module: one promise per verb, whether a worker does the work or the page itself.
import { EngineFailure, crash, describeThrown, hung, internal } from './engine_error.js';
import { message } from './message.js';

/** @typedef {import('./types.js').HostEvent} HostEvent */
/** @typedef {import('./types.js').EngraveProgress} EngraveProgress */
/** @typedef {import('./types.js').ViewAction} ViewAction */
/** @typedef {import('./types.js').ViewSize} ViewSize */
/** @typedef {import('./types.js').Settings} Settings */

const kCancelPatienceMs = 4000;  // a worker that does not come to the end of its step within this time is replaced
const kTickMs = 5000;            // of the clock that waits for a worker's signs of life
const kSilenceMs = 120_000;      // a worker that gives none for so long hangs;
const kLoadBytesPerMs = 100;     // one that reads a file may take this much longer

/**
 * Aborting ends the promise at once. The module ends its step and keeps the model; if that takes too long it is replaced.
 * @typedef {{ signal: AbortSignal, onProgress: (progress: EngraveProgress) => void }} JobOptions
 */

/** @typedef {{ resolve: (value: any) => void, reject: (reason: unknown) => void }} Pending */

/**
 * Where the verbs are carried out.
 * @typedef {{ send: (verb: string, args: any[], transfer: Transferable[]) => Promise<any>, end: () => void }} Backend
 */

/** Whether the reason of a rejection is that the worker was replaced, which is no fault to show. */
export const isReplaced = (/** @type {unknown} */ thrown) => thrown instanceof EngineFailure && thrown.code === 'engine-replaced';

const kReplaced = internal(message('engine-replaced'));

export class EngineClient {
  /**
   * @param {object} options
   * @param {() => HTMLCanvasElement} options.makeCanvas  a fresh canvas in place of the last one
   * @param {(event: HostEvent) => void} options.onEvent  context lost, or a failure outside any verb
   * @param {(search: import('./types.js').SearchMaps) => void} [options.onSearch]  while depths are searched for
   * @param {(state: import('./types.js').ViewState) => void} [options.onView]  after a frame that shows something else
   * @param {() => void} [options.onReplaced]             the module was replaced: it knows no model, no settings
   * @param {boolean} [options.draws]                     whether anybody sees the canvas
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

  /** @returns {Promise<import('./types.js').Capabilities>} */
  async start() {
    if (typeof WebAssembly !== 'object') throw new EngineFailure(internal(message('no-webassembly')));
    this.backend_ = await this.startBackend_();
    return this.call_('capabilities');
  }

  /** Ends the worker, however busy: what was asked of it is rejected, as `isReplaced` tells. */
  end() {
    this.backend_?.end();
    this.backend_ = undefined;
  }

  /** Ends the worker, however busy, and starts anew. */
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
   * @param {Uint8Array} bytes  stays usable: the worker gets a copy
   * @param {string} fileName
   * @param {number} scaleToMm
   * @param {{ signal?: AbortSignal }} [options]  aborting replaces the worker
   * @returns {Promise<import('./types.js').ModelInfo>}
   */
  loadModel(bytes, fileName, scaleToMm, { signal } = {}) {
    const replace = () => void this.replace();
    signal?.addEventListener('abort', replace, { once: true });
    return this.call_('loadModel', bytes, fileName, scaleToMm).finally(() => signal?.removeEventListener('abort', replace));
  }

  /**
   * @param {JobOptions & { withOverrides?: boolean, onPrintable?: (job: import('./types.js').PrintJob | null) => void }} options
   *   `withOverrides`: of the inspector; `onPrintable`: gets what printJob() returns, before the carving is finished
   * @returns {Promise<boolean>}  false if it was cancelled
   */
  async engrave({ withOverrides = false, onPrintable, ...options }) {
    this.onPrintable_ = onPrintable;
    try {
      return (await this.runJob_('engrave', options, withOverrides, onPrintable !== undefined)) ?? false;
    } finally {
      if (this.onPrintable_ === onPrintable) this.onPrintable_ = undefined;
    }
  }

  /**
   * @param {JobOptions} options
   * @returns {Promise<import('./types.js').Spots | undefined>}  none if it was cancelled
   */
  async findSpots(options) {
    return (await this.runJob_('findSpots', options)) ?? undefined;
  }

  /**
   * @param {string} verb
   * @param {JobOptions} options
   * @param {any[]} args  of the verb
   * @returns {Promise<any>}  undefined if it was cancelled
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

  /** @param {Promise<any>} job */
  stopJob_(job) {
    const patience = setTimeout(() => void this.replace(), kCancelPatienceMs);
    job.catch(() => {}).finally(() => clearTimeout(patience));
    this.call_('cancel').catch(() => {});  // rejected only if the worker is replaced
  }

  /** @param {number} index  into the spots found last @returns {Promise<import('./types.js').PickResult>} */
  chooseSpot(index) { return this.call_('chooseSpot', index); }

  /** @param {boolean} shown  the largest sizes, as colours on the model @returns {Promise<void>} */
  showSizes(shown) { return this.call_('showSizes', shown); }

  /** @param {Settings} settings @returns {Promise<void>} */
  configure(settings) { return this.call_('configure', settings); }

  /** The symbol that these settings engrave. @param {Settings} settings @returns {Promise<import('./types.js').SymbolFacts>} */
  symbol(settings) { return this.call_('symbol', settings); }

  /** @param {number} x @param {number} y @returns {Promise<import('./types.js').PickResult>} */
  pick(x, y) { return this.call_('pick', x, y); }

  /** @param {[number, number, number]} centreMm @returns {Promise<import('./types.js').PickResult>} */
  setCentre(centreMm) { return this.call_('setCentre', ...centreMm); }

  /** @returns {Promise<import('./types.js').Placement>} */
  placement() { return this.call_('placement'); }

  /** Begins what the next carving begins with, unless there is something else to do. @returns {Promise<void>} */
  async prepareEngrave() {
    if (this.backend_ instanceof WorkerBackend) await this.call_('prepareEngrave');  // the page itself must not stand still
  }

  /** @returns {Promise<number>}  which finished carving can be reported and exported; 0: none */
  carving() { return this.call_('carving'); }

  /** @param {number} number  of the last carving or the one before it @returns {Promise<boolean>}  whether it is there again */
  useCarving(number) { return this.call_('useCarving', number); }

  /** Shows the code where it would about lie. @param {number} x @param {number} y @returns {Promise<import('./types.js').HoverResult>} */
  hover(x, y) { return this.call_('hover', x, y); }

  /** @returns {Promise<void>} */
  endHover() { return this.call_('endHover'); }

  /** @returns {Promise<import('./types.js').HoverResult | null>}  the true place; none if the pointer moved on */
  settle() { return this.call_('settle'); }

  /** @param {number} x @param {number} y @returns {Promise<import('./types.js').HoverResult>} */
  moveCode(x, y) { return this.call_('moveCode', x, y); }

  /** @param {number} rotateDeg @param {number} symbolMm @returns {Promise<import('./types.js').CodeFacts>} */
  adjustCode(rotateDeg, symbolMm) { return this.call_('adjustCode', rotateDeg, symbolMm); }

  /** @param {number} index @param {number} width @param {number} height @returns {Promise<import('./types.js').ColourImage>} */
  spotPicture(index, width, height) { return this.call_('spotPicture', index, width, height); }

  /** @param {boolean} shown @param {number} offset  from the code's middle, -1 … 1 @returns {Promise<void>} */
  showSection(shown, offset) { return this.call_('showSection', shown, offset); }

  /**
   * @param {boolean} shown
   * @returns {Promise<{ topMm: number, deepestMm: number }>}  depth of the last colour and of the deepest pocket; 0 without a
   *   carved model
   */
  showDepths(shown) { return this.call_('showDepths', shown); }

  /** @returns {Promise<import('./types.js').Report>} */
  report() { return this.call_('report'); }

  /** @returns {Promise<import('./types.js').GreyImage>} */
  readerImage() { return this.call_('readerImage'); }

  /** @param {import('./types.js').JobMapName} name @returns {Promise<import('./types.js').JobMap | null>}  none before there is one */
  jobMap(name) { return this.call_('jobMap', name); }

  /** What readers are to try. @returns {Promise<import('./types.js').GreyImage[]>} */
  readingPictures() { return this.call_('readingPictures'); }

  /**
   * @param {string[]} texts  what each try on the pictures read, '' if nothing
   * @param {string} reader   who read it
   * @returns {Promise<import('./types.js').ReadingResult>}
   */
  setReadings(texts, reader) { return this.call_('setReadings', texts, reader); }

  /**
   * What makes the carving's print; null: none is asked for.
   * @param {import('./types.js').PrintChange} [changed]  of the settings carved with
   * @returns {Promise<import('./types.js').PrintJob | null>}
   */
  printJob(changed = {}) { return this.call_('printJob', changed); }

  /**
   * Other ways of printing a carving that are worth a try, what costs least first.
   * @param {number} number  of the carving
   * @returns {Promise<import('./types.js').PrintChange[]>}  none if another carving is there now
   */
  otherPrints(number) { return this.call_('otherPrints', number); }

  /**
   * What a print with changed settings comes to.
   * @param {number} number     of the carving that was printed
   * @param {import('./types.js').PrintChange} changed
   * @param {string[]} texts    what each try on the print's pictures read
   * @param {number} facingDeg  see Print
   * @returns {Promise<import('./types.js').Aspect | null>}  null if another carving is there now
   */
  judgePrint(number, changed, texts, facingDeg) { return this.call_('judgePrint', number, changed, texts, facingDeg); }

  /**
   * @param {number} number     of the carving that was printed
   * @param {string[]} texts    what each try on the print's pictures read, '' if nothing
   * @param {number} facingDeg  see Print
   * @returns {Promise<import('./types.js').PrintedResult | null>}  null if another carving is there now
   */
  setPrintedReadings(number, texts, facingDeg) { return this.call_('setPrintedReadings', number, texts, facingDeg); }

  /** From where else the code reads: how many pictures there are at most. @returns {Promise<number>} */
  startViewTrials() { return this.call_('startViewTrials'); }

  /** Of the trial that is due: read, if one of them reads. @returns {Promise<import('./types.js').GreyImage[]>} */
  viewTrialPictures() { return this.call_('viewTrialPictures'); }

  /** @param {boolean} read @returns {Promise<import('./types.js').ViewTrialProgress>} */
  noteViewTrial(read) { return this.call_('noteViewTrial', read); }

  /** @param {string} format @returns {Promise<Uint8Array<ArrayBuffer>>} */
  exportModel(format) { return this.call_('exportModel', format); }

  /**
   * Reads a list and checks it as a whole; its rows are those of the verbs that follow.
   * @param {Uint8Array} list  stays usable: the worker gets a copy
   * @param {import('./types.js').WantedBatch} wanted
   * @returns {Promise<import('./types.js').BatchPlan>}
   */
  planBatch(list, wanted) { return this.call_('planBatch', list, wanted); }

  /** @param {number} from @param {number} count  at most @returns {Promise<import('./types.js').BatchRowName[]>} */
  batchRows(from, count) { return this.call_('batchRows', from, count); }

  /** @param {number} index  from 0 @returns {Promise<import('./types.js').BatchRow>} */
  batchRow(index) { return this.call_('batchRow', index); }

  /**
   * @param {number} index
   * @param {{ centre: number[], others: string }} placed  what else decides the row's file
   * @returns {Promise<string>}  whose hash the manifest has as that of the row's settings
   */
  batchRowToHash(index, placed) { return this.call_('batchRowToHash', index, placed); }

  /** @param {import('./types.js').ManifestEntry} entry @returns {Promise<string>}  without its end */
  manifestLine(entry) { return this.call_('manifestLine', entry); }

  /** @param {string} lines  of a manifest @param {boolean} withHeader @returns {Promise<string>}  the same as a table */
  manifestCsv(lines, withHeader) { return this.call_('manifestCsv', lines, withHeader); }

  /** Begins a plate, in place of an earlier one. @param {number} copies  that stand on it @returns {Promise<void>} */
  startPlate(copies) { return this.call_('startPlate', copies); }

  /** Puts the carving that is there on it. @param {number} place  from 0 @param {string} id @returns {Promise<void>} */
  addToPlate(place, id) { return this.call_('addToPlate', place, id); }

  /** The plate as 3MF; it is empty then. @param {string} title @returns {Promise<Uint8Array<ArrayBuffer>>} */
  exportPlate(title) { return this.call_('exportPlate', title); }

  /** What the manifest has of the carving that is there. @param {number} totalMs @returns {Promise<import('./types.js').DescribedRow>} */
  describeRow(totalMs) { return this.call_('describeRow', totalMs); }

  /** The view as it is now. @returns {Promise<Uint8Array<ArrayBuffer>>}  a PNG */
  picture() { return this.call_('picture'); }

  /** @param {boolean} dark @returns {Promise<void>} */
  setTheme(dark) { return this.call_('setTheme', dark); }

  /** @param {import('./types.js').UpAxis} axis  of the model; also where the code's top points @returns {Promise<void>} */
  setUpAxis(axis) { return this.call_('setUpAxis', axis); }

  /** @param {boolean} carved @returns {Promise<void>} */
  showCarved(carved) { return this.call_('showCarved', carved); }

  /** Loads and makes the inspector, not shown yet. @returns {Promise<void>} */
  openInspector() { return this.call_('openInspector'); }

  /** @param {boolean} shown @returns {Promise<void>} */
  setInspector(shown) { return this.call_('setInspector', shown); }

  /** @param {Record<string, string>} texts  of the page's language, by the English ones @returns {Promise<void>} */
  inspectorTexts(texts) { return this.call_('inspectorTexts', texts); }

  /** @param {import('./types.js').Area} area  of the canvas that no control covers @returns {Promise<void>} */
  inspectorArea(area) { return this.call_('inspectorArea', area); }

  /** @param {ViewSize} size @returns {Promise<void>} */
  resize(size) { return this.call_('resize', size); }

  /** @param {ViewAction} action @returns {Promise<void>} */
  act(action) { return this.call_('act', action); }

  /** @returns {Promise<import('./types.js').MemoryUse>} */
  memory() { return this.call_('memory'); }

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
    if (typeof OffscreenCanvas === 'function' && 'transferControlToOffscreen' in HTMLCanvasElement.prototype) {
      const canvas = this.makeCanvas_().transferControlToOffscreen();
      const backend = new WorkerBackend((event) => this.receive_(event));
      try {
        await backend.send('start', [canvas, { draws: this.draws_ }], [canvas]);
        return backend;
      } catch (thrown) {
        backend.end();
        if (!(thrown instanceof EngineFailure && thrown.code === 'no-webgl2')) throw thrown;
        // Some browsers have OffscreenCanvas, but no WebGL on it: the page can still do the work.
      }
    }
    const { EngineHost } = await import('./engine_host.js');
    return new PageBackend(await EngineHost.create(this.makeCanvas_(), (event) => this.receive_(event), { draws: this.draws_ }));
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

/** The module in a dedicated worker. */
class WorkerBackend {
  /** @param {(event: HostEvent) => void} onEvent */
  constructor(onEvent) {
    /** @type {Map<number, Pending>} */ this.pending_ = new Map();
    this.nextId_ = 1;
    this.onEvent_ = onEvent;
    /** @type {ReturnType<typeof setInterval> | undefined} */ this.clock_ = undefined;
    this.silenceMs_ = 0;  // in ticks: a device that slept has not let the worker work, either
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

  /** @param {number} allowedMs */
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

/** The module in the page itself. */
class PageBackend {
  /** @param {import('./engine_host.js').EngineHost} host */
  constructor(host) {
    this.host_ = host;
  }

  /** @param {string} verb @param {any[]} args */
  async send(verb, args) {
    return /** @type {Record<string, (...args: any[]) => any>} */ (/** @type {unknown} */ (this.host_.verbs))[verb](...args);
  }

  end() {
    this.host_.verbs.cancel();
  }
}
