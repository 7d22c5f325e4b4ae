// SPDX-License-Identifier: GPL-3.0-or-later
// Types of what crosses the boundary between the page and the module. No code.

/** @typedef {import('./message.js').Message} Message */
/** @typedef {Message & { kind: 'BadUsage' | 'BadInput' | 'NoSolution' | 'Internal' }} EngineError */
/** @typedef {Message & { severity: 'note' | 'warning' | 'blocking' }} Finding */

/**
 * @typedef {{ format: string, scaleToMm: number, triangles: number, vertices: number,
 *   sizeMm: [number, number, number], shells: number, engravable: boolean, findings: Finding[],
 *   centre: [number, number, number] | null }} ModelInfo
 *   `centre`: a surface point in the middle of the view
 */

/** @typedef {{ x: number, y: number, width: number, height: number }} Area  of the canvas, CSS pixels */

/** @typedef {'y' | 'z'} UpAxis */

/** @typedef {'auto' | 'none' | 'square' | 'thin-plus' | 'diamond' | 'thick-plus'} ModulePattern */
/** @typedef {'auto' | 'none' | 'as-modules' | 'diamond' | 'thick-plus' | 'thick-plus-sharp'} FinderPattern */

/**
 * @typedef {object} Settings
 * @property {string} text
 * @property {'L' | 'M' | 'Q' | 'H'} [ecc]            left out: M, or a higher one where that needs no larger version
 * @property {'shallow' | 'balanced' | 'robust'} preset   how dark the code is carved
 * @property {ModulePattern} pattern
 * @property {FinderPattern} finderPattern
 * @property {'free' | 'oriented' | 'best' | number} size   edge of the symbol without quiet zone; a number is mm
 * @property {number} maxSizeMm                    upper bound for a size that is found
 * @property {boolean} quietZone                   whether the quiet zone has to fit as well
 * @property {'mean-normal' | 'depth-balanced' | 'pca' | 'optimal'} direction
 * @property {number} rotateDeg
 * @property {number} [contrast]                   instead of that of the preset
 * @property {number} minWallMm
 * @property {number} nozzleMm                     of the printer, for advice
 * @property {number} layerMm
 * @property {number} [maxDepthMm]
 * @property {number} eyeDistanceMm
 * @property {import('./lamps.js').Lamp[]} [light]   beside the sky
 */

/**
 * @typedef {{ centre: [number, number, number], normal: [number, number, number], up: [number, number, number],
 *   symbolMm: number, moduleMm: number, guaranteedMm: number, version: number, modules: number, rotationDeg: number,
 *   direction: [number, number, number] | null, aimToleranceDeg: number, forgiving: boolean }} Placement
 *   `direction` that the centre came with, as a spot that was suggested; `aimToleranceDeg`: from how far aside, to every side, it can be read at most
 *   `rotationDeg`: of the symbol's top from upwards, anticlockwise
 */

/**
 * @typedef {{ symbolMm: number, moduleMm: number, guaranteedMm: number, missingShare: number, exact: boolean }} CodeFacts
 *   `missingShare`: of the square that must fit, 0 … 1: overhangs, or is hidden
 * @typedef {{ hit: boolean, onCode?: boolean, code?: CodeFacts }} HoverResult  `onCode`: over the code that has its place
 */

/**
 * Where the code and its quiet zone lie on the screen, CSS pixels: corners of the square from the upper left on,
 * clockwise for its reader; `facing`: cosine at which the camera looks at it.
 * @typedef {{ corners: [number, number][], facing: number, symbolMm: number, rotationDeg: number }} CodeOnScreen
 * @typedef {{ from: [number, number] | null, to: [number, number] }} LampOnScreen
 *   `from` the lamp, null behind the camera, `to` the middle of the code, CSS pixels
 * @typedef {{ code: CodeOnScreen | null, lamps: LampOnScreen[], axes: [number, number, number][] }} ViewState
 *   `axes` of the camera: right, up, back, in a space whose z is up
 */

/** @typedef {'front' | 'back' | 'left' | 'right' | 'top' | 'bottom' | 'iso'} StandardView */

/**
 * @typedef {{ spots: { centre: [number, number, number], sizeMm: number, aimToleranceDeg: number, concerns: Message[] }[], topMm: number }} Spots
 *   best first, with the largest size there; `concerns`: reasons why a code may not print or decode there; `topMm`: the
 *   size of the map's last colour
 */

/**
 * @typedef {{ version: number, ecc: 'L' | 'M' | 'Q' | 'H', mask: number, size: number, rows: string[], bytes: number, room: number,
 *   leastModuleMm: number | null }} SymbolFacts
 *   `rows`: '1' is dark; `bytes` of the text; `room`: more bytes that the version holds; `leastModuleMm`: that the printer
 *   makes of the pattern
 */

