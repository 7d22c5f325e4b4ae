// SPDX-License-Identifier: GPL-3.0-or-later
// The measurements behind the verdict and, on demand, the other views from which the code reads.
import { onLanguage, text } from '../i18n/catalogue.js';
import { byId, make } from '../dom/dom.js';
import { formatNumber, formatPercent, formatPlain } from '../i18n/format.js';

/** @typedef {import('../engine/types.js').Report} Report */
/** @typedef {import('../engine/types.js').Grades} Grades */
/** @typedef {import('../engine/types.js').ViewTrials} Trials */
/** @typedef {(report: Report, onTrial: (tried: number, all: number) => void, signal: AbortSignal) => Promise<Trials | undefined>} ViewTrier */

const kLetters = ['F', 'D', 'C', 'B', 'A'];
const kCounts = ['fixedPatternDamage', 'formatInformation']; // the other measurements are shares
const kParameters = /** @type {const} */ ({
  iso15415: [
    'decode',
    'unusedErrorCorrection',
    'fixedPatternDamage',
    'formatInformation',
    'symbolContrast',
    'modulation',
    'reflectanceMargin',
  ],
  iso29158: [
    'decode',
    'unusedErrorCorrection',
    'fixedPatternDamage',
    'formatInformation',
    'cellContrast',
    'cellModulation',
  ],
});

export class GradesPanel {
  /** @param {ViewTrier} tryViews */
  constructor(tryViews) {
    this.tryViews_ = tryViews;
    this.details_ = byId('grades', HTMLDetailsElement);
    this.content_ = byId('grades-content', HTMLElement);
    /** @type {Report | undefined} */ this.report_ = undefined;
    /** @type {Trials | undefined} */ this.trials_ = undefined;
    /** @type {AbortController | undefined} */ this.trying_ = undefined;
    this.tried_ = 0;
    this.all_ = 0;
    this.details_.addEventListener('toggle', () => this.render_());
    onLanguage(() => this.render_());
  }

  /** @param {Report} report */
  show(report) {
    this.hide();
    this.report_ = report;
    this.render_();
  }

  hide() {
    this.trying_?.abort();
    this.trying_ = undefined;
    this.report_ = undefined;
    this.trials_ = undefined;
  }

  render_() {
    if (!this.report_ || !this.details_.open) return;
    const { verification, projection } = this.report_;
    if (!verification.iso29158 || !verification.iso15415) return; // a text alone
    this.content_.replaceChildren(
      make('p', { className: 'facts', text: text('check.simulated') }),
      ...gradeTable(text('check.iso29158'), verification.iso29158, kParameters.iso29158),
      ...gradeTable(text('check.iso15415'), verification.iso15415, kParameters.iso15415),
      make('h3', { text: text('check.views') }),
      make('p', {
        text: `${text('check.eye', { distance: centimetres(projection.eyeDistanceMm) })}: ${text(this.report_.verification.decoded ? 'check.read' : 'check.unread')}`,
      }),
      ...this.viewTrials_(),
    );
  }

  viewTrials_() {
    if (this.trials_) return [trialList(this.trials_)];
    if (this.trying_) return [make('p', { className: 'trying', text: this.progress_() })];
    const button = make('button', { text: text('check.tryViews') });
    button.type = 'button';
    button.addEventListener('click', () => void this.try_());
    return [button];
  }

  progress_() {
    return text('check.trying', { done: Math.min(this.tried_ + 1, this.all_), all: this.all_ });
  }

  async try_() {
    const report = this.report_;
    if (!report) return;
    const trying = new AbortController();
    this.trying_ = trying;
    this.tried_ = 0;
    this.all_ = 0;
    this.render_();
    const trials = await this.tryViews_(
      report,
      (tried, all) => {
        this.tried_ = tried;
        this.all_ = all;
        const line = this.content_.querySelector('.trying');
        if (line) line.textContent = this.progress_();
      },
      trying.signal,
    );
    if (this.trying_ !== trying) return;
    this.trying_ = undefined;
    this.trials_ = trials;
    this.render_();
  }
}

/** @param {Trials} trials */
function trialList({ tilts, safeTiltDeg: safe, forgiving, pixelsPerModule, distanceMm }) {
  return make(
    'ul',
    { className: 'trials' },
    ...tilts.map(({ tiltDeg, reads, all }) =>
      make('li', { text: `${text('check.tilt', { tilt: tiltDeg })}: ${text('check.tiltReads', { reads, all })}` }),
    ),
    make(
      'li',
      {},
      make('strong', { text: safe > 0 ? text('check.tiltUpTo', { tilt: safe }) : text('check.tiltNone') }),
    ),
    ...(!forgiving ? [make('li', { text: text('check.bends') })] : []),
    make(
      'li',
      {},
      make('strong', {
        text:
          pixelsPerModule === null || distanceMm === null
            ? text('check.distanceNone')
            : text('check.distanceUpTo', { distance: centimetres(distanceMm), pixels: formatPlain(pixelsPerModule) }),
      }),
    ),
  );
}

/** @param {number} mm */
const centimetres = (mm) => `${formatNumber(mm / 10)}\u00a0cm`;

/** @param {string} caption @param {Grades} grades @param {readonly (keyof import('../i18n/catalogue.js').English['page']['check'])[]} parameters */
function gradeTable(caption, grades, parameters) {
  const cells = (/** @type {'th' | 'td'} */ tag, /** @type {string[]} */ ...texts) =>
    texts.map((words) => make(tag, { text: words }));
  const rows = parameters.map((name) =>
    make(
      'tr',
      {},
      ...cells('td', text(`check.${name}`), valueOf(name, grades[name].value), letterOf(grades[name].grade)),
    ),
  );
  return [
    make(
      'table',
      {},
      make('caption', { text: caption }),
      make(
        'thead',
        {},
        make('tr', {}, ...cells('th', text('check.parameter'), text('check.value'), text('check.grade'))),
      ),
      make(
        'tbody',
        {},
        ...rows,
        make('tr', { className: 'overall' }, ...cells('td', text('check.overall'), '', letterOf(grades.overall))),
      ),
    ),
  ];
}

/** @param {string} name @param {number} value */
function valueOf(name, value) {
  if (name === 'decode') return text(value >= 1 ? 'check.yes' : 'check.no');
  return kCounts.includes(name) ? formatNumber(value) : formatPercent(value);
}

/** @param {number} grade  4 (best) … 0 */
const letterOf = (grade) => `${kLetters[Math.floor(grade)]} (${formatPlain(grade, 1)})`;
