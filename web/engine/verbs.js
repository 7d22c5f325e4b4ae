// SPDX-License-Identifier: GPL-3.0-or-later
// The verbs of the module: one row each, named after its C++ method. From the rows come the bindings
// (wasm/list_verbs.js), the calls of the host (module_calls.js), and the methods of the client with their types
// (client.js). A row's type is the type of the verb for JavaScript: objects travel to the module as JSON, and JSON
// answers arrive as objects.

/** @typedef {import('./types.js').Aspect} Aspect */
/** @typedef {import('./types.js').ColourImage} ColourImage */
/** @typedef {import('./types.js').EngraveProgress & { done: boolean }} JobProgress */
/** @typedef {import('./types.js').GreyImage} GreyImage */
/** @typedef {import('./types.js').HoverResult} HoverResult */
/** @typedef {Omit<import('./types.js').InspectorState, 'still'>} InspectorState */
/** @typedef {import('./types.js').PickResult} PickResult */
/** @typedef {import('./types.js').PrintChange} PrintChange */
/** @typedef {JobProgress & Pick<import('./types.js').Print, 'facingDeg' | 'misread'>} PrintProgress */
/** @typedef {import('./types.js').Settings} Settings */

/**
 * The answers of the jobs' steps. `preparation` is never started.
 * @typedef {object} JobAnswers
 * @property {JobProgress & import('./types.js').EngraveStep & { printable: boolean }} engrave
 * @property {JobProgress & import('./types.js').Spots} spots  the spots come with the last step
 * @property {HoverResult & { done: boolean }} settling
 * @property {{ done: boolean, depths: import('./types.js').FoundDepths | null }} preparation
 * @property {import('./types.js').ViewTrialProgress} view-trials
 */
/** @typedef {{ search: boolean, hovered?: boolean }} PreparationOptions  of `preparation`; see Engine::advanceJob() */
/** @typedef {JobProgress & { all?: undefined } | { stage?: undefined, all?: number }} StartedJob */
/** @typedef {import('./types.js').EngraveOptions & { withOverrides?: boolean }} JobOptions  of `engrave` */

/**
 * A row.
 * @template {(...given: any[]) => any} Call
 * @typedef {object} Verb
 * @property {'InspectedEngine'} [of]  the C++ class, if it is not the class of the table
 * @property {string} [part]           the field of the answer that the caller gets; default: the answer
 * @property {boolean} [draws]         the verb changes the picture
 * @property {Call} [call]             never set; keeps the type
 */

/**
 * The functions of a table.
 * @template Rows
 * @typedef {{ [Name in keyof Rows]: Rows[Name] extends Verb<infer Call> ? Call : never }} Calls
 */

/** Verbs of the engine that the page calls. The C++ class is Engine. */
export const kPageVerbs = {
  /** @type {Verb<() => import('./types.js').Capabilities>} */
  capabilities: {},
  /**
   * Loads a model from a file; the bytes remain usable.
   * @type {Verb<(bytes: Uint8Array, fileName: string, scaleToMm: number) => import('./types.js').ModelInfo>}
   */
  loadModel: { part: 'model', draws: true },
  /** @type {Verb<(settings: Settings) => void>} */
  configure: { draws: true },
  /** Finds the placement at the centre. @type {Verb<() => import('./types.js').Placement>} */
  placement: { part: 'placement', draws: true },
  /** Returns how the placed code was placed; null: none is. @type {Verb<() => import('./types.js').Construction | null>} */
  construction: { part: 'construction' },
  /** Returns why the hovered code may not print or decode; none before it has settled. @type {Verb<() => import('./types.js').Message[]>} */
  hoverConcerns: { part: 'concerns' },
  /** Previews a change of the placed code. @type {Verb<(change: import('./types.js').CodeChange) => HoverResult>} */
  adjustCode: { draws: true },
  /**
   * Shows a lamp under the pointer, until the next `configure`. Returns all lamps.
   * @type {Verb<(where: { lamp: number, at: [number, number] }) => Required<import('./lamps.js').Lamp>[]>}
   */
  moveLamp: { part: 'lamps', draws: true },
  /** Draws a spot. @type {Verb<(index: number, width: number, height: number) => ColourImage>} */
  spotPicture: {},

  /**
   * Returns the number of the finished carving that can be reported and exported; 0: none.
   * @type {Verb<() => number>}
   */
  carving: {},
  /** Restores a carving that is kept; false: it is gone. @type {Verb<(number: number) => boolean>} */
  useCarving: { draws: true },
  /** @type {Verb<() => import('./types.js').Report>} */
  report: {},
  /**
   * Draws pictures of the carving, none without one: the one that a phone takes, those to decode, or those of the next
   * view trial, of which one has to decode.
   * @type {Verb<(of: 'reader' | 'reading' | 'view-trial') => GreyImage[]>}
   */
  pictures: {},
  /**
   * Returns a map of the last engraving; null before the first one.
   * @type {Verb<(name: import('./types.js').JobMapName) => import('./types.js').JobMap | null>}
   */
  jobMap: {},
  /**
   * Returns the maps of a carving as NPZ; no bytes if there is none.
   * @type {Verb<(carving: number) => Uint8Array<ArrayBuffer>>}
   */
  exportMaps: {},
  /**
   * Reports the text that each try on the reading pictures decoded, '' if none, and the decoder's name.
   * @type {Verb<(texts: string[], reader: string) => import('./types.js').ReadingResult>}
   */
  setReadings: {},
  /**
   * Describes the current carving for the manifest.
   * @type {Verb<(totalMs: number) => import('./types.js').DescribedRow>}
   */
  describeRow: {},
  /**
   * Adds the current carving to the plate, at a place from 0; `copies`: number of places.
   * @type {Verb<(place: number, id: string, copies: number) => void>}
   */
  addToPlate: {},

  /**
   * Shows or hides what is named. Returns the depth of the last colour and of the deepest pocket; 0 without a carving.
   * @type {Verb<(what: import('./types.js').Shown) => { topMm: number, deepestMm: number }>}
   */
  show: { of: 'InspectedEngine', draws: true },
  /**
   * Shows a simulated print in place of the carved model until the camera moves; no pixels: hides it.
   * @type {Verb<(pixels: Uint8Array, size: number) => void>}
   */
  showPrint: { draws: true },
};