/** @typedef {{ hit: boolean, centre?: [number, number, number] }} PickResult */
/** @typedef {{ renderer: string, version: string, problems: Message[] }} Capabilities */
/** @typedef {{ stage: Message, fraction: number }} EngraveProgress */
/** @typedef {{ usedBytes: number, heapBytes: number, glObjects: number, glKinds: Record<string, number> }} MemoryUse  of the module; its heap never shrinks */
/** @typedef {{ width: number, height: number, pixels: Uint8Array }} GreyImage */
/** The newest pass of a search for depths. @typedef {{ luminance: JobMap, depths: JobMap }} SearchMaps */
/** @typedef {'surface' | 'luminance' | 'depths' | 'search-luminance' | 'search-depths'} JobMapName */
/**
 * @typedef {{ width: number, height: number, components: number, values: Float32Array }} JobMap
 *   what the last engraving worked on; row 0 at the bottom. `surface`: normal (right, up, towards the reader) and height
 *   in mm, all zero beside the model; `luminance`: 1 = unoccluded; `depths`: mm, one value a submodule
 */

/** @typedef {{ moduleMm: number, pocketMm: number, leastDepthMm: number, leastDepthLayers: number, nozzleMm: number }} CarvedFeatures */
/** @typedef {{ overall: number } & Record<string, any>} Grades  by parameter: `value` in its own unit, `grade` 4 (A) … 0 (F) */
/** @typedef {{ width: number, height: number, pixels: Uint8Array<ArrayBuffer> }} ColourImage  RGBA, row 0 at the top */

/** @typedef {'good' | 'barely' | 'bad'} Level */
/**
 * What would help: without a change, another place for the code.
 * @typedef {Message & { change?: { setting: string, value: string } }} Remedy  `value`: as settings files write it; '': the default
 * @typedef {{ level: Level, passed: boolean, summary: Message, warnings: Message[], reasons: Message[], remedies: Remedy[] }} Aspect
 * @typedef {{ passed: boolean, reads: Aspect, prints: Aspect, solid: Aspect }} Verdict
 * @typedef {{ passed: boolean, next: { setting: string, value: string } | null }} ReadingResult  `next`: what to carve with instead
 * @typedef {ReadingResult & { report: Report }} PrintedResult  of a carving and its print; `report`: with the print in it
 * @typedef {{ tilts: { tiltDeg: number, reads: number, all: number }[], safeTiltDeg: number, forgiving: boolean,
 *   pixelsPerModule: number | null, distanceMm: number | null }} ViewTrials
 *   `tilts`: up to the first from which nothing is read; `forgiving`: read from as far aside as hands hold a phone without taking
 *   care; `pixelsPerModule`: a module's least width at which it reads, and `distanceMm`: how far a phone is then
 * @typedef {{ done: boolean, tried: number, all: number, views: ViewTrials }} ViewTrialProgress
 */

/**
 * The part of the report (see the contract) that the page shows.
 * @typedef {object} Report
 * @property {string} text
 * @property {{ version: number, ecc: string, modules: number }} symbol
 * @property {{ symbolMm: number, moduleMm: number, guaranteedMm: number }} size
 * @property {{ meanMm: number, maxMm: number, iterations: number, limitedSubmodules: number, features: CarvedFeatures }} depth
 * @property {{ triangles: number, closed: boolean, manifold: boolean, selfIntersections: number, volumeMm3: number }} mesh
 * @property {{ decoded: boolean, text: string, verdict: Verdict, iso15415: Grades, iso29158: Grades }} verification
 * @property {{ eyeDistanceMm: number }} projection
 * @property {{ total: number } & Record<string, number>} timingsMs
 */

/**
 * What a batch is asked for: what all rows have, the templates of text and file name ('' where the list's columns say
 * them), how many rows are numbered without a list, else 0, and how many stand on a plate; 0: each has a file of its own.
 * @typedef {{ settings: Settings, text: string, name: string, count: number, perPlate: number }} WantedBatch
 * @typedef {{ rows: number, problems: Message[], mayBeMore: boolean, unused: string[], version?: number, modules?: number }} BatchPlan
 *   with a problem there are no rows; `unused`: columns that nothing asks for
 * @typedef {{ number: number, line: number, id: string, text: string, file: string }} BatchRowName
 * @typedef {BatchRowName & { settings: Partial<Settings> & Record<string, unknown> }} BatchRow  `settings` that are not those of all
 * @typedef {{ passed: boolean, failed: Message[], details: object }} DescribedRow  `failed`: checks
 * @typedef {{ number: number, id: string, text: string, file: string, status: 'done' | 'failed', reason?: string,
 *   sha256: { input: string, settings: string, output?: string } }} ManifestEntry  with the details of DescribedRow beside
 */

