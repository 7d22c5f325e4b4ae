// SPDX-License-Identifier: GPL-3.0-or-later
// Types of all values that cross the boundary between the page and the module. No code.

/** @typedef {import('./message.js').Message} Message */
/** @typedef {Message & { kind: 'BadUsage' | 'BadInput' | 'NoSolution' | 'Internal' }} EngineError */
/** @typedef {Message & { severity: 'note' | 'warning' | 'blocking' }} Finding */

/**
 * @typedef {{ format: string, scaleToMm: number, triangles: number, vertices: number,
 *   sizeMm: [number, number, number], shells: number, bodies: { name: string, triangles: number }[], engravable: boolean, findings: Finding[],
 *   only3mf: ('paint' | 'plates')[], centre: [number, number, number] | null }} ModelInfo
 *   `only3mf`: contents of the model's 3MF file that no other format keeps; `centre`: proposed centre of the code: a
 *   surface point in the middle of the view
 */

/**
 * @typedef {{ hit: boolean, buildUp?: Settings['buildUp'] }} LaidFace
 *   `buildUp`: the setting that lays the face on the printer's plate
 */

/** @typedef {{ x: number, y: number, width: number, height: number }} Area  of the canvas, CSS pixels */

/** @typedef {'y' | 'z'} UpAxis */

/** @typedef {'auto' | 'none' | 'square' | 'thin-plus' | 'diamond' | 'thick-plus'} ModulePattern */
/** @typedef {'auto' | 'none' | 'as-modules' | 'diamond' | 'thick-plus' | 'thick-plus-sharp'} FinderPattern */

/**
 * Settings by their keys; what is left out has its default. web/generated/settings.js has ranges and defaults, and
 * docs/options.md the meanings.
 * @typedef {object} Settings
 * @property {string} text
 * @property {'code' | 'text'} [content]             what to make of the text
 * @property {'auto' | 'L' | 'M' | 'Q' | 'H'} [ecc]
 * @property {number} [version]
 * @property {'auto' | 'shadiest' | number} [mask]
 * @property {'auto' | 'never'} [eci]
 * @property {'auto' | 'shadow' | 'inlay' | 'paint'} [mark]
 * @property {number} [markDepthMm]
 * @property {number} [albedo]                     fraction of light that the model reflects
 * @property {number} [darkReflectance]            the same of the second colour
 * @property {'shallow' | 'balanced' | 'robust'} [preset]   target darkness of the code
 * @property {boolean} [keepPreset]
 * @property {ModulePattern} [pattern]
 * @property {string} [patternMask]               five rows of submodules in place of `pattern`, 1 is carved: '00100/…'
 * @property {FinderPattern} [finderPattern]
 * @property {number} [contrast]                   overrides the preset's
 * @property {'design' | 'print'} [carveFor]
 * @property {'contrast' | 'one-light'} [objective]
 * @property {'fast' | 'paper-steps'} [solver]
 * @property {number} [maxDepthMm]
 * @property {number} [minWallMm]
 * @property {'best' | 'oriented' | 'free' | number} [size]   edge of the symbol without quiet zone; a number is mm
 * @property {number} [maxSizeMm]                  upper limit of a found size
 * @property {boolean} [quietZone]                 the quiet zone has to fit on the surface
 * @property {[number, number, number]} [up]
 * @property {number} [rotateDeg]
 * @property {'mean-normal' | 'depth-balanced' | 'pca' | 'optimal' | 'largest' | [number, number, number]} [direction]
 * @property {number} [eyeDistanceMm]
 * @property {import('./lamps.js').Lamp[]} [light]   in addition to the sky
 * @property {'preserved' | 'resampled'} [surface]
 * @property {string} [label]
 * @property {'none' | 'rounded' | 'square'} [frame]
 * @property {string} [process]                    'none' or a key of kProcesses
 * @property {number} [nozzleMm]                   of the printer, for advice
 * @property {number} [layerMm]
 * @property {number} [lineWidthMm]
 * @property {'as-modelled' | 'code-up' | 'code-upright' | [number, number, number]} [buildUp]
 */

