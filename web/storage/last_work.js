// SPDX-License-Identifier: GPL-3.0-or-later
// Stores the current work, to offer it on the next visit: the model's file, unit and up axis, the code's text or the
// list of texts, the settings and the centre. A sample is stored by name, a file only up to kMaxBytes.

/** @typedef {import('../engine/types.js').UpAxis} UpAxis */
/** @typedef {[number, number, number]} Point */

/**
 * The source of a batch's parts; `text`, `name`: templates of their texts and file names ('' to use the list's
 * columns).
 * @typedef {{ from: 'list' | 'count', list: Uint8Array, listName: string, count: number, text: string, name: string, perPlate: number, id: string, names: '' | 'yes' | 'no' }} BatchInput
 *   `listName` '': the list was pasted; `perPlate` 0: one file per part; `id`: the chosen column of the ids, or '';
 *   `names`: whether the first row names the columns, '' if the user has not said so
 */

/**
 * @typedef {object} Work
 * @property {string} fileName
 * @property {string} [sampleId]   of a sample, whose file comes with the page
 * @property {Uint8Array} [bytes]  of the user's file
 * @property {number} scaleToMm
 * @property {UpAxis} upAxis
 * @property {string} [text]       left out if it holds a password
 * @property {string} [address]    query of the page's address, which may ask for a sample, a text or settings
 * @property {import('../settings/work_settings.js').WorkSettings} settings
 * @property {Point} [centreMm]
 * @property {BatchInput} [batch]  absent for a single code; left out if it holds a password
 */

/** @typedef {{ get: (key: string) => Promise<any>, put: (values: Record<string, any>) => Promise<boolean> }} Store */

export const kMaxBytes = 256 * 1024 * 1024;
const kPauseMs = 800; // between the last change and storing
const kFormat = 1; // version of the stored data; other versions are not offered
const kState = 'last work';
const kModel = 'last model';

/** Summarises the work without the bytes of its files. @param {Work} work */
const brief = (work) =>
  JSON.stringify({
    ...work,
    bytes: work.bytes?.length,
    batch: work.batch && { ...work.batch, list: work.batch.list.length },
  });

/** Returns all strings of a batch that may be the text of a code or its beginning. @param {BatchInput} batch */
const textsOf = ({ text, list }) => [text, ...new TextDecoder().decode(list).split(/[\n",;\t]+(?=\s*WIFI:)|\n/i)];

export class LastWork {
  /**
   * @param {Store} store
   * @param {(text: string) => boolean} holdsSecret  true: do not store this text
   */
  constructor(store, holdsSecret) {
    this.store_ = store;
    this.holdsSecret_ = holdsSecret;
    /** @type {string | undefined} */ this.seen_ = undefined; // summary of the last known work
    /** @type {Uint8Array | undefined} */ this.seenBytes_ = undefined;
    /** @type {Uint8Array | undefined} */ this.seenList_ = undefined;
    /** @type {Uint8Array | undefined} */ this.keptBytes_ = undefined; // the stored file's
    /** @type {Work | undefined} */ this.next_ = undefined;
    /** @type {ReturnType<typeof setTimeout> | undefined} */ this.pause_ = undefined;
    /** @type {Promise<void>} */ this.writing_ = Promise.resolve();
    this.modelId_ = 0;
    this.replaced_ = false; // true: the last visit's work is overwritten
  }

  /** Notes the work with which the page opened. It is not stored unless it changes. @param {Work} [work] */
  openedWith(work) {
    this.seen_ = work && brief(work);
    this.seenBytes_ = work?.bytes;
    this.seenList_ = work?.batch?.list;
  }

  /** Stores the work if it has changed, kPauseMs after the last change. @param {Work} work */
  save(work) {
    const now = brief(work);
    if (now === this.seen_ && work.bytes === this.seenBytes_ && work.batch?.list === this.seenList_) return;
    this.seen_ = now;
    this.seenBytes_ = work.bytes;
    this.seenList_ = work.batch?.list;
    this.next_ = work;
    clearTimeout(this.pause_);
    this.pause_ = setTimeout(() => void this.flush(), kPauseMs);
  }

  /** Stores the work to be saved immediately. */
  flush() {
    clearTimeout(this.pause_);
    const work = this.next_;
    this.next_ = undefined;
    if (work) this.writing_ = this.writing_.then(() => this.write_(work));
    return this.writing_;
  }

  /** @param {Work} work */
  async write_({ bytes, text, batch, ...rest }) {
    if (bytes && bytes.length > kMaxBytes) {
      await this.forget(); // otherwise the previous work would be offered
      return;
    }
    const changed = bytes !== this.keptBytes_;
    if (changed) this.modelId_ = Date.now();
    const state = {
      ...rest,
      format: kFormat,
      ...(bytes && { modelId: this.modelId_ }),
      ...(text !== undefined && !this.holdsSecret_(text) && { text }),
      ...(batch && !textsOf(batch).some(this.holdsSecret_) && { batch }),
    };
    const model = bytes && { id: this.modelId_, bytes };
    this.replaced_ = true;
    if (await this.store_.put({ [kState]: state, ...(changed && { [kModel]: model }) })) this.keptBytes_ = bytes;
    else await this.forget();
  }

  /** Returns the last visit's work. @returns {Promise<Work | undefined>} */
  async recall() {
    const state = await this.store_.get(kState);
    if (state?.format !== kFormat) return undefined;
    const { format: _, modelId, ...work } = state;
    if (work.sampleId !== undefined) return work;
    const model = await this.store_.get(kModel);
    return model && model.id === modelId ? { ...work, bytes: model.bytes } : undefined;
  }

  /** Discards the last visit's work, unless this visit has replaced it. */
  async discard() {
    if (!this.replaced_ && !this.next_) await this.forget();
  }

  /** Removes the stored work. The next change is stored again. */
  async forget() {
    this.keptBytes_ = undefined;
    await this.store_.put({ [kState]: undefined, [kModel]: undefined });
  }
}
