// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict. One that passes: three lines, each with its reasons and one-click remedies. One that fails: what failed, a
// picture of it and the best remedies, with the three lines behind.
import { text } from '../i18n/catalogue.js';
import { hintOf, sentenceOf } from '../i18n/messages.js';
import { asSentence } from '../i18n/sentences.js';
import { choiceLabel } from '../i18n/setting_names.js';
import { make } from '../dom/dom.js';
import { failurePicture } from './failure_picture.js';
import { remedyButtons } from './messages.js';

/** @typedef {import('../engine/types.js').Aspect} Aspect */
/** @typedef {import('../engine/types.js').Remedy} Remedy */
/** @typedef {(remedy: Remedy, label: string) => void} OnRemedy */
/** @typedef {import('../engine/types.js').Printed} Printed */
/**
 * @typedef {{ onRemedy: OnRemedy, onPrint: (starts: boolean) => void, onTryPrints: () => void,
 *   onExplain: (isOpen: boolean) => void }} Listener  `onPrint`: start or stop the simulation of the print;
 *   `onTryPrints`: try other print settings; `onExplain`: the user opens or closes the lines of a failed verdict
 */
/** @typedef {'reads' | 'prints' | 'solid'} Question */

const kUnlinkedLength = 80;
const kMostRemedies = 3; // more are a list to read, not a choice to make

/** In the order of failedChecks. */
const kQuestions = /** @type {const} */ (['solid', 'reads', 'prints']);

/**
 * @param {import('./result_panel.js').Result} result
 * @param {Listener} listener
 * @param {boolean} isOpen  the lines of a failed verdict are shown
 */
export function verdictLines(result, listener, isOpen) {
  const { verdict } = result.report.verification;
  const failed = kQuestions.find((question) => !verdict[question].passed);
  return failed ? [failure(failed, result, listener, isOpen)] : threeLines(result, listener);
}

/**
 * Returns a function that leaves out the remedies that were offered before: several checks may want the same.
 * @param {readonly Remedy[]} [offered]
 */
export function notOffered(offered = []) {
  const keyOf = (/** @type {Remedy} */ { code, changes }) => JSON.stringify(changes ?? code);
  const known = new Set(offered.map(keyOf));
  return (/** @type {readonly Remedy[]} */ remedies) =>
    remedies.filter((remedy) => !known.has(keyOf(remedy)) && known.add(keyOf(remedy)));
}

/**
 * @param {import('./result_panel.js').Result} result  `printed`: undefined until something is known about the print
 * @param {Listener} listener
 * @param {readonly Remedy[]} [offered]  remedies that stand elsewhere
 */
function threeLines({ report, printed }, listener, offered) {
  const { onRemedy, onPrint } = listener;
  const { reads, prints, solid } = report.verification.verdict;
  const others = notOffered(offered);
  const left = (/** @type {Question} */ question) => {
    const aspect = report.verification.verdict[question];
    return { ...aspect, remedies: others(aspect.remedies) };
  };
  return [
    line(left('reads'), readsHeading(report.text, reads), onRemedy),
    isUnderWay(printed)
      ? printingLine(printed, onPrint)
      : line(left('prints'), [sentenceOf(prints.summary)], onRemedy, printNotes(printed, prints, listener)),
    line(left('solid'), [sentenceOf(solid.summary)], onRemedy),
  ];
}

/**
 * Says in one sentence what failed, with a picture of it and the best remedies. The rest is behind.
 * @param {Question} failed
 * @param {import('./result_panel.js').Result} result
 * @param {Listener} listener
 * @param {boolean} isOpen
 */
function failure(failed, result, listener, isOpen) {
  const { verdict, failedChecks } = result.report.verification;
  const { level } = verdict[failed];
  const best = verdict[failed].remedies.slice(0, kMostRemedies);
  const [check] = failedChecks;
  const hint = hintOf(check);
  const lines = make('ul', { className: 'verdict' }, ...threeLines(result, listener, best));
  lines.setAttribute('aria-label', text('check.inDetail'));
  const rest = make(
    'details',
    {},
    make('summary', { text: text('check.whyAndHelp') }),
    ...(hint ? [make('p', { text: asSentence(hint) })] : []),
    lines,
  );
  rest.open = isOpen;
  rest.addEventListener('toggle', () => listener.onExplain(rest.open));
  return make(
    'li',
    { className: `${level} failure` },
    make('strong', { text: asSentence(sentenceOf(check)) }),
    ...failurePicture(failed, result),
    ...remedyButtons(remediesOf(best, listener.onRemedy)),
    rest,
  );
}

/** @param {Remedy[]} remedies @param {OnRemedy} onRemedy */
const remediesOf = (remedies, onRemedy) =>
  remedies.map((remedy) => {
    const label = sentenceOf(remedy);
    return { label, run: () => onRemedy(remedy, label) };
  });

/** @param {Printed | undefined} printed @returns {printed is Printed & { state: 'under-way' } | undefined} */
export const isUnderWay = (printed) => printed === undefined || printed.state === 'under-way';

