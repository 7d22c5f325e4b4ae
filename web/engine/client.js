// SPDX-License-Identifier: GPL-3.0-or-later
// The page's only access to the module: one promise per verb. The module runs in a worker, else in the page.
import { EngineFailure, crash, describeThrown, hung, internal } from './engine_error.js';
import { message } from './message.js';
import { kBatchVerbs, kFactVerbs, kHostVerbs, kPageVerbs } from './verbs.js';

/** @typedef {import('./types.js').HostEvent} HostEvent */
/** @typedef {import('./types.js').EngraveProgress} EngraveProgress */
/** @typedef {import('./types.js').ViewAction} ViewAction */
/** @typedef {import('./types.js').ViewSize} ViewSize */
/** @typedef {import('./types.js').Settings} Settings */

const kCancelPatienceMs = 4000; // replace a worker that takes longer to end its step
const kTickMs = 5000; // interval at which a worker's silence is checked
const kUnheardMs = 15_000; // an idle worker that does not take up a verb for longer is dead
const kSilenceMs = 120_000; // a worker that is silent for longer hangs;
const kLoadBytesPerMs = 100; // the limit grows by 1 ms for this many bytes of a file to read

/**
 * Options of a job. Aborting settles the promise at once. The module ends its step and keeps the model; it is replaced
 * if that takes too long.
 * @typedef {{ signal: AbortSignal, onProgress: (progress: EngraveProgress) => void }} JobOptions
 * Of an engraving. `onPrintable`: gets the result of printJob() before an attempt is finished.
 * @typedef {JobOptions & { onPrintable?: (job: import('./types.js').PrintJob | null) => void }} EngraveJobOptions
 */

/** @typedef {{ resolve: (value: any) => void, reject: (reason: unknown) => void, isHeard: boolean }} Pending */

/**
 * Runs the verbs: in a worker, or in the page.
 * @typedef {{ send: (verb: string, args: any[], transfer: Transferable[]) => Promise<any>, end: () => void }} Backend
 */

/** Tells whether a promise was rejected because the worker was replaced. Do not show this as an error. */
export const isReplaced = (/** @type {unknown} */ thrown) =>
  thrown instanceof EngineFailure && thrown.code === 'engine-replaced';

const kReplaced = internal(message('engine-replaced'));

/**
 * The verbs of the host, each with a promise of its answer.
 * @template Calls
 * @typedef {{ [Name in keyof Calls]: Calls[Name] extends (...given: infer Given) => infer Answer
 *   ? (...given: Given) => Promise<Awaited<Answer>> : never }} Remote
 */
/** @typedef {import('./verbs.js').Calls<typeof kPageVerbs>} PageCalls */
/** @typedef {import('./verbs.js').Calls<typeof kBatchVerbs>} BatchCalls */
/** @typedef {import('./verbs.js').Calls<typeof kFactVerbs>} FactCalls */
/** @typedef {Pick<import('./engine_host.js').EngineHost, typeof kHostVerbs[number]>} HostCalls */
/** @typedef {'loadModel' | 'findSpots' | 'prepareEngrave' | 'carvePreview' | 'engrave' | 'continueEngrave'} OwnMethods  of EngineClient */
/** @typedef {Remote<Omit<PageCalls & BatchCalls & FactCalls & HostCalls, OwnMethods>>} VerbMethods */

/** The methods of the client that only hand a verb to the host. */
const Verbs = /** @type {new () => VerbMethods} */ (/** @type {unknown} */ (class {}));
for (const verb of [kPageVerbs, kBatchVerbs, kFactVerbs].flatMap(Object.keys).concat(kHostVerbs))
  Verbs.prototype[verb] = function call(/** @type {any[]} */ ...given) {
    return this.call_(verb, ...given);
  };

export class EngineClient extends Verbs {
  /**
   * @param {object} options
   * @param {() => HTMLCanvasElement | OffscreenCanvas | null} options.makeCanvas
   *   puts a fresh canvas in place of the last one; null: the engine draws nothing and uses the processor
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
    super();
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
   * Engraves the code until the engraving needs something, or to its end.
   * @param {EngraveJobOptions & { options?: import('./types.js').EngraveOptions, withOverrides?: boolean }} options
   *   `withOverrides`: use the inspector's settings
   * @returns {Promise<import('./types.js').EngraveAnswer | undefined>}  undefined if cancelled
   */
  engrave({ options = {}, withOverrides = false, ...job }) {
    return this.runEngraving_('engrave', job, options, withOverrides);
  }