/** @typedef {{ order: object, stl: Uint8Array<ArrayBuffer> }} PrintJob  the carved model, and what is to be made of it */
/**
 * A carved code as the printer leaves it.
 * @typedef {{ facingDeg: number, misread: [number, number][], pictures: GreyImage[], picture: GreyImage }} Print
 *   `facingDeg` between the code's normal and the printer's vertical; `misread`: row and column of the modules that the print
 *   has lost; `pictures` for readers; `picture`: the symbol from the front with 6 modules around it
 */

/** @typedef {{ process?: string, buildUp?: string }} PrintChange  as settings files write it */
/**
 * Other ways of printing the same carving: how many were made, of how many, and what they came to; `fraction` of the one that
 * is being made, none when it is over; `error`: why it ended.
 * @typedef {{ tried: { change: PrintChange, prints: Aspect }[], all: number, fraction?: number, error?: EngineError }} PrintTrials
 */

/**
 * How far the print of a carving is.
 * @typedef {{ state: 'none' } | { state: 'made', print: Print, trials?: PrintTrials } | { state: 'under-way', fraction: number } | { state: 'stopped' } |
 *   { state: 'failed', error: EngineError }} Printed
 *   none: it is not asked for
 */

/**
 * How the module answers a verb: its value, or what went wrong.
 * @typedef {{ ok: false, error: EngineError }} Failure
 */

/**
 * The class `Engine` of the module (embind); JSON travels as strings.
 * @typedef {object} Engine
 * @property {() => string} capabilities
 * @property {(bytes: Uint8Array, fileName: string, scaleToMm: number) => string} loadModel
 * @property {(width: number, height: number, devicePixelRatio: number) => void} resize
 * @property {(settings: string) => string} configure
 * @property {(settings: string) => string} symbol
 * @property {(x: number, y: number) => string} pick
 * @property {(x: number, y: number, z: number) => string} setCentre
 * @property {() => string} placement
 * @property {(x: number, y: number) => string} hover
 * @property {() => void} endHover
 * @property {() => string} startSettling
 * @property {() => string} advanceSettling
 * @property {(x: number, y: number) => string} moveCode
 * @property {(rotateDeg: number, symbolMm: number) => string} adjustCode
 * @property {() => string} startSpotSearch
 * @property {() => string} advanceSpotSearch
 * @property {() => void} cancelSpotSearch
 * @property {() => string} spots
 * @property {(index: number) => string} chooseSpot
 * @property {(shown: boolean) => void} showSizes
 * @property {() => string} prepareEngrave
 * @property {(withOverrides: boolean) => string} startEngrave
 * @property {() => string} advance
 * @property {() => void} cancel
 * @property {() => number} carving
 * @property {(number: number) => boolean} useCarving
 * @property {() => string} report
 * @property {() => GreyImage} readerImage
 * @property {(name: JobMapName) => JobMap | null} jobMap
 * @property {() => GreyImage[]} readingPictures
 * @property {(texts: string, reader: string) => string} setReadings
 * @property {(changed: string) => string} printOrder
 * @property {() => Uint8Array} stlToPrint
 * @property {() => string} otherPrints
 * @property {(changed: string, texts: string, facingDeg: number) => string} judgePrint
 * @property {(texts: string, facingDeg: number) => string} setPrintedReadings
 * @property {(totalMs: number) => string} describeRow
 * @property {(copies: number) => string} startPlate
 * @property {(place: number, id: string) => string} addToPlate
 * @property {(title: string) => Uint8Array} exportPlate
 * @property {() => string} startViewTrials
 * @property {() => GreyImage[]} viewTrialPictures
 * @property {(read: boolean) => string} noteViewTrial
 * @property {(format: string) => Uint8Array} exportModel
 * @property {(dark: boolean) => void} setTheme
 * @property {(axis: UpAxis) => void} setUpAxis
 * @property {(carved: boolean) => void} showCarved
 * @property {(dx: number, dy: number) => void} orbit
 * @property {(dx: number, dy: number) => void} pan
 * @property {(factor: number, x: number, y: number) => void} zoom
 * @property {() => void} fit
 * @property {(name: StandardView) => void} standardView
 * @property {() => void} readerView
 * @property {(shown: boolean, offset: number) => void} showSection
 * @property {() => void} faceSection
 * @property {(shown: boolean) => string} showDepths
 * @property {() => string} viewState
 * @property {(index: number, width: number, height: number) => ColourImage} spotPicture
 * @property {() => void} faceCode
 * @property {() => boolean} draw
 * @property {() => number} memoryInUse            bytes of the heap
 * @property {() => void} openInspector
 * @property {(shown: boolean) => void} showInspector
 * @property {(texts: string) => void} inspectorTexts
 * @property {(x: number, y: number, width: number, height: number) => void} inspectorArea
 * @property {(lineHeight: number, metrics: Float32Array, alpha: Uint8Array) => void} inspectorGlyphs
 * @property {(x: number, y: number, buttons: number, wheel: number) => boolean} inspectorPointer
 * @property {(key: string, control: boolean, shift: boolean) => void} inspectorKey
 * @property {(x: number, y: number) => boolean} inspectorPick
 * @property {() => string} inspectorState
 */

