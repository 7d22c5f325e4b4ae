// SPDX-License-Identifier: GPL-3.0-or-later
// Places the code: at the chosen or proposed centre, with the direction and size found there.
import { isReplaced } from '../engine/client.js';
import { describeThrown, isFatal } from '../engine/engine_error.js';
import { text } from '../i18n/catalogue.js';
import { formatMm } from '../i18n/format.js';
import { hintOf, sentenceOf } from '../i18n/messages.js';
import { asSentence } from '../i18n/sentences.js';
import { Signal } from './signal.js';
import { centredAt, chosenCentre, sameCentre } from './work.js';

/** @typedef {import('../engine/types.js').Placement} Placement */
/** @typedef {[number, number, number]} Point */

const kTooLarge = ['code-too-large', 'code-too-large-here'];

/**
 * @typedef {object} PlacingOptions
 * @property {import('../engine/client.js').EngineClient} client
 * @property {import('./model_session.js').ModelSession} model
 * @property {import('./work_store.js').WorkStore} store
 * @property {import('../ui/messages.js').Messages} messages
 * @property {import('../ui/place_panel.js').PlacePanel} panel
 * @property {Pick<import('./batching.js').Batching, 'plannedSettings' | 'missing'>} batching
 * @property {Pick<import('../ui/code_panel.js').CodePanel, 'incomplete' | 'incompleteWords'>} code
 * @property {Pick<import('./jobs.js').Jobs, 'busy'>} jobs  while one runs, it needs the centre
 * @property {(action: () => Promise<unknown>) => Promise<void>} guard
 */

export class Placing {
  /** @param {PlacingOptions} options */
  constructor({ client, model, store, messages, panel, batching, code, jobs, guard }) {
    this.client_ = client;
    this.model_ = model;
    this.store_ = store;
    this.messages_ = messages;
    this.panel_ = panel;
    this.batching_ = batching;
    this.code_ = code;
    this.jobs_ = jobs;
    /** Announces another centre. @type {Signal<[]>} */ this.moved = new Signal();
    /** Announces a centre that the program proposes. @type {Signal<[]>} */ this.proposed = new Signal();
    /** Announces the new placement. @type {Signal<[Placement | undefined]>} */ this.placed = new Signal();
    /** @type {Placement | undefined} */ this.placement = undefined;
    /** @type {Promise<void> | undefined} */ this.running_ = undefined;
    /** Why the code was not placed. @type {import('../engine/types.js').EngineError | undefined} */
    this.problem_ = undefined;
    this.isSpotless_ = false; // a search found no spot with room for the code
    this.again_ = false;
    this.isSilent_ = false;
    /** Resolves once the centre picked last is known. @type {Promise<void> | undefined} */ this.moving = undefined;
    panel.listen((centreMm) => void guard(() => this.move(() => client.setCentre({ mm: centreMm }))));
  }

  get mayMove_() {
    return !this.jobs_.busy;
  }

  /** True if the code had no room at its centre. */
  get lacksRoom() {
    return this.problem_?.kind === 'NoSolution';
  }

  /** True if the centre has room for a code, but not for the wanted size. */
  get isTooLarge() {
    return this.problem_ !== undefined && kTooLarge.includes(this.problem_.code);
  }

  /** True if no place on the model is known to have room for the code. */
  get isHopeless() {
    return this.isSpotless_ || this.problem_?.code === 'model-too-small';
  }

  /** True if a click on the model may give the code a spot: it does not mend a wrong setting. */
  get asksForSpot() {
    return !this.isHopeless && (this.problem_ === undefined || this.lacksRoom);
  }

  /** Says what the content lacks to be placed. @returns {import('../i18n/live.js').Words | undefined} */
  get missing() {
    const { code_: code } = this;
    return this.batching_.missing ?? (code.incomplete ? () => asSentence(code.incompleteWords) : undefined);
  }

  /** Takes a proposed centre as chosen: from now on a failed placement there is an error. */
  confirmCentre() {
    this.store_.update({ centreIsGuess: false });
  }

  /** Places the code on a new model: at the chosen centre, or else at the module's proposal. */
  async begin() {
    const { info } = this.model_;
    if (!info) return;
    const chosenMm = chosenCentre(this.store_.work);
    this.show_(undefined);
    if (!info.engravable) {
      this.refuse_(info);
    } else if (chosenMm) {
      await this.move(() => this.client_.setCentre({ mm: chosenMm }));
    } else if (info.centre) {
      this.store_.update(centredAt(info.centre, true));
      await this.place();
    } else {
      this.store_.update(centredAt(undefined));
      this.messages_.say(() => text('page.askForCentre'));
    }
  }

  /**
   * Restores an earlier centre without placing the code.
   * @param {Point | undefined} centreMm
   * @param {boolean} isGuess
   */
  async restoreCentre(centreMm, isGuess) {
    if (!centreMm) return;
    await this.client_.setCentre({ mm: centreMm });
    this.store_.update(centredAt(centreMm, isGuess));
  }