/**
 * @typedef {{ centre: [number, number, number], normal: [number, number, number], up: [number, number, number],
 *   symbolMm: number, moduleMm: number, largestMm: number, sizeMode: 'best' | 'oriented' | 'free' | 'fixed',
 *   concerns: Message[], version: number, modules: number, rotationDeg: number,
 *   direction: [number, number, number] | null, aimToleranceDeg: number, forgiving: boolean, colourLayers: number, capitalMm: number | null }} Placement
 *   `direction`: viewing direction of a suggested spot, null otherwise; `aimToleranceDeg`: largest angle off the
 *   viewing direction, to any side, at which the code can decode; `colourLayers`: layers that the code lies in with its
 *   label and frame, 0 if the printer is not known; `rotationDeg`: angle from up to the symbol's top, anticlockwise; `largestMm`: largest symbol that fits at this rotation, walls ignored; `concerns`: reasons why the
 *   code may not print or decode there; `capitalMm`: height of the capitals of a text alone, null for a code
 */

/**
 * @typedef {{ symbolMm: number, moduleMm: number, capitalMm: number | null, missingShare: number, forgiving: boolean,
 *   exact: boolean }} CodeFacts
 *   `missingShare`: share of the required square, 0 … 1, that overhangs or is hidden; `forgiving`: flat enough to be
 *   read by a phone held without care
 * @typedef {{ hit: boolean, onCode?: boolean, code?: CodeFacts }} HoverResult
 *   `onCode`: the pointer is over the placed code
 */

/**
 * Position of the code with its quiet zone and label on the screen. `corners`: CSS pixels, clockwise from the upper left
 * as seen by the viewer, `edgeMm` apart on the QR plane; `facing`: cosine of the angle between the camera's view and the
 * code's normal.
 * @typedef {{ corners: [number, number][], facing: number, edgeMm: number, symbolMm: number, rotationDeg: number }} CodeOnScreen
 * @typedef {{ from: [number, number] | null, to: [number, number] }} LampOnScreen
 *   line from the lamp, null behind the camera, to the centre of the code, CSS pixels
 * @typedef {{ foot: [number, number], top: [number, number], heightMm: number }} PlateOnScreen
 *   upright edge of the model's box over the plate, at its left on the screen, CSS pixels
 * @typedef {{ code: CodeOnScreen | null, lamps: LampOnScreen[], buildPlate: PlateOnScreen | null,
 *   construction: ConstructionOnScreen | null, axes: [number, number, number][] }} ViewState
 *   `buildPlate`, `construction`: if they are shown; `axes`: right, up and back of the camera, in a space with z up
 */

/**
 * How a code was placed. `eyeMm`: distance of the eye; `closestMm`: distance of S, the silhouette's point closest to the
 * centre, null: too far away to limit the size; `largestMm`: largest code; `squareMm`: edge of the square that has to
 * fit for it; `variancesMm2`: variance of the distance from each direction that was tried; `chosen`: the code's one
 * @typedef {{ eyeMm: number, closestMm: number | null, largestMm: number, squareMm: number, variancesMm2: number[],
 *   chosen: number | null, colours: Record<'plane' | 'projection' | 'silhouette' | 'square' | 'directions', string> }} Construction
 * @typedef {[number, number] | null} PointOnScreen  CSS pixels; null: not there, or behind the camera
 * @typedef {{ centre: PointOnScreen, closest: PointOnScreen, eye: PointOnScreen, directions: PointOnScreen[] }} ConstructionOnScreen
 *   `directions`: the tips of the arrows
 */

/** @typedef {'front' | 'back' | 'left' | 'right' | 'top' | 'bottom' | 'iso'} StandardView */

