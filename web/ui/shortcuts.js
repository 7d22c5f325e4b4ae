// SPDX-License-Identifier: GPL-3.0-or-later
// Keys that work a control of the page. They do nothing while the user is typing or a dialog is open.

/**
 * @typedef {object} Shortcut
 * @property {string} key          KeyboardEvent.key, in lower case
 * @property {boolean} [ctrl]      together with Ctrl, or ⌘ on a Mac
 * @property {boolean} [notOnMac]  there the browser uses it
 * @property {boolean} [shift]     together with Shift; checked for letters only
 * @property {string} control      id of the control: a text field is focused, anything else is clicked
 * @property {import('../i18n/catalogue.js').Key} name
 */

/** @type {readonly Shortcut[]} */
export const kShortcuts = [
  { key: '?', control: 'help', name: 'help.openHelp' },
  { key: 'z', ctrl: true, control: 'undo', name: 'help.undo' },
  { key: 'z', ctrl: true, shift: true, control: 'redo', name: 'help.redo' },
  { key: 'y', ctrl: true, notOnMac: true, control: 'redo', name: 'help.redo' },
  { key: 'o', control: 'file', name: 'help.openFile' },
  { key: 't', control: 'text', name: 'help.editText' },
  { key: 's', control: 'suggest', name: 'help.suggest' },
  { key: 'e', control: 'engrave', name: 'help.engrave' },
  { key: 'escape', control: 'cancel', name: 'help.cancel' },
  { key: 'd', control: 'download', name: 'help.download' },
  { key: 'c', control: 'show-carved', name: 'help.carved' },
  { key: 'f', control: 'fit', name: 'help.fit' },
  { key: 'p', control: 'show-plate', name: 'help.plate' },
  { key: 'r', control: 'reader-view', name: 'help.reader' },
];

const kTypedInto = ['text', 'number', 'search', 'url', 'email', 'tel', 'password', 'date', 'time', 'datetime-local'];

/** Tells whether a key pressed on this element is text input. @param {EventTarget | null} target */
function isTyping(target) {
  if (target instanceof HTMLInputElement) return kTypedInto.includes(target.type);
  return target instanceof HTMLTextAreaElement || (target instanceof HTMLElement && target.isContentEditable);
}

/**
 * @param {Pick<KeyboardEvent, 'key' | 'ctrlKey' | 'metaKey' | 'altKey' | 'shiftKey'>} event
 * @returns {Shortcut | undefined}
 */
export function shortcutOf({ key, ctrlKey, metaKey, altKey, shiftKey }) {
  if (altKey) return undefined;
  const pressed = key.toLowerCase();
  const ctrl = ctrlKey || metaKey;
  const isLetter = /^[a-z]$/.test(pressed);
  return kShortcuts.find(
    (one) =>
      one.key === pressed &&
      (one.ctrl ?? false) === ctrl &&
      !(one.notOnMac && metaKey) &&
      (!isLetter || (one.shift ?? false) === shiftKey),
  );
}

/** @param {() => boolean} singleKeys  tells whether keys without Ctrl are enabled */
export function listenForShortcuts(singleKeys) {
  document.addEventListener('keydown', (event) => {
    if (event.defaultPrevented || isTyping(event.target) || document.querySelector('dialog[open]')) return;
    const shortcut = shortcutOf(event);
    if (!shortcut || shortcut.control === 'cancel') return; // WorkPanel handles Escape, which also works while typing
    if (!shortcut.ctrl && (!singleKeys() || event.target instanceof HTMLSelectElement || event.repeat)) return;
    if (shortcut.ctrl) event.preventDefault(); // otherwise the browser would undo in a field of its choice
    const control = document.getElementById(shortcut.control);
    if (!control || (control instanceof HTMLButtonElement && control.disabled) || !control.checkVisibility()) return;
    event.preventDefault();
    if (control instanceof HTMLTextAreaElement) control.focus();
    else control.click();
  });
}
