// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the module's jobs in slices, so that messages from the page come through.
import { EngineFailure, internal } from './engine_error.js';
import { message } from './message.js';

/** @typedef {import('./types.js').EngraveProgress} EngraveProgress */
/** @typedef {import('./verbs.js').JobAnswers} JobAnswers */
/** @typedef {Pick<import('./verbs.js').Calls<typeof import('./verbs.js').kInnerVerbs>, 'startJob' | 'advanceJob' | 'cancelJob'>} JobVerbs */
/**
 * A job with progress for the page. `isBegun`: it goes on where it needed something; `onStep`: gets the answer of each
 * step; `onSlice`: is called between slices.
 * @template {'engrave' | 'spots'} Name
 * @typedef {{ name: Name, isBegun?: boolean, options?: import('./verbs.js').JobOptions,
 *   onStep?: (progress: JobAnswers[Name]) => void, onSlice?: (progress: JobAnswers[Name]) => void }} Job
 */
/**
 * `untilShown`: only until the code is shown as it will be carved: after the search's first pass, or at its end.
 * @typedef {import('./verbs.js').PreparationOptions & { untilShown?: boolean }} Preparation
 */

const kSliceMs = 40; // work between message checks: a cancel takes effect within one slice plus one step
const kSettleSliceMs = 8; // the same while the pointer may move

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

export class JobRunner {
  /** @type {Job<any> | undefined} */ job_ = undefined;

  /**
   * @param {JobVerbs} engine
   * @param {(progress: EngraveProgress) => void} tell
   */
  constructor(engine, tell) {
    this.engine_ = engine;
    this.tell_ = tell;
  }

  get isRunning() {
    return this.job_ !== undefined;
  }

  /**
   * Runs a job until it ends or needs something.
   * @template {'engrave' | 'spots'} Name
   * @param {Job<Name>} job
   * @returns {Promise<JobAnswers[Name] | null>}  answer of the last step; null if cancelled
   */
  async run(job) {
    if (this.job_) throw new EngineFailure(internal(message('engine-busy')));
    this.job_ = job;
    try {
      const tell = (/** @type {EngraveProgress} */ { stage, fraction, changes }) =>
        this.tell_({ stage, fraction, changes });
      /** @type {string | undefined} */ let stageCode;
      if (!job.isBegun) {
        const begun = this.engine_.startJob(job.name, job.options ?? {});
        if (begun.stage) tell(begun);
        stageCode = begun.stage?.code;
      }
      for (;;) {
        const sliceEnd = performance.now() + kSliceMs;
        let progress;
        do {
          progress = this.engine_.advanceJob(job.name, {});
          job.onStep?.(progress);
          if (progress.stage?.code !== stageCode) tell(progress); // even if the previous stage ended in the same slice
          stageCode = progress.stage?.code;
        } while (!progress.done && performance.now() < sliceEnd);
        tell(progress);
        job.onSlice?.(progress);
        await yieldToMessages();
        if (progress.done) return progress;
        if (this.job_ !== job) return null; // a message cancelled it; the next job may already run
      }
    } finally {
      if (this.job_ === job) this.job_ = undefined;
    }
  }

  /** Cancels the running job, if any. */
  cancel() {
    if (this.job_) this.engine_.cancelJob(this.job_.name);
    this.job_ = undefined;
  }

  /**
   * Does work that the next carving needs, unless a job runs.
   * @param {Preparation} extent
   * @param {() => boolean} [isOutdated]  is called between slices
   * @returns {Promise<import('./types.js').FoundDepths | null>}  null: nothing is shown
   */
  async prepare({ untilShown = false, ...options }, isOutdated = () => false) {
    while (!this.job_ && !isOutdated()) {
      const { done, depths } = this.engine_.advanceJob('preparation', options);
      if (done || (untilShown && depths)) return depths;
      await yieldToMessages();
    }
    return null;
  }

  /**
   * Finds the exact placement of the preview.
   * @param {() => boolean} isOutdated  is called between slices
   * @returns {Promise<JobAnswers['settling'] | null>}  null once outdated
   */
  async settle(isOutdated) {
    this.engine_.startJob('settling', {});
    for (;;) {
      const sliceEnd = performance.now() + kSettleSliceMs;
      do {
        const result = this.engine_.advanceJob('settling', {});
        if (result.done) return result;
      } while (performance.now() < sliceEnd);
      await yieldToMessages();
      if (isOutdated()) return null;
    }
  }
}