/**
 * @typedef {{ spots: { centre: [number, number, number], sizeMm: number, aimToleranceDeg: number, concerns: Message[] }[], topMm: number,
 *   fixedMm: number | null }} Spots
 *   best first; `sizeMm`: largest size that fits; `concerns`: reasons why a code may not print or decode there;
 *   `topMm`: size of the map's last colour; `fixedMm`: the fixed size, which the map shows the room for; null: none
 */

/**
 * @typedef {{ version: number, ecc: 'L' | 'M' | 'Q' | 'H', mask: number, size: number, rows: string[], bytes: number, room: number,
 *   leastModuleMm: number | null }} SymbolFacts
 *   `rows`: '1' is dark; `bytes`: length of the text; `room`: bytes left in this version; `leastModuleMm`: smallest
 *   module of this pattern that the printer can make
 */

/**
 * The letters of a text alone. `size`: edge of the square that they fill; `path`: their outlines in it, as in SVG;
 * `capital`: height of a capital, in the same unit; `leastMm`: smallest edge at which the printer makes their strokes
 * @typedef {{ size: number, path: string, capital: number, leastMm: number | null }} LetterFacts
 */

/**
 * Advice on a text that is, or was meant to be, a link. `fixed`: the corrected text, or ''; `shorter`: other ways to
 * write it that may need a smaller symbol.
 * @typedef {object} TextAdvice
 * @property {{ severity: 'warning' | 'note', message: import('./message.js').Message, fixed: string }[]} advice
 * @property {{ form: 'capitals' | 'www' | 'highlight', text: string }[]} shorter
 */

/**
 * A centre of the code: the surface point at a position on the canvas, the one nearest to a point, or a spot found last.
 * @typedef {{ at: [number, number], exact?: boolean } | { mm: [number, number, number] } | { spot: number }} CentreChoice
 *   `exact`: not moved to where the code lies flat
 * @typedef {{ hit: boolean, centre?: [number, number, number], movedMm?: number }} PickResult  `movedMm`: from the position on the canvas
 */
/**
 * A change to the placed code: to a position on the canvas, or to a rotation and size.
 * @typedef {{ at: [number, number] } | { rotateDeg: number, symbolMm: number }} CodeChange
 */
/** @typedef {{ renderer: string, version: string, problems: Message[] }} Capabilities */
/**
 * @typedef {{ stage: Message, fraction: number, changes?: SettingChange[] }} EngraveProgress
 *   `changes`: of an engraving's attempt from the code as requested
 */
/** The depths that a search has found, over the carved submodules. @typedef {{ meanMm: number, maxMm: number }} FoundDepths */
/** @typedef {{ name: string, bytes: Uint8Array<ArrayBuffer> }} NamedFile */
/**
 * @typedef {{ usedBytes: number, heapBytes: number, glObjects: number, glKinds: Record<string, number> }} MemoryUse
 *   `heapBytes` never shrinks
 */
/** @typedef {{ width: number, height: number, pixels: Uint8Array<ArrayBuffer> }} GreyImage */
/** The maps of the latest pass of a depth search. @typedef {{ luminance: JobMap, depths: JobMap }} SearchMaps */
/** @typedef {'surface' | 'luminance' | 'depths' | 'search-luminance' | 'search-depths'} JobMapName */
/**
 * @typedef {{ width: number, height: number, components: number, values: Float32Array }} JobMap
 *   a map of the last engraving; row 0 at the bottom. `surface`: normal (right, up, towards the viewer) and height in
 *   mm, all zero off the model; `luminance`: 1 = unoccluded; `depths`: mm, one value per submodule
 */

/**
 * @typedef {{ moduleMm: number, pocketMm: number, leastDepthMm: number, leastDepthLayers: number, nozzleMm: number }} CarvedFeatures
 */
/**
 * @typedef {{ overall: number } & Record<string, any>} Grades
 *   per parameter: `value` in its own unit, `grade` 4 (A) … 0 (F)
 */