/** Verbs of the engine that only the host calls. The C++ class is Engine. */
export const kInnerVerbs = {
  /** @type {Verb<(where: import('./types.js').CentreChoice) => PickResult>} */
  setCentre: {},
  /** @type {Verb<(at: [number, number]) => import('./types.js').LaidFace>} */
  layFace: {},
  /** @type {Verb<(at: [number, number] | null) => HoverResult>} */
  hover: {},
  /**
   * Starts a job; see Engine::startJob().
   * @type {Verb<(job: 'engrave' | 'spots' | 'settling' | 'view-trials', options: JobOptions) => StartedJob>}
   */
  startJob: { of: 'InspectedEngine' },
  /**
   * Does one bounded piece of work. `given`: see Engine::advanceJob().
   * @type {Verb<<Name extends keyof JobAnswers>(job: Name, given: { read?: boolean } | PreparationOptions) => JobAnswers[Name]>}
   */
  advanceJob: {},
  /** @type {Verb<(job: 'engrave' | 'spots') => void>} */
  cancelJob: {},
  /** @type {Verb<(changed: PrintChange) => object | null>} */
  printOrder: { part: 'order' },
  /** @type {Verb<(texts: string[], facingDeg: number) => Omit<import('./types.js').PrintedResult, 'report'>>} */
  setPrintedReadings: {},
  /** @type {Verb<() => PrintChange[]>} */
  otherPrints: { part: 'others' },
  /** @type {Verb<(changed: PrintChange, texts: string[], facingDeg: number) => Aspect>} */
  judgePrint: { part: 'prints' },
  /** @type {Verb<(format: string, slicer: import('./types.js').Slicer, carving: number) => Uint8Array<ArrayBuffer>>} */
  exportModel: {},
  /** @type {Verb<(name: string, carving: number) => import('./types.js').NamedFile[]>} */
  exportFiles: {},
  /** @type {Verb<(title: string) => Uint8Array<ArrayBuffer>>} */
  exportPlate: {},

  /** @type {Verb<(width: number, height: number, devicePixelRatio: number) => void>} */
  resize: { of: 'InspectedEngine' },
  /** @type {Verb<(action: import('./types.js').LookAction) => void>} */
  look: {},
  /**
   * Draws a frame. `more`: another call would improve the picture; `inspector`: null if it is not shown.
   * @type {Verb<() => { more: boolean, view: import('./types.js').ViewState, inspector: InspectorState | null }>}
   */
  draw: { of: 'InspectedEngine' },

  /** Returns true if the inspector uses the event. @type {Verb<(event: import('./types.js').InspectorEvent) => boolean>} */
  inspector: { of: 'InspectedEngine', part: 'takes' },
  /** @type {Verb<(lineHeight: number, metrics: Float32Array, alpha: Uint8Array) => void>} */
  inspectorGlyphs: { of: 'InspectedEngine' },
};

