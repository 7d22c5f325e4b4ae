// SPDX-License-Identifier: GPL-3.0-or-later
// The frame of the page about the study; what stands on it of figures is in figures.js.

export const study = {
  en: {
    title: 'What was measured – QRelief',
    description: 'How deep QR codes must be carved to be read, by module pattern, method, light and print: the figures of a study, compared with the published one, with its tables.',
    heading: 'What was measured',
    lead: 'Earlier work on carved QR codes was judged by prints and photographs that nobody else has. Here every method carves the same models and is judged by the same light and the same readers. All figures and numbers are made from the tables when this page is built.',

    how: 'How it was measured',
    howModels: 'The models are the sample models of the app, a plate and a cylinder. Unless a figure says otherwise the code is of version 3 with modules of 1 mm, in white material under an even sky.',
    howReads: 'Whether a carving reads is counted in tries: pictures of it from the front, of several scales and blurs, are read by ZXing in several ways. A code counts as read if two tries in five succeed; figures mark that line by dashes.',
    howPrinted: '“As designed” is the surface that was carved. “As printed” is what a nozzle of 0.4 mm leaves of it in layers of 0.2 mm, the code facing up. Both are simulated, no print was made; so the numbers compare methods and do not promise what a certain printer makes.',
    howPaper: '“The paper” is Papp, Hoffmann and Papp, “Embedding QR Code onto Triangulated Meshes using Horizon Based Ambient Occlusion” (2022). The other methods are Kikuchi 2018 (grooves in a smooth surface), Peng 2019 (self-shadows), Peng 2020 (shadows of one lamp), Papp 2021 (tilted or wavy floors), and an even depth everywhere. Papp 2022 is carved with square modules unless it says “whole”. What their publications leave open was chosen by us; the head of each method’s source says what.',
    howOurs: '“QRelief (default)” is what the app carves at this module size. The app also raises the error correction where that is free, which the study leaves out so that all methods carve the same symbol. “QRelief (patterned finders)” is what it carves where walls are thin. “QRelief (design)” asks for contrast on the designed surface alone, and “QRelief (by reading)” makes each module as dark as a blurred picture of it needs. “QRelief (one light)” and Peng 2020 carve for one strong lamp and are read under it, all others under the sky.',
    howLimits: 'Each method runs under the limits of its source. None of them names a greatest depth, so pockets of others may be ten modules deep. For all methods alike a wall of 0.8 mm stays behind every pocket, and the nozzle is 0.4 mm wide.',

    module: 'The least module',
    size: 'How large a code fits',
    patterns: 'Patterns and depth',
    methods: 'Methods and depth',
    frontier: 'Reading against depth',
    equalDepth: 'At one depth, for several texts',
    frontierDesigned: 'The same as designed',
    time: 'Time to find the depths',
    error: 'How well each method knows the light',
    lamps: 'Lamps beside the sky',
    angles: 'Another lamp than expected',
    robust: 'Blur, distance and tilt',
    aside: 'From aside, on a cylinder',
    flips: 'Modules made light',

    again: 'Measure it again',
    againWhat: 'One command, script/study, measures every table again. Sources, methods and tables are in the folder “study” of the project.',
  },
  de: {
    title: 'Was gemessen wurde – QRelief',
    description: 'Wie tief QR-Codes graviert sein müssen, um gelesen zu werden, nach Modulmuster, Verfahren, Licht und Druck: die Abbildungen einer Studie, verglichen mit der veröffentlichten, samt Tabellen.',
    heading: 'Was gemessen wurde',
    lead: 'Frühere Arbeiten über gravierte QR-Codes wurden nach Drucken und Fotos beurteilt, die sonst niemand hat. Hier graviert jedes Verfahren dieselben Modelle und wird mit demselben Licht und denselben Lesern beurteilt. Alle Abbildungen und Zahlen entstehen aus den Tabellen, wenn diese Seite gebaut wird.',

    how: 'Wie gemessen wurde',
    howModels: 'Die Modelle sind die Beispielmodelle der App, eine Platte und ein Zylinder. Wo eine Abbildung nichts anderes sagt, hat der Code Version 3 und Module von 1 mm, in weißem Material unter gleichmäßigem Himmel.',
    howReads: 'Ob sich eine Gravur lesen lässt, wird in Versuchen gezählt: Bilder von vorn, in mehreren Maßstäben und Unschärfen, werden von ZXing auf mehrere Arten gelesen. Ein Code gilt als lesbar, wenn zwei von fünf Versuchen gelingen; in den Abbildungen ist diese Grenze gestrichelt.',
    howPrinted: '„Im Entwurf“ ist die gravierte Fläche selbst. „Im Druck“ ist, was eine Düse von 0,4 mm davon in Schichten von 0,2 mm übrig lässt, mit dem Code nach oben. Beides ist simuliert, gedruckt wurde nichts; die Zahlen vergleichen also Verfahren und versprechen nicht, was ein bestimmter Drucker schafft.',
    howPaper: '„Der Artikel“ ist Papp, Hoffmann und Papp, „Embedding QR Code onto Triangulated Meshes using Horizon Based Ambient Occlusion“ (2022). Die anderen Verfahren sind Kikuchi 2018 (Rillen in einer glatten Fläche), Peng 2019 (Selbstschatten), Peng 2020 (Schatten einer einzigen Lampe), Papp 2021 (geneigte oder wellige Böden) und eine überall gleiche Tiefe. Papp 2022 wird mit quadratischen Modulen graviert, wo nicht „ganz“ dabeisteht. Was die Veröffentlichungen offenlassen, haben wir gewählt; was es ist, steht am Anfang des Quelltexts jedes Verfahrens.',
    howOurs: '„QRelief (üblich)“ ist, was die App bei dieser Modulgröße graviert. Die App hebt außerdem die Fehlerkorrektur an, wo das nichts kostet; die Studie lässt das weg, damit alle Verfahren dasselbe Symbol gravieren. „QRelief (Suchmuster gemustert)“ ist, was sie bei dünnen Wänden graviert. „QRelief (Entwurf)“ verlangt den Kontrast nur von der entworfenen Fläche, und „QRelief (nach Lesung)“ macht jedes Modul so dunkel, wie ein unscharfes Bild davon es braucht. „QRelief (eine Lampe)“ und Peng 2020 gravieren für eine einzige starke Lampe und werden unter ihr gelesen, alle anderen unter dem Himmel.',
    howLimits: 'Jedes Verfahren hat die Grenzen seiner Quelle. Keine nennt eine größte Tiefe, deshalb dürfen die Taschen der anderen zehn Module tief sein. Für alle gleich bleibt hinter jeder Tasche eine Wand von 0,8 mm, und die Düse ist 0,4 mm breit.',

    module: 'Das kleinste Modul',
    size: 'Wie groß ein Code sein kann',
    patterns: 'Muster und Tiefe',
    methods: 'Verfahren und Tiefe',
    frontier: 'Lesbarkeit und Tiefe',
    equalDepth: 'Bei gleicher Tiefe, mit mehreren Texten',
    frontierDesigned: 'Dasselbe im Entwurf',
    time: 'Zeit, die Tiefen zu finden',
    error: 'Wie gut jedes Verfahren das Licht kennt',
    lamps: 'Lampen neben dem Himmel',
    angles: 'Eine andere Lampe als erwartet',
    robust: 'Unschärfe, Abstand und Neigung',
    aside: 'Von der Seite, auf einem Zylinder',
    flips: 'Module, die hell bleiben',

    again: 'Selbst nachmessen',
    againWhat: 'Ein Befehl, script/study, misst alle Tabellen neu. Quelltext, Verfahren und Tabellen liegen im Ordner „study“ des Projekts.',
  },
};
