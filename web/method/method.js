// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the page's pictures: the app's own engine carves one sample and shows every step.
import { EngineClient } from '../engine/client.js';
import { describeThrown } from '../engine/engine_error.js';
import { openArticle } from '../guide/article.js';
import { kReaderName, readEach } from '../decoder/reader.js';
import { fetchBytes, fetchJson } from '../session/fetch_file.js';
import { currentLanguage, startTexts, text } from '../i18n/catalogue.js';
import { write } from '../i18n/live.js';
import { hintOf, sentenceOf } from '../i18n/messages.js';
import { byId, make } from '../dom/dom.js';
import { View } from '../view/view.js';
import { paintDepths, paintHeights, paintLight, paintNormals } from '../view/map_colours.js';

/** @typedef {import('../i18n/live.js').Words} Words */

const kText = 'https://en.wikipedia.org/wiki/QR_code';

/** Settings of the demonstration. @type {import('../engine/types.js').Settings} */
const kSettings = {
  text: kText,
  preset: 'balanced',
  pattern: 'thick-plus',
  finderPattern: 'thick-plus-sharp',
  size: 'free',
  maxSizeMm: 40,
  quietZone: true,
  direction: 'depth-balanced',
  rotateDeg: 0,
  minWallMm: 0.8,
  nozzleMm: 0.4,
  layerMm: 0.1,
  eyeDistanceMm: 250,
};

/** @param {Words} words */
const say = (words) => write(byId('status', HTMLElement), words);

/** @param {string} id @param {import('../view/map_colours.js').Pixels} pixels */
function show(id, { width, height, rgba }) {
  const canvas = byId(id, HTMLCanvasElement);
  [canvas.width, canvas.height] = [width, height];
  canvas.getContext('2d')?.putImageData(new ImageData(rgba, width, height), 0, 0);
}

/** @param {number} mm @param {number} digits */
const inMm = (mm, digits) => {
  const number = mm.toLocaleString(currentLanguage(), { minimumFractionDigits: digits, maximumFractionDigits: digits });
  return `${number.replace('-', '−')}\u00a0mm`;
};

/** @param {string} id @param {{ from: number, to: number }} range */
function showScale(id, { from, to }) {
  write(byId(`${id}-from`, HTMLElement), () => inMm(from, 2));
  write(byId(`${id}-to`, HTMLElement), () => inMm(to, 2));
}

/** @param {string} id @param {[name: Words, value: Words][]} rows */
function showNumbers(id, rows) {
  byId(id, HTMLElement).replaceChildren(
    ...rows.flatMap((row) =>
      ['dt', 'dd'].map((tag, at) => {
        const cell = make(/** @type {'dt' | 'dd'} */ (tag));
        write(cell, row[at]);
        return cell;
      }),
    ),
  );
}

class Demonstration {
  constructor() {
    this.theme_ = openArticle((dark) => void this.client_.show({ dark }));
    this.view_ = new View(byId('live', HTMLElement));
    this.view_.listen({
      onAct: (action) => void this.client_.act(action).catch(() => {}),
      onPick: () => {},
      onResize: (size) => void this.client_.resize(size).catch(() => {}),
    });
    this.client_ = new EngineClient({
      makeCanvas: () => this.view_.makeCanvas(),
      onEvent: (event) => {
        if (event.event === 'failure') this.fail_(event.error);
      },
      onReplaced: () => {},
    });
    this.carved_ = byId('carved', HTMLButtonElement);
    this.carved_.addEventListener(
      'click',
      () => void this.showCarved_(this.carved_.getAttribute('aria-pressed') !== 'true'),
    );
    byId('from-reader', HTMLButtonElement).addEventListener(
      'click',
      () => void this.client_.act({ kind: 'readerView' }),
    );
    byId('beside', HTMLButtonElement).addEventListener('click', () => void this.lookFromAside_());
  }