  /** Moves the code. @param {() => Promise<import('../engine/types.js').PickResult>} pick */
  async move(pick) {
    if (!this.mayMove_ || !this.model_.engravable) return;
    const moving = this.take_(pick);
    const known = moving.then(
      () => {},
      () => {}, // the caller reports it
    );
    this.moving = known;
    const taken = await moving.finally(() => {
      if (this.moving === known) this.moving = undefined;
    });
    if (!taken) return;
    const { centre, movedMm } = taken;
    await this.place();
    const isThere = this.placement && !this.again_ && sameCentre(centre, this.store_.work.centreMm); // nor undone
    if (movedMm > 0 && isThere) this.messages_.say(() => text('page.movedOffEdge', { distance: formatMm(movedMm) }));
  }

  /**
   * Takes the picked centre.
   * @param {() => Promise<import('../engine/types.js').PickResult>} pick
   * @returns {Promise<{ centre: Point, movedMm: number } | undefined>}  `movedMm`: how far it was moved off an edge;
   *   undefined: nothing was picked
   */
  async take_(pick) {
    const { hit, centre, movedMm = 0 } = await pick();
    if (!hit || !centre) return undefined;
    this.messages_.clearError();
    this.store_.update(centredAt(centre));
    this.store_.applied.emit('centre');
    this.moved.emit();
    return { centre, movedMm };
  }

  /** Places the code where the program proposes. @param {import('../engine/types.js').CentreChoice} choice */
  async propose(choice) {
    const { hit, centre } = await this.client_.setCentre(choice);
    if (!hit || !centre) return;
    this.store_.update(centredAt(centre, true));
    this.proposed.emit();
    await this.place();
  }

  /**
   * Places the code again. A call while it runs makes it run once more, with the newest settings.
   * @param {boolean} [isSilent]  true: changes the status only to report an error
   */
  place(isSilent = false) {
    this.isSilent_ = isSilent && (this.running_ === undefined || this.isSilent_);
    this.again_ = true;
    this.running_ ??= this.placeUntilNewest_().finally(() => {
      this.running_ = undefined;
    });
    return this.running_;
  }

  async placeUntilNewest_() {
    while (this.again_) {
      this.again_ = false;
      if (!this.model_.engravable) return;
      try {
        // At once: “Ready” no longer holds.
        if (this.mayMove_ && this.store_.work.centreMm) this.tell_(() => text('page.placing'));
        await this.client_.configure(await this.batching_.plannedSettings());
        if (this.store_.work.centreMm === undefined) {
          this.tell_(() => text('page.askForCentre'));
          return;
        }
        this.tell_(() => text('page.placing'));
        this.show_(await this.client_.placement());
        // Otherwise a job asked for the placement and continues.
        if (this.mayMove_ && !this.again_) this.tell_(() => text('page.ready'));
      } catch (thrown) {
        if (isReplaced(thrown) || isFatal(thrown)) throw thrown;
        this.show_(undefined, describeThrown(thrown));
        this.sayProblem_(describeThrown(thrown));
      }
    }
  }

  /** @param {import('../engine/types.js').EngineError} problem */
  sayProblem_(problem) {
    const { missing } = this;
    if (missing) {
      this.messages_.say(missing); // its fields or the list say more
      return;
    }
    const guess = this.store_.work.centreIsGuess;
    if (guess && this.isHopeless) {
      this.explain(problem);
      return;
    }
    this.messages_.say(() => text(guess ? 'page.askForCentre' : 'page.noPlace'));
    if (!this.again_ && !guess) this.messages_.showError(problem);
  }

  /** Says how the placing goes, unless the status keeps what it says. @param {import('../i18n/live.js').Words} words */
  tell_(words) {
    if (!this.isSilent_) this.messages_.say(words);
  }

  /** Shows beside the place why no spot is proposed, and what helps. The status refers to it. @param {import('../engine/types.js').EngineError} problem */
  explain(problem) {
    if (this.missing) return;
    this.isSpotless_ = problem.kind === 'NoSolution';
    this.placed.emit(undefined); // the view no longer asks for a click
    this.messages_.clearError(); // it says less: the code has no room at its centre
    this.panel_.explain(problem);
    this.messages_.say(() => text('page.placeSaysWhy', { step: text('page.place') }));
  }

  /** @param {Placement | undefined} placement @param {import('../engine/types.js').EngineError} [problem] */
  show_(placement, problem) {
    this.placement = placement;
    this.problem_ = problem;
    this.isSpotless_ = false;
    this.panel_.showPlacement(placement);
    this.placed.emit(placement);
  }

  /** @param {import('../engine/types.js').ModelInfo} info */
  refuse_({ findings }) {
    const blocking = findings.filter(({ severity }) => severity === 'blocking');
    this.messages_.showError({
      found: () =>
        blocking
          .map((finding) => asSentence(sentenceOf(finding)))
          .filter(Boolean)
          .join(' ') || text('page.notEngravable'),
      help: () => blocking.map((finding) => hintOf(finding)).find((hint) => hint !== '') ?? '',
    });
    this.messages_.say(() => text('page.notEngravable'));
  }
}
