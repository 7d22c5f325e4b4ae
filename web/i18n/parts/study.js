// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of the study page, without its figures (figures.js).

export const study = {
  en: {
    title: 'Measurements – QRelief',
    description:
      'The engraving depth that QR codes need to decode, by module pattern, method, light and print: the figures of a study, compared with the published study, with its tables.',
    heading: 'Measurements',
    lead: 'How small, how deep and in which light? We engraved the same models by every published method and simulated prints and pictures of them. Five findings help you print; the figures and tables behind them follow.',

    contents: 'Contents',
    findings: 'Findings',
    figures: 'Figures and tables',
    eachFigure: 'Each of them',
    figuresWhat: 'Below each figure is its table, to download. Everything is simulated, as “Procedure” says.',

    how: 'Procedure',
    howWhy:
      'Earlier papers judged engraved QR codes by prints and photographs that nobody else has. Here every method engraves the same models and is judged under the same light by the same decoders. The build makes all figures and numbers on this page from the tables.',
    howModels:
      'The models are the sample models of the app, a plate and a cylinder. Unless a figure says otherwise, the code has version 3, modules of 1 mm and white material, under an even sky.',
    howReads:
      'Each code is tested in tries: ZXing reads pictures of it from the front, at several scales and blurs, in several ways. A code counts as read if two tries in five succeed; a dashed line in the figures marks this limit.',
    howPrinted:
      '“As designed” is the engraved surface itself. “As printed” is this surface after printing with a nozzle of 0.4 mm in layers of 0.2 mm, with the code facing up. Both are simulated, and nothing was printed; so the numbers compare methods and do not predict the result of a particular printer.',
    howPaper:
      '“The paper” is Papp, Hoffmann and Papp, “Embedding QR Code onto Triangulated Meshes using Horizon Based Ambient Occlusion” (2022). The other methods are Kikuchi 2018 (grooves in a smooth surface), Peng 2019 (self-shadows), Peng 2020 (shadows of one lamp), Papp 2021 (tilted or wavy floors), and an even depth everywhere. Papp 2022 uses square modules unless the name says “whole”. We chose the details that the publications leave open; the head of each method’s source lists them.',
    howOurs:
      '“QRelief (default)” is the setting of the app at this module size. The app also raises the error correction where that is free; the study leaves this out so that all methods engrave the same symbol. “QRelief (patterned finders)” is the setting of the app for thin walls. “QRelief (design)” requires contrast only on the designed surface, and “QRelief (by reading)” makes each module as dark as a blurred picture of it needs. “QRelief (one light)” and Peng 2020 engrave for one strong lamp and are decoded under it; all others are decoded under the sky.',
    howLimits:
      'Each method keeps the limits of its source. No source names a maximum depth, so the other methods’ pockets may be ten modules deep. For all methods a wall of 0.8 mm remains behind every pocket, and the nozzle is 0.4 mm wide.',

    statements: 'The paper’s statements and our results',
    module: 'Smallest readable module',
    size: 'Largest code',
    patterns: 'Patterns and depth',
    methods: 'Methods and depth',
    frontier: 'Reads and depth',
    defaultChoice: 'Choice of the default',
    contrastSweep: 'Contrast and depth',
    paperModule: 'Modules of 1.2 mm',
    lampStrengths: 'Elevation of the lamp',
    equalDepth: 'Several texts at equal depth',
    frontierDesigned: 'Reads and depth, as designed',
    time: 'Time of the depth search',
    error: 'Error of each method’s light',
    lamps: 'Lamps in addition to the sky',
    angles: 'Reading under a different lamp',
    robust: 'Blur, distance and tilt',
    aside: 'Oblique views of a cylinder',
    flips: 'Modules flipped to light',

    carvedQr: 'CarvedQR: share of pictures decoded',
    again: 'Repeat the measurements',
    againWhat:
      'Run script/study to measure every table again. Sources, methods and tables are in the folder “study” of the project.',
  },
  de: {
    title: 'Messungen – QRelief',
    description:
      'Wie tief QR-Codes graviert sein müssen, um gelesen zu werden, nach Modulmuster, Verfahren, Licht und Druck: die Abbildungen einer Studie, verglichen mit der veröffentlichten, samt Tabellen.',
    heading: 'Messungen',
    lead: 'Wie klein, wie tief, in welchem Licht? Wir haben dieselben Modelle nach jedem veröffentlichten Verfahren graviert und Drucke und Fotos davon simuliert. Fünf Ergebnisse helfen beim Drucken; danach folgen die Abbildungen und Tabellen dazu.',

    contents: 'Inhalt',
    findings: 'Ergebnisse',
    figures: 'Abbildungen und Tabellen',
    eachFigure: 'Jede einzeln',
    figuresWhat:
      'Unter jeder Abbildung steht ihre Tabelle zum Herunterladen. Alles ist simuliert, wie unter „Vorgehen“ beschrieben.',

    how: 'Vorgehen',
    howWhy:
      'Frühere Arbeiten beurteilten gravierte QR-Codes nach Drucken und Fotos, die sonst niemand hat. Hier graviert jedes Verfahren dieselben Modelle und wird unter demselben Licht mit denselben Decodern beurteilt. Alle Abbildungen und Zahlen entstehen beim Bauen dieser Seite aus den Tabellen.',
    howModels:
      'Die Modelle sind die Beispielmodelle der App, eine Platte und ein Zylinder. Wo eine Abbildung nichts anderes sagt, hat der Code Version 3 und Module von 1 mm, in weißem Material unter gleichmäßigem Himmel.',
    howReads:
      'Jeder Code wird in Versuchen geprüft: ZXing liest Bilder von vorn, in mehreren Maßstäben und Unschärfen, auf mehrere Arten. Ein Code gilt als lesbar, wenn zwei von fünf Versuchen gelingen; in den Abbildungen ist diese Grenze gestrichelt.',
    howPrinted:
      '„Im Entwurf“ ist die gravierte Fläche selbst. „Im Druck“ ist diese Fläche nach dem Druck mit einer Düse von 0,4 mm in Schichten von 0,2 mm, mit dem Code nach oben. Beides ist simuliert, gedruckt wurde nichts; die Zahlen vergleichen also Verfahren und sagen nicht voraus, was ein bestimmter Drucker schafft.',
    howPaper:
      '„Der Artikel“ ist Papp, Hoffmann und Papp, „Embedding QR Code onto Triangulated Meshes using Horizon Based Ambient Occlusion“ (2022). Die anderen Verfahren sind Kikuchi 2018 (Rillen in einer glatten Fläche), Peng 2019 (Selbstschatten), Peng 2020 (Schatten einer einzigen Lampe), Papp 2021 (geneigte oder wellige Böden) und eine überall gleiche Tiefe. Papp 2022 wird mit quadratischen Modulen graviert, wo nicht „ganz“ dabeisteht. Einzelheiten, die die Veröffentlichungen offenlassen, haben wir gewählt; sie stehen am Anfang des Quelltexts jedes Verfahrens.',
    howOurs:
      '„QRelief (üblich)“ ist die Einstellung der App bei dieser Modulgröße. Die App hebt außerdem die Fehlerkorrektur an, wo das nichts kostet; die Studie lässt das weg, damit alle Verfahren dasselbe Symbol gravieren. „QRelief (Suchmuster gemustert)“ ist die Einstellung der App bei dünnen Wänden. „QRelief (Entwurf)“ verlangt den Kontrast nur von der entworfenen Fläche, und „QRelief (nach Lesung)“ macht jedes Modul so dunkel, wie ein unscharfes Bild davon es braucht. „QRelief (eine Lampe)“ und Peng 2020 gravieren für eine einzige starke Lampe und werden unter ihr gelesen, alle anderen unter dem Himmel.',
    howLimits:
      'Jedes Verfahren hat die Grenzen seiner Quelle. Keine nennt eine größte Tiefe, deshalb dürfen die Taschen der anderen zehn Module tief sein. Für alle gleich bleibt hinter jeder Tasche eine Wand von 0,8 mm, und die Düse ist 0,4 mm breit.',

    statements: 'Die Aussagen des Artikels und unsere Ergebnisse',
    module: 'Kleinstes lesbares Modul',
    size: 'Größter Code',
    patterns: 'Muster und Tiefe',
    methods: 'Verfahren und Tiefe',
    frontier: 'Lesbarkeit und Tiefe',
    defaultChoice: 'Wahl der Voreinstellung',
    contrastSweep: 'Kontrast und Tiefe',
    paperModule: 'Module von 1,2 mm',
    lampStrengths: 'Höhe der Lampe',
    equalDepth: 'Mehrere Texte bei gleicher Tiefe',
    frontierDesigned: 'Lesbarkeit und Tiefe im Entwurf',
    time: 'Dauer der Tiefensuche',
    error: 'Fehler im Licht jedes Verfahrens',
    lamps: 'Lampen zusätzlich zum Himmel',
    angles: 'Eine andere Lampe als erwartet',
    robust: 'Unschärfe, Abstand und Neigung',
    aside: 'Schräge Blicke auf einen Zylinder',
    flips: 'Hell gemachte Module',

    carvedQr: 'CarvedQR: Anteil der gelesenen Bilder',
    again: 'Selbst nachmessen',
    againWhat:
      'Der Befehl script/study misst alle Tabellen neu. Quelltext, Verfahren und Tabellen liegen im Ordner „study“ des Projekts.',
  },
};
