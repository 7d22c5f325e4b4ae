// SPDX-License-Identifier: GPL-3.0-or-later
// The buttons over the 3D view: viewing directions, and the parts of the model to show.
import { setDisabled } from '../dom/set_disabled.js';
import { byId } from '../dom/dom.js';
import { recall, remember } from '../storage/remembered.js';

/** @typedef {import('../engine/types.js').StandardView} StandardView */

/**
 * @typedef {object} ToolbarListener
 * @property {(carved: boolean) => void} onCarved
 * @property {(before: boolean) => void} onBefore  show the model before carving while the button is held
 * @property {() => void} onReaderView
 * @property {() => void} onFit
 * @property {(name: StandardView) => void} onStandard
 * @property {(shown: boolean, offset: number) => void} onSection  offset from the code's middle, -1 … 1
 * @property {() => void} onFaceSection  turn to face the section
 * @property {(shown: boolean) => void} onDepths
 * @property {(shown: boolean) => void} onPlate
 * @property {(shown: boolean) => void} onConstruction
 * @property {(shown: boolean) => void} onLampLight
 * @property {() => void} onLive  `liveShown` has changed
 * @property {(shown: boolean) => void} onInspector
 */

const kPlateName = 'buildPlate', // of the remembered choices
  kLiveName = 'asCarved',
  kLampLightName = 'lampLight';

export class ViewToolbar {
  constructor() {
    /** @type {ToolbarListener | undefined} */ this.listener_ = undefined;
    this.carved_ = byId('show-carved', HTMLButtonElement);
    this.before_ = byId('show-before', HTMLButtonElement);
    this.section_ = byId('show-section', HTMLButtonElement);
    this.position_ = byId('section-position', HTMLInputElement);
    this.depths_ = byId('show-depths', HTMLButtonElement);
    this.reader_ = byId('reader-view', HTMLButtonElement);
    this.plate_ = byId('show-plate', HTMLButtonElement);
    this.plate_.setAttribute('aria-pressed', String(recall(kPlateName) !== 'off'));
    this.live_ = byId('show-live', HTMLButtonElement);
    this.live_.setAttribute('aria-pressed', String(recall(kLiveName) !== 'off'));
    this.lampLight_ = byId('show-lamp-light', HTMLButtonElement);
    this.lampLight_.setAttribute('aria-pressed', String(recall(kLampLightName) !== 'off'));
    this.construction_ = byId('show-construction', HTMLButtonElement);
    this.inspector_ = byId('inspector', HTMLButtonElement);
    this.hint_ = byId('view-hint', HTMLElement);
    this.views_ = byId('views', HTMLButtonElement);
    this.menu_ = byId('views-menu', HTMLElement);
    this.carvedShown_ = false;
    this.carved_.addEventListener('click', () => this.listener_?.onCarved(!isPressed(this.carved_)));
    this.depths_.addEventListener('click', () => this.listener_?.onDepths(toggle(this.depths_)));
    this.plate_.addEventListener('click', () => {
      remember(kPlateName, toggle(this.plate_) ? 'on' : 'off');
      this.listener_?.onPlate(this.plateShown);
    });
    this.live_.addEventListener('click', () => {
      remember(kLiveName, toggle(this.live_) ? 'on' : 'off');
      this.listener_?.onLive();
    });
    this.lampLight_.addEventListener('click', () => {
      remember(kLampLightName, toggle(this.lampLight_) ? 'on' : 'off');
      this.listener_?.onLampLight(this.lampLightShown);
    });
    this.construction_.addEventListener('click', () => this.listener_?.onConstruction(toggle(this.construction_)));
    this.inspector_.addEventListener('click', () => this.listener_?.onInspector(toggle(this.inspector_)));
    this.reader_.addEventListener('click', () => this.listener_?.onReaderView());
    byId('fit', HTMLButtonElement).addEventListener('click', () => this.listener_?.onFit());
    this.section_.addEventListener('click', () => this.showSection(!isPressed(this.section_)));
    this.position_.addEventListener('input', () => this.listener_?.onSection(true, this.position_.valueAsNumber));
    this.followMenu_();
    this.followBefore_();
    this.setCarved(false, false, false);
    this.setPlaced(false, true);
  }

  /** @param {ToolbarListener} listener */
  listen(listener) {
    this.listener_ = listener;
  }

