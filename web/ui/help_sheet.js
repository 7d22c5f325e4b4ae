// SPDX-License-Identifier: GPL-3.0-or-later
// A dialog that explains keys, mouse and touch.
import { recall, remember } from '../storage/remembered.js';
import { onLanguage, text } from '../i18n/catalogue.js';
import { byId, make } from '../dom/dom.js';
import { kShortcuts, listenForShortcuts } from './shortcuts.js';

/** @typedef {import('../i18n/catalogue.js').Key} Key */

/** @type {[name: Key, keys: Key][]} */
const kInView = [
  ['help.turn', 'help.turnKeys'],
  ['help.move', 'help.moveKeys'],
  ['help.zoom', 'help.zoomKeys'],
  ['help.place', 'help.placeKeys'],
  ['help.turnCode', 'help.turnCodeKeys'],
  ['help.standard', 'help.standardKeys'],
  ['help.before', 'help.beforeKeys'],
];
const kSingleKeys = 'singleKeys';

const isMac = () => /Mac|iPhone|iPad/.test(navigator.platform);

export class HelpSheet {
  constructor() {
    this.sheet_ = byId('help-sheet', HTMLDialogElement);
    this.single_ = byId('single-keys', HTMLInputElement);
    this.single_.checked = recall(kSingleKeys) !== 'off';
    this.single_.addEventListener('change', () => remember(kSingleKeys, this.single_.checked ? 'on' : 'off'));
    byId('help', HTMLButtonElement).addEventListener('click', () => this.sheet_.showModal());
    byId('help-close', HTMLButtonElement).addEventListener('click', () => this.sheet_.close());
    this.sheet_.addEventListener('click', (event) => {
      if (event.target === this.sheet_) this.sheet_.close(); // a click on the backdrop
    });
    listenForShortcuts(() => this.single_.checked);
    onLanguage(() => this.fill_());
    this.fill_();
  }

  fill_() {
    byId('help-keys', HTMLElement).replaceChildren(
      ...kShortcuts
        .filter(({ notOnMac }) => !(notOnMac && isMac()))
        .flatMap((shortcut) => [make('dt', {}, ...keysOf(shortcut)), make('dd', { text: text(shortcut.name) })]),
    );
    byId('help-view', HTMLElement).replaceChildren(
      ...kInView.flatMap(([name, keys]) => [make('dt', { text: text(keys) }), make('dd', { text: text(name) })]),
    );
  }
}

/** @param {import('./shortcuts.js').Shortcut} shortcut */
function keysOf({ key, ctrl, shift }) {
  const name = key === 'escape' ? text('help.key.escape') : key.toUpperCase();
  const names = [
    ...(ctrl ? [isMac() ? '⌘' : text('help.key.ctrl')] : []),
    ...(shift ? [text('help.key.shift')] : []),
    name,
  ];
  return names.flatMap((one, i) => [...(i > 0 ? [' '] : []), make('kbd', { text: one })]);
}