  async run() {
    try {
      say(() => text('method.working', { stage: text('method.starting') }));
      const begun = performance.now();
      const before = await this.place_();
      const step = await this.client_.engrave({
        signal: new AbortController().signal,
        onProgress: ({ stage }) => say(() => text('method.working', { stage: sentenceOf(stage) })),
      });
      await this.showMaps_();
      await this.showCarved_(true);
      for (const id of ['from-reader', 'beside', 'carved']) byId(id, HTMLButtonElement).disabled = false;
      this.showReport_(await this.client_.report(), before);
      await this.read_(step?.pictures ?? []);
      const seconds = Math.round((performance.now() - begun) / 100) / 10;
      say(() => text('method.ready', { seconds }));
    } catch (thrown) {
      this.fail_(describeThrown(thrown));
    }
  }

  /** @param {import('../engine/types.js').EngineError} error */
  fail_(error) {
    say(() => text('method.failed', { reason: [sentenceOf(error), hintOf(error)].filter(Boolean).join('. ') }));
  }

  /** @returns {Promise<number>}  the model's triangle count */
  async place_() {
    const [, [sample]] = await Promise.all([this.client_.start(), fetchJson('samples/manifest.json')]);
    this.view_.announceSize();
    await this.client_.show({ dark: this.theme_.dark });
    const { triangles } = await this.client_.loadModel(await fetchBytes(`samples/${sample.file}`), sample.file, 1);
    await this.client_.setCentre({ mm: sample.centreMm });
    await this.client_.configure(kSettings);
    const { largestMm, symbolMm, moduleMm, modules } = await this.client_.placement();
    await this.client_.act({ kind: 'face' });
    showNumbers('size-numbers', [
      [() => text('method.guaranteed'), () => inMm(largestMm, 1)],
      [() => text('method.chosen'), () => `${inMm(symbolMm, 1)}, ${modules} × ${modules}`],
      [() => text('method.module'), () => inMm(moduleMm, 2)],
    ]);
    return triangles;
  }

  async showMaps_() {
    const [surface, luminance, depths] = await Promise.all(
      /** @type {const} */ (['surface', 'luminance', 'depths']).map((name) => this.client_.jobMap(name)),
    );
    if (surface) {
      show('normals', paintNormals(surface));
      const heights = paintHeights(surface);
      show('heights', heights);
      showScale('heights', heights);
    }
    if (luminance) show('light', paintLight(luminance));
    if (depths) {
      const painted = paintDepths(depths);
      show('depths', painted);
      showScale('depths', painted);
    }
  }

  /** @param {import('../engine/types.js').Report} report @param {number} trianglesBefore */
  showReport_({ depth, mesh, verification }, trianglesBefore) {
    const count = (/** @type {number} */ value) => () => value.toLocaleString(currentLanguage());
    const isSolid = verification.verdict.solid.passed;
    showNumbers('depth-numbers', [
      [() => text('method.passes'), count(depth.iterations)],
      [() => text('method.meanDepth'), () => inMm(depth.meanMm, 2)],
      [() => text('method.maxDepth'), () => inMm(depth.maxMm, 2)],
    ]);
    showNumbers('mesh-numbers', [
      [() => text('method.trianglesBefore'), count(trianglesBefore)],
      [() => text('method.trianglesAfter'), count(mesh.triangles)],
      [() => text('method.solid'), () => text(isSolid ? 'method.isSolid' : 'method.isNotSolid')],
    ]);
  }

  /** @param {import('../engine/types.js').GreyImage[]} pictures  to decode */
  async read_(pictures) {
    const [photo] = await this.client_.pictures('reader');
    const rgba = new Uint8ClampedArray(4 * photo.pixels.length);
    photo.pixels.forEach((grey, at) => rgba.set([grey, grey, grey, 255], 4 * at));
    show('photo', { width: photo.width, height: photo.height, rgba });
    await this.client_.setReadings(await readEach(pictures), kReaderName);
    const { text: read } = (await this.client_.report()).verification;
    write(byId('read', HTMLElement), () => (read ? text('method.readsAs', { text: read }) : text('method.notRead')));
  }

  /** @param {boolean} isShown */
  async showCarved_(isShown) {
    this.carved_.setAttribute('aria-pressed', String(isShown));
    await this.client_.show({ carved: isShown });
  }

  async lookFromAside_() {
    await this.client_.act({ kind: 'face' });
    await this.client_.act({ kind: 'orbit', dx: 160, dy: 40 });
  }
}

await startTexts('method');
void new Demonstration().run();