  followMenu_() {
    const open = (/** @type {boolean} */ isOpen) => {
      this.menu_.hidden = !isOpen;
      this.views_.setAttribute('aria-expanded', String(isOpen));
    };
    this.views_.addEventListener('click', () => open(this.menu_.hidden === true));
    this.menu_.addEventListener('click', (event) => {
      const button = event.target instanceof Element ? event.target.closest('button') : null;
      if (!button) return;
      open(false);
      this.views_.focus();
      this.listener_?.onStandard(/** @type {StandardView} */ (button.dataset.view));
    });
    for (const element of [this.menu_, this.views_]) {
      element.addEventListener('keydown', (event) => {
        if (event.key !== 'Escape' || this.menu_.hidden) return;
        event.stopPropagation();
        open(false);
        this.views_.focus();
      });
    }
    document.addEventListener('pointerdown', (event) => {
      const inside =
        event.target instanceof Node && (this.menu_.contains(event.target) || this.views_.contains(event.target));
      if (!inside) open(false);
    });
  }

  /** Shows the model before carving while the pointer, Space or Enter holds the button, or B is held over the view. */
  followBefore_() {
    const { before_: button } = this;
    const isKey = (/** @type {KeyboardEvent} */ event) => event.key === ' ' || event.key === 'Enter';
    button.addEventListener('pointerdown', (event) => {
      button.setPointerCapture(event.pointerId);
      this.hold(true);
    });
    for (const type of ['pointerup', 'pointercancel', 'blur']) button.addEventListener(type, () => this.hold(false));
    button.addEventListener('keydown', (event) => {
      if (isKey(event)) this.hold(true);
    });
    button.addEventListener('keyup', (event) => {
      if (isKey(event)) this.hold(false);
    });
    button.addEventListener('contextmenu', (event) => event.preventDefault()); // the menu of a long press
  }

  /** @param {boolean} held */
  hold(held) {
    if (this.before_.disabled || held === isPressed(this.before_)) return;
    this.before_.setAttribute('aria-pressed', String(held));
    this.listener_?.onBefore(held);
  }

  /** @param {boolean} isShown */
  showSection(isShown) {
    if (this.section_.disabled && isShown) return;
    this.section_.setAttribute('aria-pressed', String(isShown));
    byId('section-bar', HTMLElement).hidden = !isShown;
    if (isShown) this.position_.valueAsNumber = 0;
    this.listener_?.onSection(isShown, 0);
    if (isShown) this.listener_?.onFaceSection();
  }

  /**
   * @param {boolean} exists    whether there is a carved model
   * @param {boolean} isShown
   * @param {boolean} isRelief  whether it has depths to show
   */
  setCarved(exists, isShown, isRelief) {
    setDisabled(this.carved_, exists ? undefined : 'page.whyNotEngraved');
    this.carved_.setAttribute('aria-pressed', String(isShown));
    setDisabled(this.before_, isShown ? undefined : exists ? 'page.whyNotShown' : 'page.whyNotEngraved');
    setDisabled(this.depths_, !exists ? 'page.whyNotEngraved' : isRelief ? undefined : 'page.whyNoDepths');
    if (this.depths_.disabled) this.depths_.setAttribute('aria-pressed', 'false');
    this.live_.hidden = isShown; // it is carved
  }

  /**
   * @param {boolean} placed    whether a code or a text is placed
   * @param {boolean} forPhone  whether a phone reads it
   * @param {boolean} [mayPlace]  the model takes a code
   */
  setPlaced(placed, forPhone, mayPlace = false) {
    const why = placed ? undefined : 'page.whyNoPlace';
    setDisabled(this.reader_, why ?? (forPhone ? undefined : 'page.whyForPeople'));
    setDisabled(this.section_, why);
    setDisabled(this.construction_, why);
    this.hint_.hidden = placed || !mayPlace;
    if (!placed && isPressed(this.section_)) this.showSection(false);
  }

  get depthsShown() {
    return isPressed(this.depths_);
  }

  /** The build plate is shown, unless the user hid it at this visit or the last one. */
  get plateShown() {
    return isPressed(this.plate_);
  }

  /** Placed codes are shown as they will be carved, unless the user chose otherwise at this visit or the last one. */
  get liveShown() {
    return isPressed(this.live_);
  }

  /** @param {boolean} exist  whether there are lamps round a placed code */
  setLamps(exist) {
    this.lampLight_.hidden = !exist;
  }

  /** The model is shown in the light of its lamps, unless the user chose otherwise at this visit or the last one. */
  get lampLightShown() {
    return isPressed(this.lampLight_);
  }

  /** It stays pressed while no code is placed. */
  get constructionShown() {
    return isPressed(this.construction_);
  }

  /** Resets the button after the inspector could not be opened. */
  releaseInspector() {
    this.inspector_.setAttribute('aria-pressed', 'false');
  }

  get inspectorShown() {
    return isPressed(this.inspector_);
  }
}

/** @param {HTMLButtonElement} button */
const isPressed = (button) => button.getAttribute('aria-pressed') === 'true';

/** @param {HTMLButtonElement} button @returns {boolean} the new state */
function toggle(button) {
  button.setAttribute('aria-pressed', String(!isPressed(button)));
  return isPressed(button);
}