/** @typedef {{ width: number, height: number, pixels: Uint8Array<ArrayBuffer> }} ColourImage  RGBA, row 0 at the top */

/** @typedef {'good' | 'barely' | 'bad'} Level */
/**
 * A change of a setting. @typedef {{ setting: string, value: string }} SettingChange
 */
/**
 * A remedy: changes of settings, or, without `changes`, moving the code.
 * @typedef {Message & { changes?: SettingChange[] }} Remedy
 *   `value`: as in settings files; '': the default
 * @typedef {{ level: Level, passed: boolean, summary: Message, warnings: Message[], reasons: Message[], remedies: Remedy[] }} Aspect
 * @typedef {{ passed: boolean, reads: Aspect, prints: Aspect, solid: Aspect }} Verdict
 * @typedef {{ passed: boolean }} ReadingResult
 * @typedef {{ needs: 'texts' | 'print' | null, carving: number, best: number, changes: SettingChange[] }} EngraveStep
 *   what an engraving needs to go on: the texts of the carving's pictures, or its print; null: the carving is the
 *   result. `carving`, `best`: number of the current carving and of the best so far, 0: none; `changes`: those of the
 *   attempt from the code as requested
 * @typedef {{ number: number, report: Report, seen: GreyImage | undefined }} Delivery
 *   a carving to show; `seen`: as a phone sees it; undefined for a text alone
 * @typedef {EngraveStep & { pictures: GreyImage[], delivery?: Delivery }} EngraveAnswer
 *   `pictures`: to decode, if it needs texts; `delivery`: the carving, if it does not
 * @typedef {ReadingResult & { more: boolean, report: Report }} PrintedResult
 *   result of a carving and its print; `more`: the engraving has another attempt to make; `report` includes the print
 * @typedef {{ tilts: { tiltDeg: number, reads: number, all: number }[], safeTiltDeg: number, forgiving: boolean,
 *   pixelsPerModule: number | null, distanceMm: number | null }} ViewTrials
 *   `tilts`: up to the first tilt at which nothing decodes; `forgiving`: decodes at every tilt of a phone held without
 *   care; `pixelsPerModule`: smallest module width that decodes; `distanceMm`: distance of a phone at that width
 * @typedef {{ done: boolean, tried: number, all: number, views: ViewTrials }} ViewTrialProgress
 */

/** The way that the dark modules are made. @typedef {'shadow' | 'inlay' | 'paint'} Mark */
/** The program that will open a 3MF file. @typedef {'any' | 'prusa' | 'orca' | 'bambu'} Slicer */
/**
 * Cost of the second colour. Waste is null where the printer changes no filaments.
 * @typedef {{ layers: number, changes: number, secondG: number, firstWasteG: number | null, secondWasteG: number | null,
 *   wasteMinutes: number | null, towerG: number | null }} ColourCost
 */

/**
 * The part of the report (core/report/report.h) that the page shows.
 * @typedef {object} Report
 * @property {string} text
 * @property {Mark} mark
 * @property {ColourCost} colour  all zero for a code of one colour
 * @property {'code' | 'text'} content
 * @property {{ version: number, ecc: string, modules: number } | null} symbol  null for a text alone
 * @property {{ symbolMm: number, moduleMm: number | null, guaranteedMm: number }} size
 * @property {{ capitalMm: number | null } | null} label  the label, or the text alone
 * @property {{ meanMm: number, maxMm: number, iterations: number, limitedSubmodules: number, features: CarvedFeatures }} depth
 *   of a code in colour and of a text alone only meanMm and maxMm
 * @property {{ triangles: number, closed: boolean, manifold: boolean, selfIntersections: number, volumeMm3: number }} mesh
 * @property {{ decoded: boolean | null, text?: string, failedChecks: Message[], verdict: Verdict, iso15415?: Grades, iso29158?: Grades }} verification
 *   of a text alone only the verdict
 *   `failedChecks`: why it does not pass, in the order solid, reads, prints
 * @property {{ eyeDistanceMm: number }} projection
 * @property {{ total: number } & Record<string, number>} timingsMs
 */