  /**
   * Continues an engraving with what it needed. The texts of a print: see setPrintedReadings().
   * @param {EngraveJobOptions & { read?: { texts: string[], reader: string } }} options
   *   `read`: text decoded in each try on its pictures, '' if none, and the decoder's name
   * @returns {Promise<import('./types.js').EngraveAnswer | undefined>}  undefined if cancelled
   */
  continueEngrave({ read, ...job }) {
    return this.runEngraving_('continueEngrave', job, read);
  }

  /** @param {string} verb @param {EngraveJobOptions} job @param {any[]} args */
  async runEngraving_(verb, { onPrintable, ...job }, ...args) {
    this.onPrintable_ = onPrintable;
    try {
      return (await this.runJob_(verb, job, ...args, onPrintable !== undefined)) ?? undefined;
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
   * Starts work that the next carving needs, unless a job runs.
   * @param {import('./job_runner.js').Preparation} extent  see EngineHost.prepareEngrave
   * @returns {Promise<import('./types.js').FoundDepths | null>}
   */
  async prepareEngrave(extent) {
    // Without a worker, it would block the page.
    return this.backend_ instanceof WorkerBackend ? this.call_('prepareEngrave', extent) : null;
  }

  /**
   * Searches the depths of the preview; see EngineHost.carvePreview.
   * @param {boolean} untilShown
   * @returns {Promise<import('./types.js').FoundDepths | null>}
   */
  async carvePreview(untilShown) {
    return this.backend_ instanceof WorkerBackend ? this.call_('carvePreview', untilShown) : null;
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
    if (!visible) return this.startWorker_(null);
    if (typeof OffscreenCanvas === 'function' && (visible instanceof OffscreenCanvas || canBeTransferred(visible))) {
      const canvas = visible instanceof OffscreenCanvas ? visible : visible.transferControlToOffscreen();
      try {
        return await this.startWorker_(canvas);
      } catch (thrown) {
        if (!(thrown instanceof EngineFailure && thrown.code === 'no-webgl2')) throw thrown;
        if (!this.draws_) return this.startWorker_(null);
        // Some browsers have OffscreenCanvas without WebGL: run the module in the page.
        visible = this.makeCanvas_();
      }
    }
    const { EngineHost } = await import('./engine_host.js');
    return new PageBackend(await EngineHost.create(visible, (event) => this.receive_(event), { draws: this.draws_ }));
  }

  /** @param {OffscreenCanvas | null} canvas @returns {Promise<Backend>} */
  async startWorker_(canvas) {
    const backend = new WorkerBackend((event) => this.receive_(event));
    try {
      await backend.send('start', [canvas, { draws: this.draws_ }], canvas ? [canvas] : []);
      return backend;
    } catch (thrown) {
      backend.end();
      throw thrown;
    }
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
    this.hasLived_ = false; // loading its script may take long
    this.worker_ = new Worker(new URL('./worker.js', import.meta.url), { type: 'module', name: 'qrelief' });
    this.worker_.onmessage = ({ data }) => {
      this.silenceMs_ = 0;
      this.hasLived_ = true;
      if ('event' in data) onEvent(data);
      else if ('heard' in data) this.hear_(data.heard);
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
      this.pending_.set(id, { resolve, reject, isHeard: false });
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
      const isTakenUp = !this.hasLived_ || [...this.pending_.values()].some(({ isHeard }) => isHeard);
      if (this.silenceMs_ < (isTakenUp ? this.allowedMs_ : kUnheardMs)) return;
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

  /** Notes that the worker has taken up a verb. @param {number} id */
  hear_(id) {
    const pending = this.pending_.get(id);
    if (pending) pending.isHeard = true;
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
    return this.host_.answer(verb, args);
  }

  end() {
    this.host_.cancel();
  }
}
