// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps what is being worked on, to offer it when the page is opened again: the model's file, unit and up axis, the code's
// text or the list of texts, the settings, and the centre. Of a sample only its name is kept, of a file up to kMaxBytes.

/** @typedef {import('../engine/types.js').UpAxis} UpAxis */
/** @typedef {Record<string, string | boolean>} Values  what the controls hold, by their ids */
/** @typedef {[number, number, number]} Point */

/**
 * Where the parts of a batch come from, and what makes their texts and file names ('' where the list's columns do).
 * @typedef {{ from: 'list' | 'count', list: Uint8Array, listName: string, count: number, text: string, name: string, perPlate: number }} BatchInput
 *   `listName` '': it was pasted; `perPlate` 0: each part has a file of its own
 */

/**
 * @typedef {object} Work
 * @property {string} fileName
 * @property {string} [sampleId]   of a sample; its file comes with the page
 * @property {Uint8Array} [bytes]  of a file of the user's
 * @property {number} scaleToMm
 * @property {UpAxis} upAxis
 * @property {string} [text]       left out where it holds a password
 * @property {Values} values       of the settings
 * @property {Point} [centreMm]
 * @property {BatchInput} [batch]  none: one code; left out, too, where it holds a password
 */

/** @typedef {{ get: (key: string) => Promise<any>, put: (values: Record<string, any>) => Promise<boolean> }} Store */

export const kMaxBytes = 256 * 1024 * 1024;
const kPauseMs = 800;   // after the last change
const kFormat = 1;      // of what is kept; another one is not offered
const kState = 'last work';
const kModel = 'last model';

/** Everything but the bytes of files. @param {Work} work */
const brief = (work) => JSON.stringify({ ...work, bytes: work.bytes?.length, batch: work.batch && { ...work.batch, list: work.batch.list.length } });

/** What may be a text of a code, or the beginning of one. @param {BatchInput} batch */
const textsOf = ({ text, list }) => [text, ...new TextDecoder().decode(list).split(/[\n",;\t]+(?=\s*WIFI:)|\n/i)];

export class LastWork {
  /**
   * @param {Store} store
   * @param {(text: string) => boolean} holdsSecret  such a text is not kept
   */
  constructor(store, holdsSecret) {
    this.store_ = store;
    this.holdsSecret_ = holdsSecret;
    /** @type {string | undefined} */ this.seen_ = undefined;        // the work as it was last, in short
    /** @type {Uint8Array | undefined} */ this.seenBytes_ = undefined;
    /** @type {Uint8Array | undefined} */ this.seenList_ = undefined;
    /** @type {Uint8Array | undefined} */ this.keptBytes_ = undefined;  // of the file that is stored
    /** @type {Work | undefined} */ this.next_ = undefined;
    /** @type {ReturnType<typeof setTimeout> | undefined} */ this.pause_ = undefined;
    /** @type {Promise<void>} */ this.writing_ = Promise.resolve();
    this.modelId_ = 0;
    this.replaced_ = false;  // what the last visit left
  }

  /** What the page opened with is not worth keeping, as long as it stays so. @param {Work} [work] */
  openedWith(work) {
    this.seen_ = work && brief(work);
    this.seenBytes_ = work?.bytes;
    this.seenList_ = work?.batch?.list;
  }

  /** What is there now. It is kept when something has changed, a moment after the last change. @param {Work} work */
  note(work) {
    const now = brief(work);
    if (now === this.seen_ && work.bytes === this.seenBytes_ && work.batch?.list === this.seenList_) return;
    this.seen_ = now;
    this.seenBytes_ = work.bytes;
    this.seenList_ = work.batch?.list;
    this.next_ = work;
    clearTimeout(this.pause_);
    this.pause_ = setTimeout(() => void this.flush(), kPauseMs);
  }

  /** Writes at once what was noted. */
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
      await this.forget();  // else the one before it would be offered
      return;
    }
    const changed = bytes !== this.keptBytes_;
    if (changed) this.modelId_ = Date.now();
    const state = {
      ...rest, format: kFormat, ...(bytes && { modelId: this.modelId_ }),
      ...(text !== undefined && !this.holdsSecret_(text) && { text }),
      ...(batch && !textsOf(batch).some(this.holdsSecret_) && { batch }),
    };
    const model = bytes && { id: this.modelId_, bytes };
    this.replaced_ = true;
    if (await this.store_.put({ [kState]: state, ...(changed && { [kModel]: model }) })) this.keptBytes_ = bytes;
    else await this.forget();
  }

  /** What was worked on when the page was open last. @returns {Promise<Work | undefined>} */
  async recall() {
    const state = await this.store_.get(kState);
    if (state?.format !== kFormat) return undefined;
    const { format: _, modelId, ...work } = state;
    if (work.sampleId !== undefined) return work;
    const model = await this.store_.get(kModel);
    return model && model.id === modelId ? { ...work, bytes: model.bytes } : undefined;
  }

  /** The last visit's work is not wanted; what this visit has put in its place stays. */
  async discard() {
    if (!this.replaced_ && !this.next_) await this.forget();
  }

  /** Keeps nothing, until something changes. */
  async forget() {
    this.keptBytes_ = undefined;
    await this.store_.put({ [kState]: undefined, [kModel]: undefined });
  }
}