/**
 * A batch request. `settings`: shared by all rows; `text`, `name`: templates of text and file name, '' where the list
 * has a column for them; `count`: number of rows without a list, else 0; `perPlate`: rows per plate, 0: one file per
 * row.
 * @typedef {{ settings: Settings, text: string, name: string, count: number, perPlate: number, id?: string, hasNames?: boolean }} BatchRequest
 *   `id`: the column of the ids, if it is not called so; `hasNames`: whether the first row of a CSV table names its
 *   columns; by default it does unless it has a link
 * @typedef {{ name: string, cells: string[] }} BatchColumn  `cells`: in the first rows
 * @typedef {{ rows: number, problems: Message[], mayBeMore: boolean, unused: string[], columns: BatchColumn[], textNames: string[], warnings: Message[], version?: number, modules?: number }} BatchPlan
 *   no rows if there is a problem; `unused`: columns that are not used; `textNames`: names that the texts' template fills
 *   in; `warnings`: guesses of the reader, columns and
 *   cells with removed settings
 * @typedef {{ number: number, line: number, id: string, text: string, file: string }} BatchRowName
 * @typedef {BatchRowName & { settings: Partial<Settings> & Record<string, unknown> }} BatchRow
 *   `settings`: only the values that differ from the shared settings
 * @typedef {{ passed: boolean, failed: Message[], details: object }} DescribedRow  `failed`: failed checks
 * @typedef {{ number: number, id: string, text: string, file: string, second?: string, status: 'done' | 'failed',
 *   reason?: string, sha256: { input: string, settings: string, output?: string, second?: string } }} ManifestEntry
 *   plus `details` of DescribedRow; `second`: file with the body or the materials of the second colour
 */

/**
 * How the rows of a batch share files, and of which rows the print is simulated: every `printEvery`-th.
 * @typedef {{ rows: number, perPlate: number, printEvery: number }} BatchLayout
 * @typedef {'waiting' | 'running' | 'done' | 'failed'} RowState
 * @typedef {Record<RowState | 'finished', number> & { remainingMs: number | null, rows: TrackedRow[] }} BatchState
 * @typedef {{ state: RowState | 'all', skipped: number, count: number }} RowPage
 *   number of rows in each state; `finished`: done or failed; `remainingMs`: null before the first row of a run
 * @typedef {{ index: number, state: RowState, reason: string }} TrackedRow  `reason`: '' unless it failed
 * @typedef {{ index: number, print: boolean }} RowToCarve  `print`: simulate its print
 */

/**
 * Options of an engraving. `print`: look at prints, true by default; `fixed`: keys of settings that must not change;
 * `offers`: try other marks as remedies, false by default.
 * @typedef {{ print?: boolean, fixed?: string[], offers?: boolean }} EngraveOptions
 */

/** @typedef {{ order: object, stl: Uint8Array<ArrayBuffer> }} PrintJob  the carved model and the print order */
/**
 * A simulated print of a carved code.
 * @typedef {{ facingDeg: number, misread: [number, number][], pictures: GreyImage[], picture: GreyImage }} Print
 *   `facingDeg`: angle between the code's normal and the printer's vertical; `misread`: row and column of the modules
 *   lost in the print; `pictures`: for the decoder; `picture`: the symbol from the front with a border of 6 modules
 */

/** @typedef {{ process?: string, buildUp?: string }} PrintChange  as in settings files */
/**
 * Trials of other ways to print the same carving. `tried`: finished trials; `all`: number of trials planned;
 * `fraction`: progress of the current trial, absent at the end; `error`: reason of a failure.
 * @typedef {{ tried: { change: PrintChange, prints: Aspect }[], all: number, fraction?: number, error?: EngineError }} PrintTrials
 */

