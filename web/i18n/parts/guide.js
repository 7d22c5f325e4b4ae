// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of the page about printing an engraved code.

export const guide = {
  en: {
    title: 'How to print an engraved QR code – QRelief',
    description:
      'Print a QR code that is engraved into a 3D model so that phones can read it: size, nozzle, layers, orientation, material, light, and a test plate.',
    heading: 'How to print it',
    lead: 'An engraved code is dark where little light gets in. It reads well if the printer makes clean pockets and light comes from all around.',

    steps: 'From the model to the print',
    stepPlace:
      'Open a model, enter the text, and click where the code should go. You see it as it will lie there, with its quiet zone; turn it, resize it or move it.',
    stepCarve: 'Engrave. Each dark module becomes a pocket, just deep enough for its own shadow to darken it.',
    stepRead: 'Check. You see the code as a phone sees it, and the decoded text. Then download the file and print it.',

    size: 'Size',
    sizeWhat:
      'The width of a module, the smallest square of the code, matters most. The authors of the paper behind QRelief printed the default pattern with a 0.4 mm nozzle and decoded it with modules of 0.6 mm and more; their other prints have modules of 1.2 mm, which leaves a margin. For another nozzle, scale both widths.',
    sizeShort: 'A short text needs fewer modules, so each can be larger. Shorten a link before you enlarge the code.',
    sizeTable: 'Width of the code with a 0.4 mm nozzle',
    letters: 'Text up to',
    lettersCount: '{count} letters',
    modules: 'Modules',
    smallest: 'Smallest that decoded',
    comfortable: 'With a margin',
    sizeMargin: 'Keep a quiet zone of four modules free around the code. QRelief finds a spot with room for it.',

    printer: 'Nozzle and layers',
    printerTell:
      'Enter your nozzle and layer height under “Pattern, depth, printer”. After engraving, QRelief lists the details that your printer cannot make, and the remedies.',
    printerNozzle:
      'Pockets narrower than 0.9 nozzle widths close up in the print. Choose a larger code, a shorter text or a finer nozzle.',
    printerLayer: 'Pockets shallower than two layers may vanish. Print thinner layers, or put the code on a side wall.',
    printerStrings:
      'Strings across the pockets hide the code. Dry the filament, print a little cooler, and pick out the rest with a needle.',

    orientation: 'Orientation',
    onSide: 'On an upright wall: best',
    onSideWhy:
      'The nozzle traces the outline of every pocket, and the depth need not be a multiple of the layer height.',
    onTop: 'On top: good',
    onTopWhy:
      'The depth consists of whole layers, so print thin layers. Do not iron the top: ironing smears the edges.',
    below: 'Facing the bed or hanging over: avoid',
    belowWhy:
      'The first layer is squeezed into the pockets, and supports fill them. If you have no choice, block supports at the code.',

    printed: 'The simulated print',
    printedWhat:
      'After engraving, QRelief simulates the print: it lays every layer as the nozzle would, lights the result, and decodes it. Before that, it deepens modules that would print too bright. Choose the process and the orientation under “Pattern, depth, printer”. The pictures show the test plate as a phone sees it; a frame would mark a lost module.',
    printedStanding:
      'Nozzle 0.4 mm, layers 0.2 mm, standing: every layer leaves a groove, and the pockets’ edges are steps.',
    printedLying: 'The same, lying: the nozzle rounds every corner, and a pocket’s floor lies on a whole layer.',
    printedFine: 'Nozzle 0.25 mm, layers 0.1 mm, lying.',
    printedResin: 'Resin, layers 0.05 mm, lying.',

    material: 'Material and colour',
    materialColour:
      'One colour is enough. The authors of the paper printed codes in several colours; the colour made little difference to decoding.',
    materialMatt:
      'Matt, opaque filament is best. Highlights on glossy or silky filament and the glow of translucent filament hide the shadows.',
    materialTwo:
      'With two filaments, set “Made by” to a second colour: inlaid as a thin, flush body, or painted onto the surface. Such a code needs no shadow, and the 3MF file opens with both filaments. Lay the code facing up, which takes only a few filament changes; on a wall, every layer takes one.',
    painted: 'A code painted in a second colour. The surface keeps its shape.',
    paintedAlt: 'A dark QR code on the light, curved side of a model of a rabbit, flush with its surface',
    printedPainted:
      'A painted code as printed, facing up: lines of 0.45 mm round the corners of modules, and the colours bleed.',
    printedPaintedAlt: 'A dark QR code on a light plate, with slightly rounded modules',

    light: 'Light and reading',
    lightEven:
      'Even light is best: daylight, or a lamp that is not close to the code. The code is dark because the pockets see little of the sky, not because a lamp casts shadows.',
    lightPreset:
      'Under “How deep”, choose “Shallow” for even light from the front, “Balanced” if there is also a lamp, and “Robust” for poor light and wider angles.',
    lightPhone:
      'Hold the phone straight in front of the code, about 25 cm away. The code is engraved for this distance; you can set another. Seen from the side, a code on a curved surface is distorted, however deep it is: a smaller code or a flatter spot forgives more.',
    lightOne:
      'The shallowest codes use the shadow of one lamp: under “For experts”, set “Darken by” to “Shadow of one lamp”. Such a code reads reliably only while one light, such as a phone’s lamp or the sun, shines from the side that the result names. To set its position, choose “Light of one lamp” under “Light”.',

    parts: 'A code for every part',
    partsWhat:
      'Each part of a series can have its own code, with a serial number or its own link. Choose “A code for every part” under “Code”.',
    partsList:
      'Open a list as CSV, as spreadsheets save it, with a column “text” or “url”, or paste one link a line, or number the parts. Before anything is engraved, QRelief names the lines with problems, such as two parts with the same text or a text that is too long. All codes have the size that the longest text needs.',
    partsFirst: 'Engrave the first part and look at it. Print it first if you can.',
    partsAll:
      'Then engrave all parts. You can do other work meanwhile, and go on after you close or reload the page. QRelief test-decodes every part; a part that does not decode is left out, and the table says why.',
    partsManifest:
      'The ZIP contains a model for each part and a manifest, manifest.csv, with the text, the file and the test results of every part.',

    textAlone: 'Text without a code',
    textAloneWhat:
      'Under “Kind of content”, choose “Text alone”: names, revisions or warnings that follow a curved face. Each line of the text becomes a line of letters, two layers deep, or in a second colour.',
    textAloneSize:
      'The drawing says how high the capitals are at the chosen spot. If the strokes are thinner than a printed line, choose a spot with more room, a shorter text, more lines or a finer nozzle.',

    coupon: 'A test plate',
    couponWhat:
      'Before a long print, print a small one: a plate of 44 × 44 × 4 mm with a short code. It tests your printer, your material and your light.',
    couponOpen: 'Open the engraved plate',
    couponSteps: 'How to use it',
    couponStep1: 'Download it and print it with the settings of the final print.',
    couponStep2: 'Scan it in the light in which the final part will be scanned.',
    couponStep3: 'If it does not read, change one thing from the list below and print it again.',

    trouble: 'If it does not read',
    troubleSee: 'Problem',
    troubleDo: 'Remedy',
    closed: 'Pockets have closed',
    closedDo: 'Larger code, shorter text, finer nozzle',
    faint: 'Open, but hardly darker than the surface',
    faintDo: 'Engrave “Robust”; matt filament; less direct light',
    strings: 'Strings in the pockets',
    stringsDo: 'Dry filament, cooler nozzle, a needle',
    side: 'Reads only from the front',
    sideDo: 'A flatter spot, or a smaller code in the same spot',
    lamp: 'Reads only in daylight',
    lampDo: 'Engrave “Robust”; two colours',
  },
  de: {
    title: 'Einen eingravierten QR-Code drucken – QRelief',
    description:
      'Einen QR-Code, der in ein 3D-Modell graviert ist, so drucken, dass Handys ihn lesen: Größe, Düse, Schichten, Lage, Material, Licht und eine Prüfplatte.',
    heading: 'So wird es gedruckt',
    lead: 'Ein eingravierter Code ist dort dunkel, wo wenig Licht hinkommt. Er ist gut lesbar, wenn der Drucker die Taschen sauber herstellt und das Licht von allen Seiten kommt.',

    steps: 'Vom Modell zum Druck',
    stepPlace:
      'Modell öffnen, Text eingeben und dorthin klicken, wo der Code hin soll. Er zeigt sich, wie er dort liegen wird, mit seiner Ruhezone; er lässt sich drehen, vergrößern, verschieben.',
    stepCarve:
      'Gravieren. Jedes dunkle Modul wird eine Tasche, gerade so tief, dass ihr eigener Schatten sie dunkel macht.',
    stepRead:
      'Prüfen. Zu sehen ist der Code, wie ein Handy ihn sieht, und der gelesene Text. Dann die Datei herunterladen und drucken.',

    size: 'Größe',
    sizeWhat:
      'Es zählt die Breite eines Moduls, des kleinsten Quadrats im Code. Im Artikel hinter QRelief wurde das voreingestellte Muster mit einer 0,4-mm-Düse gedruckt und ab Modulen von 0,6 mm gelesen; die übrigen Drucke haben 1,2 mm, das lässt Spielraum. Bei einer anderen Düse beides entsprechend umrechnen.',
    sizeShort:
      'Kurze Texte brauchen weniger Module, also kann jedes größer sein: erst den Link kürzen, dann den Code vergrößern.',
    sizeTable: 'Breite des Codes bei einer 0,4-mm-Düse',
    letters: 'Text bis zu',
    lettersCount: '{count} Zeichen',
    modules: 'Module',
    smallest: 'Kleinste, die gelesen wurde',
    comfortable: 'Mit Spielraum',
    sizeMargin: 'Um den Code muss eine Ruhezone von vier Modulen frei bleiben. QRelief findet den Platz dafür.',

    printer: 'Düse und Schichten',
    printerTell:
      'Düse und Schichthöhe unter „Muster, Tiefe, Drucker“ angeben. Nach dem Gravieren nennt QRelief, welche Einzelheiten der Drucker nicht herstellen kann und was hilft.',
    printerNozzle:
      'Taschen, die schmaler als 0,9 Düsenbreiten sind, laufen im Druck zu. Größeren Code, kürzeren Text oder feinere Düse wählen.',
    printerLayer:
      'Taschen, die flacher als zwei Schichten sind, können verschwinden. Dünnere Schichten drucken oder den Code auf eine Seitenwand setzen.',
    printerStrings:
      'Fäden über den Taschen verdecken den Code. Filament trocknen, etwas kühler drucken und Reste mit einer Nadel entfernen.',

    orientation: 'Lage im Drucker',
    onSide: 'Auf einer senkrechten Wand: am besten',
    onSideWhy: 'Die Düse zeichnet den Umriss jeder Tasche. Die Tiefe muss kein Vielfaches der Schichthöhe sein.',
    onTop: 'Oben: gut',
    onTopWhy:
      'Die Tiefe besteht aus ganzen Schichten, also dünne drucken. Bügeln verschmiert die Kanten; besser weglassen.',
    below: 'Zum Druckbett oder überhängend: vermeiden',
    belowWhy:
      'Die erste Schicht quillt in die Taschen, und Stützen füllen sie. Wenn es sein muss, Stützen am Code sperren.',

    printed: 'Der simulierte Druck',
    printedWhat:
      'Nach dem Gravieren simuliert QRelief den Druck: Jede Schicht wird so gelegt, wie die Düse es kann, dann das Ergebnis beleuchtet und gelesen. Module, die im Druck zu hell würden, hat QRelief vorher vertieft. Verfahren und Ausrichtung stehen unter „Muster, Tiefe, Drucker“. Die Bilder zeigen die Prüfplatte, wie ein Handy sie sieht; ginge ein Modul verloren, zeigte es ein Rahmen.',
    printedStanding:
      'Düse 0,4 mm, Schichten 0,2 mm, stehend: Jede Schicht hinterlässt eine Rille, und die Ränder der Taschen sind Stufen.',
    printedLying:
      'Dasselbe liegend: Die Düse rundet jede Ecke, und der Boden einer Tasche liegt auf einer ganzen Schicht.',
    printedFine: 'Düse 0,25 mm, Schichten 0,1 mm, liegend.',
    printedResin: 'Harz, Schichten 0,05 mm, liegend.',

    material: 'Material und Farbe',
    materialColour:
      'Eine Farbe genügt. Für den Artikel wurden Codes in mehreren Farben gedruckt; die Farbe machte beim Lesen keinen großen Unterschied.',
    materialMatt:
      'Mattes, deckendes Filament ist am besten. Glanzlichter auf glänzendem und das Leuchten von durchscheinendem Filament verdecken die Schatten.',
    materialTwo:
      'Mit zwei Filamenten „Gemacht durch“ auf eine zweite Farbe stellen: eingelegt als dünner, bündiger Körper oder auf die Oberfläche gemalt. Ein solcher Code braucht keinen Schatten, und die 3MF-Datei öffnet sich mit beiden Filamenten. Den Code nach oben legen, das kostet nur wenige Filamentwechsel; an einer Wand kostet jede Schicht einen.',
    painted: 'Ein Code, in einer zweiten Farbe aufgemalt. Die Oberfläche behält ihre Form.',
    paintedAlt: 'Ein dunkler QR-Code auf der hellen, gewölbten Seite eines Hasenmodells, bündig mit der Oberfläche',
    printedPainted:
      'Ein gemalter Code wie gedruckt, liegend: Linien von 0,45 mm runden die Ecken der Module, und die Farben verlaufen.',
    printedPaintedAlt: 'Ein dunkler QR-Code auf einer hellen Platte, mit leicht gerundeten Modulen',

    light: 'Licht und Lesen',
    lightEven:
      'Gleichmäßiges Licht ist am besten: Tageslicht oder eine Lampe, die nicht dicht am Code steht. Der Code ist dunkel, weil die Taschen wenig vom Himmel sehen, nicht weil eine Lampe Schatten wirft.',
    lightPreset:
      'Unter „Wie tief“ für gleichmäßiges Licht von vorn „Flach“ wählen, „Ausgewogen“, wenn auch eine Lampe leuchtet, und „Robust“ für schlechtes Licht und schrägere Blicke.',
    lightPhone:
      'Das Handy gerade vor den Code halten, etwa 25 cm entfernt. Für diesen Abstand ist der Code graviert; ein anderer lässt sich einstellen. Von der Seite gesehen verzerrt sich ein Code auf gewölbter Oberfläche, wie tief er auch ist: Ein kleinerer Code oder eine flachere Stelle verzeiht mehr.',
    lightOne:
      'Am flachsten sind Codes mit dem Schatten einer Lampe: Unter „Für Fachleute“ bei „Dunkel durch“ den „Schatten einer Lampe“ wählen. Ein solcher Code ist nur verlässlich lesbar, solange ein Licht, etwa eine Handylampe oder die Sonne, von der Seite scheint, die das Ergebnis nennt. Wo es steht, lässt sich unter „Licht“ mit „Licht einer Lampe“ festlegen.',

    parts: 'Ein Code je Teil',
    partsWhat:
      'Jedes Teil einer Serie kann einen eigenen Code haben, mit einer Seriennummer oder einem eigenen Link. Dazu unter „Code“ „Ein Code je Teil“ wählen.',
    partsList:
      'Eine Liste als CSV öffnen, wie Tabellenprogramme sie speichern, mit einer Spalte „text“ oder „url“, oder einen Link je Zeile einfügen, oder die Teile nummerieren. Bevor etwas graviert wird, nennt QRelief die Zeilen mit Fehlern, etwa zwei Teile mit gleichem Text oder einen zu langen Text. Alle Codes haben die Größe, die der längste Text braucht.',
    partsFirst: 'Das erste Teil gravieren, ansehen und am besten drucken.',
    partsAll:
      'Dann alle gravieren. Anderes lässt sich währenddessen tun, und nach dem Schließen oder Neuladen der Seite geht es weiter. Jedes Teil wird probeweise gelesen; ein unlesbares Teil wird weggelassen, und die Tabelle sagt, warum.',
    partsManifest:
      'Das ZIP enthält für jedes Teil ein Modell und eine Übersicht, manifest.csv, mit Text, Datei und Prüfergebnissen jedes Teils.',

    textAlone: 'Text ohne Code',
    textAloneWhat:
      'Unter „Art des Inhalts“ „Nur Text“ wählen: Namen, Versionen oder Hinweise, die einer gekrümmten Fläche folgen. Jede Zeile des Textes wird eine Zeile Buchstaben, zwei Schichten tief oder in einer zweiten Farbe.',
    textAloneSize:
      'Die Zeichnung nennt die Höhe der Großbuchstaben an der gewählten Stelle. Sind die Striche dünner als eine gedruckte Linie, hilft eine Stelle mit mehr Platz, ein kürzerer Text, mehr Zeilen oder eine feinere Düse.',

    coupon: 'Eine Prüfplatte',
    couponWhat:
      'Vor einem langen Druck einen kleinen machen: eine Platte von 44 × 44 × 4 mm mit einem kurzen Code. Sie prüft Drucker, Material und Licht.',
    couponOpen: 'Die gravierte Platte öffnen',
    couponSteps: 'So wird sie verwendet',
    couponStep1: 'Herunterladen und mit den Einstellungen des endgültigen Drucks drucken.',
    couponStep2: 'In dem Licht lesen, in dem auch das endgültige Teil gelesen wird.',
    couponStep3: 'Wenn sie nicht lesbar ist, eine Sache aus der Liste unten ändern und noch einmal drucken.',

    trouble: 'Wenn er nicht lesbar ist',
    troubleSee: 'Problem',
    troubleDo: 'Abhilfe',
    closed: 'Taschen sind zugelaufen',
    closedDo: 'Größerer Code, kürzerer Text, feinere Düse',
    faint: 'Offen, aber kaum dunkler als die Fläche',
    faintDo: '„Robust“ gravieren; mattes Filament; weniger direktes Licht',
    strings: 'Fäden in den Taschen',
    stringsDo: 'Trockenes Filament, kühlere Düse, eine Nadel',
    side: 'Nur von vorn lesbar',
    sideDo: 'Eine flachere Stelle oder dort ein kleinerer Code',
    lamp: 'Nur bei Tageslicht lesbar',
    lampDo: '„Robust“ gravieren; zwei Farben',
  },
};
