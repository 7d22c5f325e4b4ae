// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of the study's figures, with sentences that the build chooses according to the data (study/figures).

export const figures = {
  en: {
    'model-plate': 'Plate',
    'model-pyramid': 'Pyramid',
    'model-cylinder': 'Cylinder',
    'model-saddle': 'Saddle',
    'model-star': 'Star',
    'model-vase': 'Vase',
    'model-bumpy-sphere': 'Bumpy sphere',
    'model-bunny': 'Bunny',
    'method-groove-2018': 'Kikuchi 2018',
    'method-self-shadow-2019': 'Peng 2019',
    'method-one-light-2020': 'Peng 2020',
    'method-tilted-2021': 'Papp 2021 (tilted)',
    'method-wavy-2021': 'Papp 2021 (wavy)',
    'method-papp-2022': 'Papp 2022',
    'method-papp-2022-whole-modules': 'Papp 2022 (whole)',
    'method-even-depth': 'Even depth',
    'method-ours-reading': 'QRelief (by reading)',
    'method-ours-one-light': 'QRelief (one light)',
    'method-ours-for-design': 'QRelief (design)',
    'method-ours-thick-plus': 'QRelief (patterned finders)',
    'method-ours-whole-modules': 'QRelief (whole)',
    'method-ours': 'QRelief (default)',
    'direction-mean-normal': 'Mean of normals',
    'direction-depth-balanced': 'Balanced depth',
    'direction-pca': 'Principal components',
    'direction-optimal': 'Best',
    'size-guaranteed_mm': 'At every rotation',
    'size-upright_mm': 'Upright',
    'size-turned_45_mm': 'Turned by 45°',
    'pattern-none': 'Whole',
    'pattern-square': 'Square',
    'pattern-thin-plus': 'Thin plus',
    'pattern-diamond': 'Diamond',
    'pattern-thick-plus': 'Thick plus',
    'finder-as-modules': 'As the modules',
    'finder-none': 'Whole',
    'finder-diamond': 'Diamond',
    'finder-thick-plus': 'Thick plus',
    'finder-thick-plus-sharp': 'Thick plus, sharp',
    'carvedAt-sky': 'Engraved for the sky alone',
    'carvedAt-8': 'Lamp at 8°',
    'carvedAt-33': 'Lamp at 33°',
    'search-self-shadow-2019': 'Search of Peng 2019',
    'search-papp-2022': 'Search of Papp 2022',
    'search-ours': 'Search of QRelief',
    'flips-none': 'No flips',
    'flips-peng-2019': 'Peng 2019',
    'flips-ours': 'QRelief',
    'process-fdm-0.4/0.2': 'Nozzle 0.4 mm',
    'process-fdm-0.25/0.1': 'Nozzle 0.25 mm',
    'pose-code-up': 'lying',
    'pose-code-upright': 'standing',
    'decoder-jsqr': 'jsQR',
    'decoder-@zxing/library': 'ZXing (JS)',
    'decoder-zxing-wasm': 'ZXing-C++',
    'decoder-qr': 'qr',
    'decoder-@undecaf/zbar-wasm': 'ZBar',
    'layout-projected': 'Projected, as engraved',
    'layout-halfway': 'Half-way',
    'layout-wrapped': 'Wrapped like a label',
    carvingOurs: 'QRelief',
    legendFinders: 'Finder patterns',
    carvingPattern: '{modules} / {finders}',
    printAs: '{process}, {pose}',

    axisDepth: 'mean depth, mm',
    axisEdge: 'edge of the code, mm',
    axisLamps: 'lamps',
    axisLamp: 'elevation of the reading lamp, °',
    axisReads: 'reads of {of}',
    axisErrorSize: 'error of the light, size',
    axisError: 'error of the light, own − traced',
    axisSeconds: 'seconds',
    axisBlur: 'blur, modules',
    axisPixels: 'pixels per module',
    axisTilt: 'tilt, °',
    axisModule: 'smallest module, mm',
    axisArc: 'arc of the code, °',
    axisAside: 'read up to, °',

    asIs: '{value}',
    onAllModels: 'on all {of} models',
    onSomeModels: 'on {holds} of {of} models',
    onNoModel: 'on none of the {of} models',
    inAllCases: 'in all {of} cases',
    inSomeCases: 'in {holds} of {of} cases',
    inNoCase: 'in none of {of} cases',
    download: { one: 'Table with {count} row, CSV', other: 'Table with {count} rows, CSV' },
    failed: {
      one: '{count} of {of} cases could not be engraved and is left out.',
      other: '{count} of {of} cases could not be engraved and are left out.',
    },
    notMeasured: 'This table has not been measured yet, so there is no figure.',

    leastModuleAlt:
      'Four plots, for two nozzles lying and standing: the smallest module that reads, by module pattern and finder pattern.',
    leastModuleShown:
      'The smallest module that reads as printed, on a plate, for each module pattern and finder pattern; figure 11 of the paper.',
    leastOne:
      '{process}: the smallest module that reads is {module} mm wide, {pose} (modules: {pattern}, finders: {finders}).',
    leastThick:
      'In the paper thick plus has the smallest modules and thin plus the largest; here the modules of thick plus are at least as small as the modules of thin plus {thin}.',
    leastFinders:
      'In the paper whole finders also allow smaller modules than finders in the pattern of the modules; here their modules are at least as small {cases}.',
    leastPrint:
      'Modules can be at least as small standing as lying {standing}, and at least as small with the finer nozzle {finer}.',
    leastUnread: {
      one: '{count} of {of} combinations does not read even at the largest module.',
      other: '{count} of {of} combinations do not read even at the largest module.',
    },
    leastPaper:
      'The authors tried a few sizes on real prints and removed strings by hand; here sizes shrink in steps of a tenth, and the simulated print has no strings.',

    guaranteedSizeAlt:
      'Three plots of the edge of the largest code on each model, by the method that finds its direction: at every rotation, upright, and turned by 45 degrees.',
    guaranteedSizeShown:
      'Edge of the largest code without its quiet zone, which must fit as well; figures 13 and 14 of the paper.',
    sizesSame:
      'If depth counts in addition to the normals, the size at every rotation changes by less than {percent} % {cases}.',
    sizesMost: 'It helps most on the model “{model}”, by {percent} %.',
    sizesLeast: 'On the model “{model}” it costs {percent} %.',
    sizesOptimal:
      '“Best” looks for the direction with the least distorted code, not the largest code; its code is the largest of the four {cases}.',
    sizesTurned: 'A code at a fixed rotation can be {times} times as large, in the median.',
    sizesPaper:
      'In the paper the depth allows larger codes on strongly curved places and makes no difference on flat or wavy places; its models and places differ from ours.',

    patternDepthsAlt: 'A plot for each model: mean depth by module pattern, a marker for each finder pattern.',
    patternDepthsShown:
      'Mean engraved depth, by module pattern (rows) and finder pattern (markers), found by the published steps at our default contrast; figures 15 and 16 of the paper.',
    patternsLoose:
      'The modules of two patterns, square and thin plus, do not connect. These patterns are the shallowest {cases} if the finders have the pattern of the modules, {whole} with whole finders, and {thick} with thick-plus finders. In the paper they are the shallowest on every model.',
    patternsDiamond:
      'The paper recommends diamond finders. Here codes with these finders read {cases} as designed and {printed} as printed.',
    patternsBest:
      'In the paper thin plus is the shallowest of all patterns, and thick plus the deepest of the four; here thin plus is the shallowest {best}, and thick plus the deepest {last}.',
    patternsFinders:
      'The paper’s finder patterns, diamond and thick plus, make codes shallower than whole finders {cases}; the two differ by at most {apart} mm.',
    patternsWhole:
      'Finders in the pattern of the modules make codes unreadable in the paper. Here such codes read {cases} as designed and {printed} as printed.',
    patternsReads:
      'Shallower is not better: as printed the median number of reads is {thin} for thin plus, {square} for square, {diamond} for diamond, {thick} for thick plus and {whole} for whole modules.',

    methodDepthsAlt: 'A row for each method: mean depth on each model as a dot, the median as a bar.',
    methodDepthsShown:
      'Mean depth by method, each at its published setting, ours at its default. A dot is a model, the bar their median; figure 20 of the paper.',
    methodsOrder:
      'The paper’s order, Peng 2020 shallowest, then Papp 2022, then Peng 2019, holds {cases}; the medians are {light}, {papp} and {shadow} mm.',
    methodsHalf:
      'Peng 2020 engraves {middle} times as deep as Peng 2019 in the median, {least} to {most} times; the paper says about half.',
    methodsWhole:
      'In the paper its search without patterns is about as deep as Peng 2019. Here this holds {cases}, within {percent} %; in the median Peng 2019 engraves {times} times as deep.',
    methodsWhy:
      'The methods stop at different darkness. Peng’s limit is a fifth of a grey scale that was fitted to photographs, which requires much more contrast than a fifth of the light. Our limit, used here for Papp 2022 too, is a fraction of the light itself, computed for the exact sky with the light that the walls reflect. Floors are steps here, not the meshes of the originals.',
    methodsLamp:
      'Under their lamp, as designed, codes for one lamp read {peng} if engraved by Peng 2020 and {ours} if engraved by QRelief: a low lamp lights curved surfaces unevenly and does not reach surfaces that slope steeply away from it.',
    methodsAllRead: 'As printed every method reads in the median.',
    methodsUnread: 'As printed these methods do not read in the median: {list}.',

    frontierPrintedAlt:
      'A plot for each model: reads as printed against mean depth, a line for each method from shallow to deep.',
    frontierPrintedShown:
      'Reads as printed against mean depth, a line for each method from its shallowest to its deepest setting; the thick line is the app. The depth is on a logarithmic scale; dashes mark the reads that a code needs.',
    frontierDefault:
      'At no greater depth, our default reads at least as often as the best of the other methods for the sky {cases}; reads between the settings of a method are interpolated.',
    frontierFinders:
      'Our default engraves thick pluses and whole finders. At no greater depth, its codes read at least as often as codes with patterned finders {cases}.',
    frontierLost: 'These read more often at no greater depth: {list}.',
    frontierBy: '{method} {cases}',
    frontierLamp: 'Peng 2020, decoded under its own lamp, reads more often at no greater depth {cases}.',
    frontierShallowest:
      'Under the sky the shallowest engraving that reaches {needed} of {tries} reads is ours {cases}.',
    frontierPaper:
      'The paper compares depths at one setting of each method. A shallow code that does not read is worth little, so this figure shows both reads and depth.',
    equalDepthAlt: 'A row for each method: reads as printed of every model and text, with a bar at the median.',
    equalDepthShown:
      'Reads as printed with several texts on each model; every method engraves as deep on average as the app engraves that model.',
    equalDepthOthers: 'By the median over {texts} texts, no other method reads more often than our default {cases}.',
    equalDepthList: 'Medians over the models, of the medians over the texts: our default {reads}; {list}.',
    equalDepthBy: '{method} {reads} (more often than the default {cases})',
    equalDepthSpread:
      'From text to text the reads of one method on one model differ by {spread} tries (median of the differences between most and fewest), so a single text proves little.',
    frontierDesignedAlt:
      'A plot for each model: reads as designed against mean depth, a line for each method from shallow to deep.',
    frontierDesignedShown: 'As above, for the surface as designed.',
    frontierLostInPrint: 'Of the {of} engravings that read as designed, {holds} do not read as printed.',

    searchTimesAlt:
      'A row for each method: time of the search on each model as a dot, the median as a bar, on a logarithmic scale.',
    searchTimesShown: 'Time to find the depths; a dot is a model, the bar their median, the scale is logarithmic.',
    timesRange: '{fastest} is the fastest with {least} s in the median, {slowest} the slowest with {most} s.',
    timesPaperHolds:
      'The paper says that its search takes a fraction of the time of Peng’s search. This holds here: {papp} s and {peng} s.',
    timesPaperFails:
      'The paper says that its search takes a fraction of the time of Peng’s search. This does not hold here: {papp} s and {peng} s.',
    timesWhy:
      'These are rough times of our programs, measured during other work on a machine without a graphics card. Papp’s search and ours draw in software there; the searches of Peng and Kikuchi trace rays, Peng 2019 far fewer rays than the original.',

    lightErrorsAlt:
      'Two plots with a row for each method: the difference between its own estimate of the light and path tracing, by size and with sign.',
    lightErrorsShown:
      'Difference between the light that a method estimates on the engraved submodules and path tracing on the engraved mesh, as a fraction of the light on a free surface. Negative: the method estimates too little light.',
    errorsRange:
      '{least} is the most accurate with {leastError} in the median, {most} the least accurate with {mostError}.',
    errorsOursDark: 'QRelief is off by {size}, and on average estimates the pockets too dark by {mean}.',
    errorsOursBright: 'QRelief is off by {size}, and on average estimates the pockets too bright by {mean}.',
    errorsWhy:
      'Kikuchi and Peng 2019 measure the visible part of the sky, which is a different quantity from light and not an error of their programs. Papp 2021, Papp 2022 and the even depth use our model of the light here. Codes for one lamp are traced under that lamp. The paper has no such comparison.',

    lampDepthsAlt:
      'A plot for each model: mean depth with no lamp, one and two, for square modules and for whole modules.',
    lampDepthsShown:
      'Mean depth by the number of lamps, each as strong as the sky and 33° above the code, found by the published steps; figure 21 of the paper.',
    lampsPattern:
      'With square modules each lamp makes the code deeper {cases}: {none} mm under the sky alone, {one} with one lamp, {two} with two, in the median.',
    lampsWhole: 'With whole modules each lamp makes the code shallower {cases}: {none}, {one} and {two} mm.',
    lampsWhy:
      'In the paper both hold on all models. The effect of a lamp depends on how much of its light the walls keep off the floors and how bright it makes the light modules, and so on its strength, which the paper does not give.',

    lightAnglesAlt:
      'Two plots, for whole and for square modules: reads against the elevation of the reading lamp, a line for each light that the code was engraved for.',
    lightAnglesShown:
      'Reads of codes on a plate under the sky and one lamp, by the elevation of that lamp above the code. Each line is a light that the code was engraved for; figure 22 of the paper.',
    anglesWhole:
      'Whole modules engraved for a lamp at {oneAt}° read {one}; whole modules engraved for a lamp at {otherAt}° read {other}.',
    anglesPaper:
      'In the paper these codes tolerate a lamp up to {oneHigher}° and {otherHigher}° higher ({onePaper}° and {otherPaper}° in its measure) and any lower lamp. Here the first holds {higher} and the second {lower}; with the lamp that they were engraved for they read {own}.',
    anglesPattern:
      'Square modules engraved for these lamps read {one} and {other}; in the paper no code with patterns that was engraved for a lamp could be read.',
    anglesWith: 'with lamps at {list}',
    anglesFromTo: { one: '{from}°', other: '{from}° to {to}°' },
    anglesNone: 'with none of the lamps tried',
    anglesWhy:
      'Our lamp is as strong as the sky. The paper does not give the strength of its lamp, and one app decoded rendered pictures at some angles.',

    robustnessAlt:
      'Three plots with a row for each kind of engraving: the most blur, the fewest pixels per module and the largest tilt at which it reads.',
    robustnessShown:
      'By module pattern / finder pattern: the most blur (standard deviation in modules), the fewest pixels per module and the largest tilt with which a code still reads, as designed; section 8 of the paper.',
    robustPairs:
      'Of two patterns, the pattern that engraves more tolerates at least as much blur in {holds} of {of} pairs, finders and models taken together.',
    robustBlur: 'Medians of the blur in modules: {list}.',
    robustOf: '{pattern} {blur}',
    robustOurs: 'QRelief with thick pluses tolerates {blur} modules of blur and {tilt}° of tilt in the median.',
    robustUnread: {
      one: '{count} of {of} engravings does not read even from the front and is not shown.',
      other: '{count} of {of} engravings do not read even from the front and are not shown.',
    },
    robustPaper:
      'In the paper codes tolerate less if less is engraved, but only a little less: its app took a second or two longer. Here a picture either reads or does not, so small losses show as well.',

    asideAlt:
      'A plot for each decoder: the largest angle at which codes read, against the arc of the cylinder that they take, a line for each layout.',
    asideShown:
      'The largest angle to the side at which npm decoders read painted codes on a cylinder, by the arc of the circumference that the codes take: medians over all versions. The codes are projected, as QRelief engraves them, wrapped round the cylinder like a label, or half-way between. A point is missing where half of the versions or more do not read even from the front.',
    asideArcs:
      'Projected codes that take {narrow}° of the circumference read {narrowTilt}, and codes that take {wide}° read {wideTilt}, in the median of all decoders and versions.',
    asideUpTo: 'up to {tilt}° to the side',
    asideOnlyFront: 'only from the front',
    asideUnread: 'not even from the front',
    asideLayouts:
      'Projected codes read at least as far to the side as wrapped codes {cases} in which either of them reads.',
    asideFront:
      'From the front, projected codes read {projected}, half-way codes {halfway} and wrapped codes {wrapped}.',
    asideMarks:
      'From version {version} on, a code has six alignment patterns instead of one, which show how it bends. At every arc these codes read farther to the side by {list}.',
    asidePaper:
      'The codes are painted, so the figure shows the effect of the bent surface alone, whatever the engraving. The paper has no such experiment.',

    lampStrengthsAlt:
      'Two plots, for whole and for square modules: mean depth against the strength of one lamp, a line for each elevation and one for the sky alone.',
    lampStrengthsShown:
      'Mean depth of a code on a plate that is engraved for one lamp, by the strength of the lamp (1: as strong as the sky) and its elevation above the code.',
    lampAt: 'Lamp at {elevation}°',
    skyAlone: 'Sky alone',
    degrees: '{elevation}°',
    millimetres: '{width} mm',
    moduleOf: 'Modules of {width} mm',
    axisStrength: 'strength of the lamp',
    axisContrast: 'contrast',
    axisGreatestDepth: 'maximum depth, mm',
    strengthsSides:
      '{pattern} modules become shallower than under the sky alone with a lamp at {shallower} and deeper with one at {deeper}, whatever its strength.',
    strengthsWhy:
      'The elevation matters, not the strength. The paper’s lamp is at {elevation}°, between the two, where small differences in the light decide.',

    contrastSweepAlt:
      'A plot for each of two models: mean depth against contrast, a line for each module pattern, and dashed lines at the depths of Peng 2019 and Peng 2020.',
    contrastSweepShown:
      'Mean depth by contrast and module pattern, found by the published steps. Dashed lines: the depths of Peng 2019 and Peng 2020 at their published settings.',
    sweepReaches: '{model}: whole modules become as deep as the modules of Peng 2019 at a contrast of {contrast}.',
    sweepNever: '{model}: whole modules stay shallower than the modules of Peng 2019 at every contrast tried.',
    sweepOrder:
      'The order of the paper, Peng 2020, then all patterns, then Peng 2019, holds at contrasts from {least} to {most}.',
    sweepOrderOnce:
      'The order of the paper, Peng 2020, then all patterns, then Peng 2019, holds only at a contrast of {least}.',
    sweepWhy: 'The paper does not give the contrast of its figure 20.',
    sweepNoOrder: 'The order of the paper, Peng 2020, then all patterns, then Peng 2019, holds at no contrast tried.',

    paperModuleAlt:
      'Two plots with a row for each method: mean depth and reads as printed of every model, with a bar at the median.',
    paperModuleShown:
      'Mean depth and reads as printed of every method at its published setting, with modules of 1.2 mm as in the paper’s prints; a dot is a model, the bar their median.',
    paperModuleReads:
      'With modules of 1.2 mm our default reads in {reads} tries as printed, at a depth of {depth} mm, in the median.',
    paperModuleOthers: 'The other methods for the sky: {list}.',
    paperModuleOther: '{method} {reads} at {depth} mm',
    paperModuleDefault: 'No other method reads more often than our default at no greater depth: this holds {cases}.',

    defaultChoiceAlt:
      'Plots for four module widths: reads as printed against mean depth, and against maximum depth, a marker for each pattern tried. A circle marks the default.',
    defaultChoiceShown:
      'Reads as printed against mean depth (above) and maximum depth (below) of the settings that remained after a search of 59 random draws, on the four models that were not used to choose the default: means of lying, upright and slanted prints. The circle marks the default; markers are module pattern / finder pattern.',
    choiceReads: 'On these four models the default reads in {list}.',
    choiceReadsAt: '{reads} tries at {depth} mm with modules of {width} mm',
    choiceFrontier: 'No other choice reads more often at no greater mean depth on {list}.',
    choiceFrontierAt: '{holds} of {of} models with modules of {width} mm',
    choiceOthers: 'Without diamonds this holds on {list}.',
    choiceBetter: '{pattern} modules with finders “{finders}” read more often on average with modules of {list}.',
    choiceWhy:
      'Diamonds are still not the default. On average 3.1 of five decoder families decoded each of nine diamond prints made from a slicer’s toolpaths; 3.8 families decoded the prints with the previous default. A single decoder makes all tries here.',

    claimPaper: 'The paper says',
    claimHere: 'Here',
    claimFigure: 'Figure',
    claimNotMeasured: 'Not measured yet.',
    claimHolds: 'Yes, {cases}',
    claimInPart: 'In part, {cases}',
    claimFails: 'No, {cases}',
    claimThickModule: 'Thick pluses read at smaller modules than thin ones.',
    claimFinderModule: 'Whole finders allow smaller modules than finders in the pattern of the modules.',
    claimSize: 'On curved models depth makes the largest code larger than normals alone do (here: by 2 % or more).',
    claimLoose: 'Squares and thin pluses, which do not connect, need the least depth.',
    claimThinPlus: 'Thin pluses need the least depth of all patterns.',
    claimThickPlus: 'Thick pluses need the most depth of all patterns.',
    claimFinders: 'Finders with their own pattern need less depth than whole finders.',
    claimFindersUnread: 'Codes whose finders have the pattern of the modules do not read.',
    claimOrder: 'Peng 2020 engraves shallowest, then come the paper’s patterns, then Peng 2019.',
    claimWhole: 'Whole modules are about as deep as the modules of Peng 2019.',
    claimTime: 'The search takes less time than the searches of Peng 2019 and 2020.',
    claimLampPattern: 'Lamps make codes with patterns deeper.',
    claimLampWhole: 'Lamps make codes with whole modules shallower.',
    claimAngles: 'A code engraved for a lamp reads under a lamp that is 15° to 30° higher.',
    claimRobust: 'Patterns that engrave more tolerate at least as much blur.',
    'section-module': 'Smallest module',
    'section-size': 'Sizes',
    'section-patterns': 'Patterns',
    'section-methods': 'Methods',
    'section-time': 'Times',
    'section-lamps': 'Lamps',
    'section-angles': 'Another lamp',
    'section-robust': 'Blur',

    percent: '{value}\u00a0%',
    ratesShown:
      'CarvedQR has {pictures} pictures of engraved codes, drawn from wide ranges of text, pattern, depth, size, print, lamp and camera; many are hard, and some cannot be decoded. Each decoder gets each picture once, with its own thorough settings.',
    ratesWrong: {
      one: '{count} text in all was wrong. The table gives the share that each decoder reads.',
      other: '{count} texts in all were wrong. The table gives the share that each decoder reads.',
    },
    ratesDecoder: 'Decoder',
    ratesDesigned: 'as designed',
    ratesPrinted: 'as printed',
    ratesSky: 'sky',
    ratesLamp: 'sky and lamp',
    ratesFront: 'from the front',
    ratesTilted: 'tilted to 20°',
    ratesSteep: 'tilted to 45°',
    ratesNone: '–',

    galleryDefault: 'By default',
    galleryLamp: 'For a lamp at 33°',
    galleryPatterns: 'Every pattern of modules and finders',
    galleryDesigned: 'As designed',
    galleryPrinted: 'As printed',
    galleryFacts: '{depth} mm deep; {reads} of {tries} tries decode the design, {printed} the print',
    galleryMissing: 'This build has no pictures: script/gallery makes them.',

    symbolFlipsAlt:
      'Two plots, for the search of 2019 and for ours: mean depth without flips, with the flips of Peng 2019 and with ours, a marker for each model.',
    symbolFlipsShown:
      'Mean depth of whole modules at error correction H, when dark modules in wide dark areas are flipped to light and decoders restore them.',
    flipsCount:
      'Peng 2019 flips {peng} modules to light and QRelief {ours}, as QRelief spends more of the error correction.',
    flipsSaved:
      'With the search of 2019 these flips make codes shallower by {peng2019} % and {ours2019} %, with our search by {peng} % and {ours} %, in the median.',
    flipsReads:
      'As printed the reads change by at most {tries}, in the median, but the spent error correction no longer protects against dirt and damage.',
  },
  de: {
    'model-plate': 'Platte',
    'model-pyramid': 'Pyramide',
    'model-cylinder': 'Zylinder',
    'model-saddle': 'Sattel',
    'model-star': 'Stern',
    'model-vase': 'Vase',
    'model-bumpy-sphere': 'Wellige Kugel',
    'model-bunny': 'Hase',
    'method-groove-2018': 'Kikuchi 2018',
    'method-self-shadow-2019': 'Peng 2019',
    'method-one-light-2020': 'Peng 2020',
    'method-tilted-2021': 'Papp 2021 (geneigt)',
    'method-wavy-2021': 'Papp 2021 (wellig)',
    'method-papp-2022': 'Papp 2022',
    'method-papp-2022-whole-modules': 'Papp 2022 (ganz)',
    'method-even-depth': 'Gleiche Tiefe',
    'method-ours-reading': 'QRelief (nach Lesung)',
    'method-ours-one-light': 'QRelief (eine Lampe)',
    'method-ours-for-design': 'QRelief (Entwurf)',
    'method-ours-thick-plus': 'QRelief (Suchmuster gemustert)',
    'method-ours-whole-modules': 'QRelief (ganz)',
    'method-ours': 'QRelief (üblich)',
    'direction-mean-normal': 'Mittel der Normalen',
    'direction-depth-balanced': 'Ausgeglichene Tiefe',
    'direction-pca': 'Hauptkomponenten',
    'direction-optimal': 'Beste',
    'size-guaranteed_mm': 'In jeder Drehung',
    'size-upright_mm': 'Aufrecht',
    'size-turned_45_mm': 'Um 45° gedreht',
    'pattern-none': 'Ganz',
    'pattern-square': 'Quadrat',
    'pattern-thin-plus': 'Dünnes Plus',
    'pattern-diamond': 'Raute',
    'pattern-thick-plus': 'Dickes Plus',
    'finder-as-modules': 'Wie die Module',
    'finder-none': 'Ganz',
    'finder-diamond': 'Raute',
    'finder-thick-plus': 'Dickes Plus',
    'finder-thick-plus-sharp': 'Dickes Plus, eckig',
    'carvedAt-sky': 'Nur für den Himmel graviert',
    'carvedAt-8': 'Lampe auf 8°',
    'carvedAt-33': 'Lampe auf 33°',
    'search-self-shadow-2019': 'Suche von Peng 2019',
    'search-papp-2022': 'Suche von Papp 2022',
    'search-ours': 'Suche von QRelief',
    'flips-none': 'Keine',
    'flips-peng-2019': 'Peng 2019',
    'flips-ours': 'QRelief',
    'process-fdm-0.4/0.2': 'Düse 0,4 mm',
    'process-fdm-0.25/0.1': 'Düse 0,25 mm',
    'pose-code-up': 'liegend',
    'pose-code-upright': 'stehend',
    'decoder-jsqr': 'jsQR',
    'decoder-@zxing/library': 'ZXing (JS)',
    'decoder-zxing-wasm': 'ZXing-C++',
    'decoder-qr': 'qr',
    'decoder-@undecaf/zbar-wasm': 'ZBar',
    'layout-projected': 'Projiziert, wie graviert',
    'layout-halfway': 'Dazwischen',
    'layout-wrapped': 'Gewickelt wie ein Etikett',
    carvingOurs: 'QRelief',
    legendFinders: 'Suchmuster',
    carvingPattern: '{modules} / {finders}',
    printAs: '{process}, {pose}',

    axisDepth: 'mittlere Tiefe, mm',
    axisEdge: 'Kante des Codes, mm',
    axisLamps: 'Lampen',
    axisLamp: 'Höhe der Leselampe, °',
    axisReads: 'gelesen von {of}',
    axisErrorSize: 'Fehler des Lichts, Betrag',
    axisError: 'Fehler des Lichts, eigenes − verfolgtes',
    axisSeconds: 'Sekunden',
    axisBlur: 'Unschärfe, Module',
    axisPixels: 'Pixel je Modul',
    axisTilt: 'Neigung, °',
    axisModule: 'kleinstes Modul, mm',
    axisArc: 'Bogen des Codes, °',
    axisAside: 'gelesen bis, °',

    asIs: '{value}',
    onAllModels: 'bei allen {of} Modellen',
    onSomeModels: 'bei {holds} von {of} Modellen',
    onNoModel: 'bei keinem der {of} Modelle',
    inAllCases: 'in allen {of} Fällen',
    inSomeCases: 'in {holds} von {of} Fällen',
    inNoCase: 'in keinem von {of} Fällen',
    download: { one: 'Tabelle mit {count} Zeile, CSV', other: 'Tabelle mit {count} Zeilen, CSV' },
    failed: {
      one: '{count} von {of} Fällen ließ sich nicht gravieren und fehlt.',
      other: '{count} von {of} Fällen ließen sich nicht gravieren und fehlen.',
    },
    notMeasured: 'Diese Tabelle ist noch nicht gemessen, deshalb fehlt die Abbildung.',

    leastModuleAlt:
      'Vier Diagramme, zu zwei Düsen, liegend und stehend: das kleinste lesbare Modul nach Modulmuster und Suchmuster.',
    leastModuleShown:
      'Das kleinste Modul, das sich im Druck lesen lässt, auf einer Platte, nach Modulmuster und Suchmuster; Abbildung 11 des Artikels.',
    leastOne:
      '{process}: Das kleinste lesbare Modul ist {module} mm groß, {pose} (Module: {pattern}, Suchmuster: {finders}).',
    leastThick:
      'Im Artikel hat das dicke Plus die kleinsten Module und das dünne die größten; hier sind die Module des dicken Plus {thin} mindestens so klein wie die Module des dünnen.',
    leastFinders:
      'Auch erlauben dort ganze Suchmuster kleinere Module als Suchmuster im Muster der Module; hier sind ihre Module {cases} mindestens so klein.',
    leastPrint: 'Stehend sind die Module {standing} mindestens so klein wie liegend, mit der feineren Düse {finer}.',
    leastUnread: {
      one: '{count} von {of} Kombinationen ist selbst mit dem größten Modul nicht lesbar.',
      other: '{count} von {of} Kombinationen sind selbst mit dem größten Modul nicht lesbar.',
    },
    leastPaper:
      'Für den Artikel wurden einige Größen wirklich gedruckt und Fäden von Hand entfernt; hier schrumpfen die Größen um je ein Zehntel, und der Druck ist ohne Fäden simuliert.',

    guaranteedSizeAlt:
      'Drei Diagramme zur Kante des größten Codes auf jedem Modell, je nachdem, wie die Richtung gefunden wird: in jeder Drehung, aufrecht und um 45 Grad gedreht.',
    guaranteedSizeShown:
      'Kante des größten Codes ohne seine Ruhezone, die auch passen muss; Abbildungen 13 und 14 des Artikels.',
    sizesSame:
      'Zählt neben den Normalen auch die Tiefe, ändert sich die Größe in jeder Drehung {cases} um weniger als {percent} %.',
    sizesMost: 'Am meisten hilft es beim Modell „{model}“, um {percent} %.',
    sizesLeast: 'Beim Modell „{model}“ kostet es {percent} %.',
    sizesOptimal:
      '„Beste“ sucht die Richtung mit dem am wenigsten verzerrten Code, nicht mit dem größten; {cases} ist ihr Code dennoch der größte der vier.',
    sizesTurned: 'Ein Code in einer festen Drehung kann im Median {times}-mal so groß sein.',
    sizesPaper:
      'Im Artikel erlaubt die Tiefe an stark gekrümmten Stellen größere Codes und ändert an flachen oder welligen nichts; seine Modelle und Stellen sind andere als unsere.',

    patternDepthsAlt: 'Ein Diagramm je Modell: mittlere Tiefe nach Modulmuster, ein Zeichen je Suchmuster.',
    patternDepthsShown:
      'Mittlere Tiefe der Gravur nach Modulmuster (Zeilen) und Suchmuster (Zeichen), mit den veröffentlichten Schritten und unserem üblichen Kontrast gefunden; Abbildungen 15 und 16 des Artikels.',
    patternsLoose:
      'Die Module zweier Muster, Quadrat und dünnes Plus, hängen nicht zusammen. Diese Muster sind {cases} die flachsten, wenn die Suchmuster das Muster der Module haben, {whole} mit ganzen Suchmustern und {thick} mit Suchmustern aus dicken Plus. Im Artikel sind sie es bei jedem Modell.',
    patternsDiamond:
      'Der Artikel empfiehlt Rauten als Suchmuster. Hier werden Codes damit {cases} im Entwurf und {printed} im Druck gelesen.',
    patternsBest:
      'Im Artikel ist das dünne Plus das flachste aller Muster und das dicke das tiefste der vier; hier ist das dünne {best} das flachste, das dicke {last} das tiefste.',
    patternsFinders:
      'Die Suchmuster des Artikels, Raute und dickes Plus, machen Codes {cases} flacher als ganze Suchmuster; untereinander unterscheiden sie sich um höchstens {apart} mm.',
    patternsWhole:
      'Mit Suchmustern im Muster der Module ist im Artikel kein Code lesbar. Hier sind solche Codes {cases} im Entwurf und {printed} im Druck lesbar.',
    patternsReads:
      'Flacher ist nicht besser: Im Druck werden im Median {thin} Versuche beim dünnen Plus gelesen, {square} beim Quadrat, {diamond} bei der Raute, {thick} beim dicken Plus und {whole} bei ganzen Modulen.',

    methodDepthsAlt: 'Eine Zeile je Verfahren: die mittlere Tiefe auf jedem Modell als Punkt, der Median als Strich.',
    methodDepthsShown:
      'Mittlere Tiefe nach Verfahren, jedes mit seiner veröffentlichten Einstellung, unseres mit seiner üblichen. Ein Punkt ist ein Modell, der Strich der Median; Abbildung 20 des Artikels.',
    methodsOrder:
      'Die Reihenfolge des Artikels, Peng 2020 am flachsten, dann Papp 2022, dann Peng 2019, gilt {cases}; die Mediane sind {light}, {papp} und {shadow} mm.',
    methodsHalf:
      'Peng 2020 graviert im Median {middle}-mal so tief wie Peng 2019, {least}- bis {most}-mal; nach dem Artikel etwa halb so tief.',
    methodsWhole:
      'Im Artikel graviert seine Suche ohne Muster etwa so tief wie Peng 2019. Auf {percent} % genau gilt das {cases}: Im Median graviert Peng 2019 {times}-mal so tief.',
    methodsWhy:
      'Die Verfahren hören bei verschiedener Dunkelheit auf. Pengs Grenze ist ein Fünftel einer Grauskala, die an Fotos angepasst wurde; sie verlangt viel mehr Kontrast als ein Fünftel des Lichts. Unsere Grenze, die hier auch für Papp 2022 gilt, ist ein Anteil am Licht selbst, berechnet für den genauen Himmel und mit dem Licht, das die Wände zurückwerfen. Die Böden sind hier Stufen und nicht die Netze der Originale.',
    methodsLamp:
      'Unter ihrer Lampe sind Codes für eine Lampe im Entwurf {peng} lesbar, wenn Peng 2020 sie graviert, und {ours}, wenn QRelief sie graviert: Eine niedrige Lampe beleuchtet gewölbte Flächen ungleichmäßig und Flächen, die steil von ihr abfallen, gar nicht.',
    methodsAllRead: 'Im Druck ist jedes Verfahren im Median lesbar.',
    methodsUnread: 'Im Druck sind diese Verfahren im Median nicht lesbar: {list}.',

    frontierPrintedAlt:
      'Ein Diagramm je Modell: gelesene Versuche im Druck über der mittleren Tiefe, eine Linie je Verfahren von flach bis tief.',
    frontierPrintedShown:
      'Gelesene Versuche im Druck über der mittleren Tiefe, eine Linie je Verfahren von der flachsten bis zur tiefsten Einstellung; die dicke Linie ist die App. Die Tiefe ist logarithmisch aufgetragen; gestrichelt ist die Zahl der Versuche, die ein Code braucht.',
    frontierDefault:
      'Mit unserer üblichen Einstellung wird {cases} mindestens so oft gelesen wie mit dem besten der anderen Verfahren für den Himmel bei höchstens gleicher Tiefe; zwischen den Einstellungen eines Verfahrens wird interpoliert.',
    frontierFinders:
      'Üblich sind dicke Plus und ganze Suchmuster. Solche Codes werden {cases} bei höchstens gleicher Tiefe mindestens so oft gelesen wie Codes mit gemusterten Suchmustern.',
    frontierLost: 'Bei höchstens gleicher Tiefe werden öfter gelesen: {list}.',
    frontierBy: '{method} {cases}',
    frontierLamp: 'Mit Peng 2020, unter der eigenen Lampe, wird bei höchstens gleicher Tiefe {cases} öfter gelesen.',
    frontierShallowest:
      'Unter dem Himmel ist die flachste Gravur, die {needed} von {tries} Versuchen erreicht, {cases} eine von unseren.',
    frontierPaper:
      'Der Artikel vergleicht Tiefen bei einer Einstellung je Verfahren. Ein flacher Code, der sich nicht lesen lässt, nützt wenig; deshalb zeigt diese Abbildung Lesbarkeit und Tiefe.',
    equalDepthAlt:
      'Eine Zeile je Verfahren: gelesene Versuche im Druck von jedem Modell und Text, mit einem Strich beim Median.',
    equalDepthShown:
      'Gelesene Versuche im Druck mit mehreren Texten je Modell, jedes Verfahren im Mittel so tief graviert, wie die App dieses Modell graviert.',
    equalDepthOthers:
      'Nach dem Median über {texts} Texte wird {cases} kein Verfahren anderer öfter gelesen als unsere übliche Einstellung.',
    equalDepthList:
      'Mediane über die Modelle, jeweils vom Median über die Texte: unsere übliche Einstellung {reads}; {list}.',
    equalDepthBy: '{method} {reads} ({cases} öfter als die übliche Einstellung)',
    equalDepthSpread:
      'Von Text zu Text unterscheiden sich die gelesenen Versuche eines Verfahrens auf einem Modell um {spread} (Median der Abstände zwischen den meisten und den wenigsten); ein Text allein entscheidet also wenig.',
    frontierDesignedAlt:
      'Ein Diagramm je Modell: gelesene Versuche im Entwurf über der mittleren Tiefe, eine Linie je Verfahren von flach bis tief.',
    frontierDesignedShown: 'Wie oben, für die Fläche, wie sie entworfen ist.',
    frontierLostInPrint: 'Von den {of} Gravuren, die im Entwurf lesbar sind, sind {holds} im Druck nicht mehr lesbar.',

    searchTimesAlt:
      'Eine Zeile je Verfahren: die Zeit der Suche auf jedem Modell als Punkt, der Median als Strich, logarithmisch.',
    searchTimesShown:
      'Zeit, die Tiefen zu finden; ein Punkt ist ein Modell, der Strich der Median, die Skala ist logarithmisch.',
    timesRange: '{fastest} ist mit {least} s im Median am schnellsten, {slowest} mit {most} s am langsamsten.',
    timesPaperHolds:
      'Der Artikel sagt, seine Suche brauche einen Bruchteil der Zeit von Pengs Suche. Das gilt hier: {papp} s und {peng} s.',
    timesPaperFails:
      'Der Artikel sagt, seine Suche brauche einen Bruchteil der Zeit von Pengs Suche. Das gilt hier nicht: {papp} s und {peng} s.',
    timesWhy:
      'Das sind grobe Zeiten unserer Programme, während anderer Arbeit auf einem Rechner ohne Grafikkarte gemessen. Papps und unsere Suche zeichnen dort in Software; die von Peng und Kikuchi verfolgen Strahlen, Peng 2019 weit weniger als das Original.',

    lightErrorsAlt:
      'Zwei Diagramme mit einer Zeile je Verfahren: wie weit seine eigene Schätzung des Lichts vom Ergebnis der Strahlverfolgung abweicht, als Betrag und mit Vorzeichen.',
    lightErrorsShown:
      'Unterschied zwischen dem Licht, das ein Verfahren in den gravierten Teilmodulen annimmt, und dem Licht, das die Strahlverfolgung auf dem gravierten Netz findet, als Anteil des Lichts auf einer freien Fläche. Negativ: Das Verfahren nimmt zu wenig Licht an.',
    errorsRange: '{least} ist mit {leastError} im Median am genauesten, {most} mit {mostError} am ungenauesten.',
    errorsOursDark: 'QRelief liegt um {size} daneben und nimmt die Taschen im Mittel um {mean} zu dunkel an.',
    errorsOursBright: 'QRelief liegt um {size} daneben und nimmt die Taschen im Mittel um {mean} zu hell an.',
    errorsWhy:
      'Kikuchi und Peng 2019 messen den sichtbaren Teil des Himmels; das ist eine andere Größe als Licht und kein Fehler ihrer Programme. Papp 2021, Papp 2022 und die gleiche Tiefe verwenden hier unser Modell des Lichts. Bei Codes für eine Lampe wird das Licht unter dieser Lampe verfolgt. Der Artikel hat keinen solchen Vergleich.',

    lampDepthsAlt:
      'Ein Diagramm je Modell: mittlere Tiefe ohne Lampe, mit einer und mit zweien, für quadratische und für ganze Module.',
    lampDepthsShown:
      'Mittlere Tiefe nach der Zahl der Lampen, jede so stark wie der Himmel und 33° über dem Code, mit den veröffentlichten Schritten gefunden; Abbildung 21 des Artikels.',
    lampsPattern:
      'Mit quadratischen Modulen macht jede Lampe den Code {cases} tiefer: im Median {none} mm unter dem Himmel allein, {one} mit einer Lampe, {two} mit zweien.',
    lampsWhole: 'Mit ganzen Modulen macht ihn jede Lampe {cases} flacher: {none}, {one} und {two} mm.',
    lampsWhy:
      'Im Artikel gilt beides bei allen Modellen. Die Wirkung einer Lampe hängt davon ab, wie viel ihres Lichts die Wände von den Böden abhalten und wie hell sie die hellen Module macht, also auch von ihrer Stärke, die der Artikel nicht nennt.',

    lightAnglesAlt:
      'Zwei Diagramme, für ganze und für quadratische Module: gelesene Versuche über der Höhe der Leselampe, eine Linie für jedes Licht, für das graviert wurde.',
    lightAnglesShown:
      'Gelesene Versuche auf einer Platte unter dem Himmel und einer Lampe, nach der Höhe dieser Lampe über dem Code. Jede Linie ist ein Licht, für das graviert wurde; Abbildung 22 des Artikels.',
    anglesWhole:
      'Ganze Module, die für eine Lampe auf {oneAt}° graviert sind, lassen sich {one} lesen, ganze Module für eine Lampe auf {otherAt}° {other}.',
    anglesPaper:
      'Im Artikel vertragen sie eine um bis zu {oneHigher}° und {otherHigher}° höhere Lampe ({onePaper}° und {otherPaper}° in seinem Maß) und jede tiefere; hier gilt das erste {higher}, das zweite {lower}, und mit eben der Lampe, für die sie graviert sind, lassen sie sich {own} lesen.',
    anglesPattern:
      'Quadratische Module, für diese Lampen graviert, lassen sich {one} und {other} lesen; im Artikel war kein Code mit Mustern lesbar, der für eine Lampe graviert war.',
    anglesWith: 'mit Lampen auf {list}',
    anglesFromTo: { one: '{from}°', other: '{from}° bis {to}°' },
    anglesNone: 'mit keiner der versuchten Lampen',
    anglesWhy:
      'Unsere Lampe ist so stark wie der Himmel. Der Artikel nennt die Stärke seiner Lampe nicht, und eine App las gezeichnete Bilder einiger Winkel.',

    robustnessAlt:
      'Drei Diagramme mit einer Zeile je Gravur: die größte Unschärfe, die wenigsten Pixel je Modul und die größte Neigung, mit denen sie gelesen wird.',
    robustnessShown:
      'Nach Modulmuster / Suchmuster: die größte Unschärfe (Standardabweichung in Modulen), die wenigsten Pixel je Modul und die größte Neigung, mit denen ein Code im Entwurf noch lesbar ist; Abschnitt 8 des Artikels.',
    robustPairs:
      'Von zwei Mustern verträgt das Muster, das mehr graviert, in {holds} von {of} Paaren mindestens so viel Unschärfe, über Suchmuster und Modelle zusammengenommen.',
    robustBlur: 'Mediane der Unschärfe in Modulen: {list}.',
    robustOf: '{pattern} {blur}',
    robustOurs: 'QRelief verträgt mit dicken Plus im Median {blur} Module Unschärfe und {tilt}° Neigung.',
    robustUnread: {
      one: '{count} von {of} Gravuren ist nicht einmal von vorn lesbar und nicht gezeigt.',
      other: '{count} von {of} Gravuren sind nicht einmal von vorn lesbar und nicht gezeigt.',
    },
    robustPaper:
      'Im Artikel vertragen Codes weniger, je weniger graviert ist, aber nur wenig: Seine App brauchte ein, zwei Sekunden länger. Hier wird ein Bild gelesen oder nicht, daher zeigen sich auch kleine Verluste.',

    asideAlt:
      'Ein Diagramm je Decoder: der größte Winkel, aus dem Codes gelesen werden, über dem Bogen des Zylinders, den sie einnehmen, eine Linie für jede Anordnung.',
    asideShown:
      'Der größte Winkel zur Seite, aus dem Decoder von npm gemalte Codes auf einem Zylinder lesen, nach dem Bogen des Umfangs, den die Codes einnehmen: Mediane aller Versionen. Die Codes sind projiziert, wie QRelief sie graviert, wie ein Etikett um den Zylinder gewickelt, oder halbwegs dazwischen. Ein Punkt fehlt, wo die Hälfte der Versionen oder mehr nicht einmal von vorn gelesen wird.',
    asideArcs:
      'Projizierte Codes, die {narrow}° des Umfangs einnehmen, werden im Median aller Decoder und Versionen {narrowTilt} gelesen, solche, die {wide}° einnehmen, {wideTilt}.',
    asideUpTo: 'bis {tilt}° von der Seite',
    asideOnlyFront: 'nur von vorn',
    asideUnread: 'nicht einmal von vorn',
    asideLayouts:
      'Projizierte Codes werden {cases}, in denen eine der beiden Arten gelesen wird, mindestens so weit von der Seite gelesen wie gewickelte.',
    asideFront:
      'Von vorn werden projizierte Codes {projected} gelesen, solche dazwischen {halfway}, gewickelte {wrapped}.',
    asideMarks:
      'Von Version {version} an hat ein Code sechs Ausrichtungsmuster statt eines, und sie zeigen, wie er sich biegt: Bei jedem Bogen sind solche Codes weiter von der Seite lesbar: {list}.',
    asidePaper:
      'Die Codes sind gemalt; die Abbildung zeigt also die Wirkung der gebogenen Fläche allein, unabhängig von der Gravur. Der Artikel hat keinen solchen Versuch.',

    lampStrengthsAlt:
      'Zwei Diagramme, für ganze und für quadratische Module: mittlere Tiefe nach der Stärke einer Lampe, eine Linie je Höhe und eine für den Himmel allein.',
    lampStrengthsShown:
      'Mittlere Tiefe eines Codes auf einer Platte, der für eine Lampe graviert ist, nach der Stärke der Lampe (1: so stark wie der Himmel) und ihrer Höhe über dem Code.',
    lampAt: 'Lampe auf {elevation}°',
    skyAlone: 'Himmel allein',
    degrees: '{elevation}°',
    millimetres: '{width} mm',
    moduleOf: 'Module von {width} mm',
    axisStrength: 'Stärke der Lampe',
    axisContrast: 'Kontrast',
    axisGreatestDepth: 'größte Tiefe, mm',
    strengthsSides:
      'Module mit dem Muster „{pattern}“ werden mit einer Lampe auf {shallower} flacher als unter dem Himmel allein und mit einer auf {deeper} tiefer, wie stark sie auch ist.',
    strengthsWhy:
      'Die Höhe entscheidet, nicht die Stärke. Die Lampe des Artikels steht auf {elevation}°, zwischen beiden, wo kleine Unterschiede im Licht entscheiden.',

    contrastSweepAlt:
      'Ein Diagramm für jedes von zwei Modellen: mittlere Tiefe nach Kontrast, eine Linie je Modulmuster, gestrichelt die Tiefen von Peng 2019 und Peng 2020.',
    contrastSweepShown:
      'Mittlere Tiefe nach Kontrast und Modulmuster, mit den veröffentlichten Schritten gefunden. Gestrichelt: die Tiefen von Peng 2019 und Peng 2020 mit ihren veröffentlichten Einstellungen.',
    sweepReaches: '{model}: Ganze Module werden ab einem Kontrast von {contrast} so tief wie die von Peng 2019.',
    sweepNever: '{model}: Ganze Module bleiben bei jedem versuchten Kontrast flacher als die von Peng 2019.',
    sweepOrder:
      'Die Reihenfolge des Artikels, Peng 2020, dann alle Muster, dann Peng 2019, gilt bei Kontrasten von {least} bis {most}.',
    sweepOrderOnce:
      'Die Reihenfolge des Artikels, Peng 2020, dann alle Muster, dann Peng 2019, gilt nur bei einem Kontrast von {least}.',
    sweepWhy: 'Der Artikel nennt den Kontrast seiner Abbildung 20 nicht.',
    sweepNoOrder:
      'Die Reihenfolge des Artikels, Peng 2020, dann alle Muster, dann Peng 2019, gilt bei keinem versuchten Kontrast.',

    paperModuleAlt:
      'Zwei Diagramme mit einer Zeile je Verfahren: mittlere Tiefe und Lesungen im Druck für jedes Modell, mit einem Strich am Median.',
    paperModuleShown:
      'Mittlere Tiefe und Lesungen im Druck für jedes Verfahren mit seiner veröffentlichten Einstellung, mit Modulen von 1,2 mm wie in den Drucken des Artikels; ein Punkt ist ein Modell, der Strich der Median.',
    paperModuleReads:
      'Mit Modulen von 1,2 mm gelingen bei unserer Voreinstellung im Druck {reads} Versuche bei einer Tiefe von {depth} mm, im Median.',
    paperModuleOthers: 'Die anderen Verfahren für den Himmel: {list}.',
    paperModuleOther: '{method} {reads} bei {depth} mm',
    paperModuleDefault:
      'Kein anderes Verfahren lässt sich bei höchstens gleicher Tiefe öfter lesen als unsere Voreinstellung: Das gilt {cases}.',

    defaultChoiceAlt:
      'Diagramme für vier Modulbreiten: Lesungen im Druck nach mittlerer und nach größter Tiefe, ein Zeichen je versuchtem Muster. Ein Kreis markiert die Voreinstellung.',
    defaultChoiceShown:
      'Lesungen im Druck nach mittlerer Tiefe (oben) und größter Tiefe (unten) für die Einstellungen, die eine Suche mit 59 zufälligen Ziehungen übrig ließ, auf den vier Modellen, nach denen die Voreinstellung nicht gewählt wurde: Mittel aus liegenden, stehenden und schrägen Drucken. Der Kreis markiert die Voreinstellung; Zeichen sind Modulmuster / Suchmuster.',
    choiceReads: 'Auf diesen vier Modellen gelingen mit der Voreinstellung {list}.',
    choiceReadsAt: '{reads} Versuche bei {depth} mm Tiefe mit Modulen von {width} mm',
    choiceFrontier: 'Keine andere Wahl lässt sich bei höchstens gleicher mittlerer Tiefe öfter lesen bei {list}.',
    choiceFrontierAt: '{holds} von {of} Modellen mit Modulen von {width} mm',
    choiceOthers: 'Ohne Rauten gilt das bei {list}.',
    choiceBetter:
      'Module mit dem Muster „{pattern}“ und Suchmuster „{finders}“ lassen sich mit Modulen von {list} im Mittel öfter lesen.',
    choiceWhy:
      'Rauten sind trotzdem nicht die Voreinstellung. Im Mittel lasen 3,1 von fünf Decoder-Familien jeden von neun Drucken mit Rauten aus den Bahnen eines Slicers; bei den Drucken mit der früheren Voreinstellung waren es 3,8. Alle Versuche hier macht ein einziger Decoder.',

    claimPaper: 'Der Artikel sagt',
    claimHere: 'Hier',
    claimFigure: 'Abbildung',
    claimNotMeasured: 'Noch nicht gemessen.',
    claimHolds: 'Ja, {cases}',
    claimInPart: 'Teilweise, {cases}',
    claimFails: 'Nein, {cases}',
    claimThickModule: 'Dicke Plus lassen sich mit kleineren Modulen lesen als dünne.',
    claimFinderModule: 'Ganze Suchmuster erlauben kleinere Module als Suchmuster im Muster der Module.',
    claimSize:
      'Auf gekrümmten Modellen macht die Tiefe den größten Code größer als die Normalen allein (hier: um 2 % oder mehr).',
    claimLoose: 'Quadrate und dünne Plus, die nicht zusammenhängen, brauchen die geringste Tiefe.',
    claimThinPlus: 'Dünne Plus brauchen die geringste Tiefe aller Muster.',
    claimThickPlus: 'Dicke Plus brauchen die größte Tiefe aller Muster.',
    claimFinders: 'Eigene Muster für die Suchmuster brauchen weniger Tiefe als ganze Suchmuster.',
    claimFindersUnread: 'Codes, deren Suchmuster das Muster der Module haben, lassen sich nicht lesen.',
    claimOrder: 'Peng 2020 graviert am flachsten, dann kommen die Muster des Artikels, dann Peng 2019.',
    claimWhole: 'Ganze Module sind etwa so tief wie die von Peng 2019.',
    claimTime: 'Die Suche dauert kürzer als die von Peng 2019 und 2020.',
    claimLampPattern: 'Lampen machen Codes mit Mustern tiefer.',
    claimLampWhole: 'Lampen machen Codes mit ganzen Modulen flacher.',
    claimAngles: 'Ein Code, der für eine Lampe graviert ist, lässt sich unter einer 15° bis 30° höheren Lampe lesen.',
    claimRobust: 'Muster, die mehr gravieren, vertragen mindestens so viel Unschärfe.',
    'section-module': 'Kleinstes Modul',
    'section-size': 'Größen',
    'section-patterns': 'Muster',
    'section-methods': 'Verfahren',
    'section-time': 'Zeiten',
    'section-lamps': 'Lampen',
    'section-angles': 'Andere Lampe',
    'section-robust': 'Unschärfe',

    percent: '{value}\u00a0%',
    ratesShown:
      'CarvedQR enthält {pictures} Bilder gravierter Codes, gezogen aus weiten Bereichen von Text, Muster, Tiefe, Größe, Druck, Lampe und Kamera; viele sind schwer, manche unlesbar. Jeder Decoder bekommt jedes Bild einmal, mit seinen eigenen gründlichen Einstellungen.',
    ratesWrong: {
      one: '{count} Text war insgesamt falsch. Die Tabelle nennt den Anteil, den jeder Decoder liest.',
      other: '{count} Texte waren insgesamt falsch. Die Tabelle nennt den Anteil, den jeder Decoder liest.',
    },
    ratesDecoder: 'Decoder',
    ratesDesigned: 'im Entwurf',
    ratesPrinted: 'im Druck',
    ratesSky: 'Himmel',
    ratesLamp: 'Himmel und Lampe',
    ratesFront: 'von vorn',
    ratesTilted: 'bis 20° schräg',
    ratesSteep: 'bis 45° schräg',
    ratesNone: '–',

    galleryDefault: 'Mit der Voreinstellung',
    galleryLamp: 'Für eine Lampe auf 33°',
    galleryPatterns: 'Jedes Muster für Module und Suchmuster',
    galleryDesigned: 'Im Entwurf',
    galleryPrinted: 'Im Druck',
    galleryFacts: '{depth} mm tief; {reads} von {tries} Versuchen lesen den Entwurf, {printed} den Druck',
    galleryMissing: 'Dieser Seite fehlen die Bilder: script/gallery macht sie.',

    symbolFlipsAlt:
      'Zwei Diagramme, zur Suche von 2019 und zu unserer: mittlere Tiefe ohne Umkehren, mit dem von Peng 2019 und mit unserem, ein Zeichen je Modell.',
    symbolFlipsShown:
      'Mittlere Tiefe ganzer Module mit Fehlerkorrektur H, wenn dunkle Module in weiten dunklen Flächen hell bleiben und Decoder sie wiederherstellen.',
    flipsCount: 'Peng 2019 lässt {peng} Module hell, QRelief {ours}, weil es mehr von der Fehlerkorrektur verbraucht.',
    flipsSaved:
      'Mit der Suche von 2019 macht das Codes um {peng2019} % und {ours2019} % flacher, mit unserer um {peng} % und {ours} %, im Median.',
    flipsReads:
      'Im Druck ändern sich die gelesenen Versuche im Median um höchstens {tries}, aber die verbrauchte Fehlerkorrektur schützt nicht mehr vor Schmutz und Schäden.',
  },
};