/**
 * State of the print of a carving.
 * @typedef {{ state: 'none' } | { state: 'made', print: Print, trials?: PrintTrials } | { state: 'under-way', fraction: number } | { state: 'stopped' } |
 *   { state: 'failed', error: EngineError }} Printed
 *   none: no print process is chosen
 */

/** An object of the module (embind), by verb. @typedef {Record<string, (...given: any[]) => any>} ModuleObject */

/**
 * A camera action; positions in CSS pixels of the canvas.
 * @typedef {{ kind: 'orbit', dx: number, dy: number } | { kind: 'pan', dx: number, dy: number }
 *   | { kind: 'zoom', factor: number, x: number, y: number } | { kind: 'fit' } | { kind: 'body', index: number }
 *   | { kind: 'readerView' } | { kind: 'face' }
 *   | { kind: 'standard', name: StandardView } | { kind: 'faceSection' } | { kind: 'faceConstruction' }} LookAction
 */

/**
 * An event that the camera leaves to the inspector.
 * @typedef {{ kind: 'pointer', x: number, y: number, buttons: number, wheel: number }
 *   | { kind: 'key', key: string, control: boolean, shift: boolean }} InputEvent
 */

/** An action in the view. @typedef {LookAction | InputEvent} ViewAction */

/**
 * An event for the inspector. `open`: its part of the module is loaded, and nothing is shown yet; comes before all
 * others; `texts`: translations, by English text; `area`: part of the canvas that no control covers.
 * @typedef {{ kind: 'open' } | { kind: 'show', shown: boolean } | { kind: 'texts', texts: Record<string, string> }
 *   | { kind: 'area' } & Area | { kind: 'pick', x: number, y: number } | InputEvent} InspectorEvent
 */

/**
 * Parts of the view to show or hide. `carved`: the carved model; `sizes`: the largest possible code sizes as colours;
 * `depths`: carved depths as colours; `buildPlate`: the printer's plate under the model; `construction`: how the code was placed; `lampLight`: the light of sky and lamps, if there are
 * lamps; `section`: offset of a section from the code's centre, -1 … 1, null: none; `dark`: dark colours; `upAxis`: the model's axis that points up, and along which the code's top points.
 * @typedef {{ carved?: boolean, sizes?: boolean, depths?: boolean, buildPlate?: boolean, construction?: boolean, lampLight?: boolean, section?: number | null, dark?: boolean,
 *   upAxis?: UpAxis }} Shown
 */

/** @typedef {{ width: number, height: number, devicePixelRatio: number }} ViewSize */

/** @typedef {[number, number, number, number]} Box  x, y, width, height */

/**
 * State of the inspector, for screen readers and tests: they cannot read its canvas.
 * @typedef {object} InspectorState
 * @property {string} tab
 * @property {string} channel
 * @property {number} pass      from 1; 0 before the first
 * @property {number} passes
 * @property {{ row: number, column: number, role: string, carved: boolean, LS: number, AL: number | null,
 *   G: number | null, depthMm: number | null, limitMm: number | null } | null} selected  submodule
 * @property {number} overridden     number of settings that differ from the page's
 * @property {string} overrides      these settings, in words
 * @property {number} engraveAsked   number of times "Engrave again" was pressed
 * @property {boolean} keyboard      true: it takes keyboard input
 * @property {string} cursor         CSS cursor; empty while the pointer is elsewhere
 * @property {string[][]} figures    the texts and numbers that it shows, in rows
 * @property {Box} window
 * @property {Record<string, Box>} controls
 * @property {boolean} still         true: its layout has settled
 */

/**
 * An event that the host sends to the page.
 * @typedef {{ event: 'progress', progress: EngraveProgress } | { event: 'view', state: ViewState } | { event: 'contextlost' }
 *   | { event: 'failure', error: EngineError } | { event: 'inspector', state: InspectorState }
 *   | { event: 'printable', job: PrintJob | null } | { event: 'search', search: SearchMaps }} HostEvent
 */

export {};