/**
 * The class `PrintedCode` of the module: makes one print, and needs no canvas.
 * @typedef {object} PrintedCode
 * @property {(stl: Uint8Array, order: string) => string} start
 * @property {() => string} advance
 * @property {() => GreyImage[]} readingPictures
 * @property {() => GreyImage} picture
 */

/**
 * The class `PlannedBatch` of the module: a list's rows, and the manifest's lines; it needs neither canvas nor model.
 * @typedef {object} PlannedBatch
 * @property {(list: Uint8Array, wanted: string) => string} plan
 * @property {(from: number, count: number) => string} rows
 * @property {(index: number) => string} row
 * @property {(index: number, placed: string) => string} toHash
 * @property {(entry: string) => string} manifestLine
 * @property {(lines: string, withHeader: boolean) => string} manifestCsv
 */

/**
 * Emscripten's tables from the names C++ has to WebGL's objects; null where one was deleted.
 * @typedef {Record<'buffers' | 'programs' | 'framebuffers' | 'renderbuffers' | 'textures' | 'shaders' | 'vaos' | 'queries' | 'syncs',
 *   (object | null)[]>} GlTables
 */

/**
 * @typedef {object} QReliefModule
 * @property {new () => Engine} Engine
 * @property {new () => PrintedCode} PrintedCode
 * @property {new () => PlannedBatch} PlannedBatch
 * @property {{ registerContext: (gl: WebGL2RenderingContext, attributes: { majorVersion: number }) => number,
 *   makeContextCurrent: (handle: number) => boolean } & GlTables} GL
 * @property {Uint8Array} HEAPU8
 */

/**
 * Everything the view may ask for; positions in CSS pixels of the canvas.
 * @typedef {{ kind: 'orbit', dx: number, dy: number } | { kind: 'pan', dx: number, dy: number }
 *   | { kind: 'zoom', factor: number, x: number, y: number } | { kind: 'fit' } | { kind: 'readerView' } | { kind: 'face' }
 *   | { kind: 'standard', name: StandardView } | { kind: 'faceSection' }
 *   | { kind: 'pointer', x: number, y: number, buttons: number, wheel: number }
 *   | { kind: 'key', key: string, control: boolean, shift: boolean }} ViewAction  `key` is the inspector's
 */

/** @typedef {{ width: number, height: number, devicePixelRatio: number }} ViewSize */

/** @typedef {[number, number, number, number]} Box  x, y, width, height */

/**
 * What the inspector shows; its canvas says nothing to those who cannot see it, nor to tests.
 * @typedef {object} InspectorState
 * @property {string} tab
 * @property {string} channel
 * @property {number} pass      from 1; 0 before there is any
 * @property {number} passes
 * @property {{ row: number, column: number, role: string, carved: boolean, LS: number, AL: number | null,
 *   G: number | null, depthMm: number | null, limitMm: number | null } | null} selected  submodule
 * @property {number} overridden     how many settings differ from the page's
 * @property {string} overrides      which, in words
 * @property {number} engraveAsked   how often "Engrave again" was pressed
 * @property {boolean} keyboard      whether it takes the keys
 * @property {string} cursor         over it; empty: elsewhere
 * @property {Box} window
 * @property {Record<string, Box>} controls
 * @property {boolean} still         its layout has come to an end, for what was done so far
 */

/**
 * What the host tells the page unasked.
 * @typedef {{ event: 'progress', progress: EngraveProgress } | { event: 'view', state: ViewState } | { event: 'contextlost' }
 *   | { event: 'failure', error: EngineError } | { event: 'inspector', state: InspectorState }
 *   | { event: 'printable', job: PrintJob | null } | { event: 'search', search: SearchMaps }} HostEvent
 */

export {};