/** @param {Printed & { state: 'under-way' } | undefined} printed */
export const printingWords = (printed) =>
  text('check.printing', { percent: Math.round(100 * (printed?.fraction ?? 0)) });

/** @param {Printed & { state: 'under-way' } | undefined} printed @param {Listener['onPrint']} onPrint */
const printingLine = (printed, onPrint) =>
  make(
    'li',
    { className: 'under-way' },
    make('strong', { className: 'printing', text: printingWords(printed) }),
    make('p', { text: text('check.printingWhy') }),
    ...remedyButtons([{ label: text('check.stopPrint'), run: () => onPrint(false) }]),
  );

/**
 * Returns the actions available for the print.
 * @param {Printed} printed
 * @param {Aspect} prints
 * @param {Listener} listener
 * @returns {Node[]}
 */
function printNotes(printed, prints, listener) {
  const { onPrint } = listener;
  if (printed.state === 'made')
    return prints.level === 'good' && !printed.trials ? [] : trialNotes(printed.trials, listener);
  if (printed.state !== 'stopped' && printed.state !== 'failed') return [];
  return [
    make('p', {
      text: printed.state === 'failed' ? failureWords(printed.error) : asSentence(text('check.printStopped')),
    }),
    ...remedyButtons([{ label: text('check.makePrint'), run: () => onPrint(true) }]),
  ];
}

/** @param {import('../engine/types.js').EngineError} error */
const failureWords = (error) => [text('check.printFailed'), sentenceOf(error)].map(asSentence).join(' ');

/** @param {import('../engine/types.js').PrintTrials} trials */
export const tryingWords = ({ tried, all, fraction = 0 }) =>
  text('check.tryingPrints', { number: Math.min(tried.length + 1, all), all, percent: Math.round(100 * fraction) });

/**
 * Shows the trials of other print settings: the offer, the progress and the outcomes.
 * @param {import('../engine/types.js').PrintTrials | undefined} trials
 * @param {Listener} listener
 * @returns {Node[]}
 */
function trialNotes(trials, { onRemedy, onPrint, onTryPrints }) {
  if (!trials) return remedyButtons([{ label: text('check.tryPrints'), run: onTryPrints }]);
  const { tried, fraction, error } = trials;
  const results = make(
    'ul',
    { className: 'print-trials' },
    ...tried.map(({ change, prints }) =>
      make(
        'li',
        { className: prints.level },
        make('span', { text: asSentence(sentenceOf(prints.summary)) }),
        ...remedyButtons([remedyOf(change, onRemedy)]),
      ),
    ),
  );
  if (fraction === undefined)
    return [
      results,
      make('p', { text: text('check.triedSame') }),
      ...(error ? [make('p', { text: failureWords(error) })] : []),
    ];
  return [
    results,
    make('p', { className: 'trying-prints', text: tryingWords(trials) }),
    ...remedyButtons([{ label: text('check.stopPrint'), run: () => onPrint(false) }]),
  ];
}

/** @param {import('../engine/types.js').PrintChange} change @param {OnRemedy} onRemedy */
function remedyOf(change, onRemedy) {
  const [[setting, value]] = Object.entries(change);
  const label = text('check.takePrint', {
    choice: choiceLabel(/** @type {import('../generated/settings.js').SettingKey} */ (setting), value),
  });
  return { label, run: () => onRemedy({ code: '', values: {}, changes: [{ setting, value }] }, label) };
}

/** @param {Aspect} aspect @param {(Node | string)[]} heading @param {OnRemedy} onRemedy @param {Node[]} [notes] */
const line = ({ level, warnings, reasons, remedies }, heading, onRemedy, notes = []) =>
  make(
    'li',
    { className: level },
    make('strong', {}, ...heading),
    ...warnings.map((warning) => make('p', { className: 'warning', text: wordsOf([warning]) })),
    make('p', { text: wordsOf(reasons) }),
    ...remedyButtons(remediesOf(remedies, onRemedy)),
    ...notes,
  );

/** @param {import('../engine/types.js').Message[]} messages */
const wordsOf = (messages) =>
  messages
    .flatMap((one) => [sentenceOf(one), hintOf(one)])
    .filter(Boolean)
    .map(asSentence)
    .join(' ');

/** Returns the summary, with the decoded text as a link if it is one. @param {string} expected @param {Aspect} aspect */
function readsHeading(expected, { summary }) {
  const { text: said } = summary.values;
  if (!said || !('term' in said) || said.term !== expected) return [sentenceOf(summary)];
  const link = /^https?:\/\/\S+$/.test(expected) && expected.length <= kUnlinkedLength;
  const words = link ? make('a', { text: expected }) : make('q', { text: expected });
  if (words instanceof HTMLAnchorElement)
    Object.assign(words, { href: expected, target: '_blank', rel: 'noopener noreferrer' });
  const kHere = '\u0000';
  const [before, after = ''] = sentenceOf({ ...summary, values: { text: { term: kHere } } }).split(kHere);
  return [before, words, after];
}