/** Verbs for batches, which the page calls. The C++ class is PlannedBatch. */
export const kBatchVerbs = {
  /**
   * Reads a list, which remains usable, and checks it as a whole. The other batch verbs refer to its rows.
   * @type {Verb<(list: Uint8Array, request: import('./types.js').BatchRequest) => import('./types.js').BatchPlan>}
   */
  planBatch: {},
  /** @type {Verb<(index: number) => import('./types.js').BatchRow>} */
  batchRow: { part: 'row' },
  /**
   * Returns the texts to hash as the settings of a unit: a row, or all rows of its plate. `of` 'plate': the texts whose
   * hashes are needed as `mates` for that; `others`: how the model was scaled and turned.
   * @type {Verb<(index: number, placed: { of: 'plate' | 'rows', centre: number[], others: string, mates: string[] }) => string[]>}
   */
  unitTexts: { part: 'texts' },
  /**
   * Returns the rows of a unit before they are carved. `settings`: hashes of their texts, or none.
   * @type {Verb<(index: number, hashes: { input: string, settings: string[] }) => import('./types.js').ManifestEntry[]>}
   */
  unitEntries: { part: 'entries' },
};

/** Verbs for the progress of a batch and its manifest. They need no plan. The C++ class is TrackedBatch. */
export const kTrackVerbs = {
  /** Begins with all rows waiting. @type {Verb<(layout: import('./types.js').BatchLayout) => void>} */
  begin: {},
  /**
   * Counts the rows, and lists a page of those in a state, after the first `skipped`. `workedMs`: time of the run without
   * pauses.
   * @type {Verb<(asked: { workedMs?: number, page?: import('./types.js').RowPage }) => import('./types.js').BatchState>}
   */
  state: {},
  /**
   * Begins or ends a run. `retry`: begins, and failed rows wait again; `end`: running rows wait again.
   * @type {Verb<(what: 'start' | 'retry' | 'end') => void>}
   */
  run: {},
  /** Returns the rows to carve next, all of one file; none: no row waits. @type {Verb<() => import('./types.js').RowToCarve[]>} */
  take: { part: 'rows' },
  /** Records stored results, as lines of the manifest. @type {Verb<(lines: string) => void>} */
  settle: {},
  /**
   * Returns how to go on after an engine was lost. `index`: of one of its rows; -1: it did not start.
   * @type {Verb<(index: number) => 'retry' | 'fail' | 'stop'>}
   */
  lose: { part: 'then' },
  /** Formats a manifest line, without line break. @type {Verb<(entry: import('./types.js').ManifestEntry) => string>} */
  manifestLine: { part: 'line' },
  /** Converts manifest lines to CSV. @type {Verb<(lines: string, withHeader: boolean) => string>} */
  manifestCsv: { part: 'csv' },
  /**
   * Reads the next bytes of a manifest. `restores`: the lines set the states of the rows.
   * @type {Verb<(bytes: Uint8Array, isFirst: boolean, restores: boolean) => void>}
   */
  readManifest: {},
  /**
   * Returns the byte range of the last line about each row from a number on, and the number to continue with; null: no
   * more.
   * @type {Verb<(fromNumber: number, countAtMost: number) => { spans: [begin: number, end: number][], next: number | null }>}
   */
  manifestSpans: {},
};

/** Verbs that need no graphics. The C++ class is Facts. */
export const kFactVerbs = {
  /**
   * Reads, checks and repairs a model.
   * @type {Verb<(bytes: Uint8Array, fileName: string, scaleToMm: number) => Omit<import('./types.js').ModelInfo, 'centre'>>}
   */
  model: { part: 'model' },
  /** Returns the symbol or the letters that these settings engrave. @type {Verb<(settings: Settings) => import('./types.js').SymbolFacts | { letters: import('./types.js').LetterFacts }>} */
  symbol: { part: 'symbol' },
  /** Advises on a text that is, or was meant to be, a link. @type {Verb<(text: string) => import('./types.js').TextAdvice>} */
  textAdvice: {},
};

/** Verbs of one simulated print. The C++ class is PrintedCode. */
export const kPrintVerbs = {
  /** @type {Verb<(stl: Uint8Array, order: object) => PrintProgress>} */
  start: {},
  /** @type {Verb<() => PrintProgress>} */
  advance: {},
  /** @type {Verb<(of: 'reading' | 'front') => GreyImage[]>} */
  pictures: {},
};

/** Verbs that the host adds for the page, as methods of its own. */
export const kHostVerbs = /** @type {const} */ ([
  'resize',
  'setCentre',
  'layFace',
  'hover',
  'settle',
  'findSpots',
  'prepareEngrave',
  'carvePreview',
  'engrave',
  'continueEngrave',
  'endEngrave',
  'startViewTrials',
  'noteViewTrial',
  'cancel',
  'memory',
  'printJob',
  'otherPrints',
  'judgePrint',
  'setPrintedReadings',
  'exportModel',
  'exportFiles',
  'exportPlate',
  'picture',
  'inspector',
  'act',
]);
