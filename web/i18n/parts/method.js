// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of the page that shows the result of each step.

export const method = {
  en: {
    title: 'How QRelief works – QRelief',
    description:
      'How QRelief engraves a QR code into a 3D model: direction, size, occlusion and depth, the new mesh, and decoding, with pictures computed live.',
    heading: 'How it works',
    lead: 'Here a dark module of a QR code is a pocket: dark because its walls hide the sky from its floor. QRelief finds the smallest sufficient depth of each pocket and builds a solid around it.',
    live: 'Your device computes everything on this page now, from this model. Turn it.',
    liveView: 'The model',
    fromReader: 'As the viewer sees it',
    beside: 'From the side',
    carved: 'Engraved',
    working: '{stage} …',
    starting: 'Loading the model',
    ready: 'Done in {seconds} seconds.',
    failed: 'The pictures could not be computed: {reason}',

    direction: '1. Direction',
    directionWhat:
      'QRelief draws the surface around the chosen point as an eye in front of it sees it, and measures the direction that each spot faces and its distance from the plane of the code. The viewing direction is the mean of the normals, weighed against the normals of the nearest and the farthest parts; a few rounds refine it.',
    normals: 'Normals of the surface: red is right, green is up, blue is towards the viewer.',
    heights: 'Height above the plane of the code.',

    size: '2. Size',
    sizeWhat:
      'Around the point, the eye sees a connected part of the surface; it ends where the surface turns away or another part covers it. The largest square in the silhouette of this part is the largest code. Its quiet zone must fit as well.',
    guaranteed: 'Fits at every rotation',
    chosen: 'Engraved here',
    module: 'One module',

    occlusion: '3. Occlusion and depth',
    occlusionWhat:
      'Every wall runs along a ray from the eye, so the engraved code is a single height map. At each texel the GPU searches the map for the horizon in many directions; the sky above the horizon lights the texel. If the floor of a module is still too bright compared with its surroundings, the module goes deeper, in a few passes, until all modules are dark enough or a wall would become too thin.',
    light: 'The light on the floors, at the final depths.',
    depths: 'The final depths; each square is a fifth of a module wide.',
    passes: 'Passes',
    meanDepth: 'Mean depth',
    maxDepth: 'Maximum depth',

    embedding: '4. The new mesh',
    embeddingWhat:
      'QRelief projects the facets under the code and the outlines of the pockets onto a plane, divides the plane into triangles, and lifts them back onto the surface along the rays; then it adds floors and walls. All other facets stay bit for bit the same. It writes the result, reads it back, and checks that it is a solid.',
    trianglesBefore: 'Triangles before',
    trianglesAfter: 'Triangles after',
    solid: 'Checked',
    isSolid: 'closed, manifold, no crossings',
    isNotSolid: 'not a solid',

    reading: '5. Decoding',
    readingWhat:
      'Finally QRelief draws the engraved model as a phone sees it, and an independent decoder has to find the text in this picture.',
    photo: 'The phone’s view.',
    readsAs: 'Decoded: {text}',
    notRead: 'This picture did not decode.',

    source: 'Source',
    sourceWhat:
      'The method follows Papp, Hoffmann and Papp, “Embedding QR Code onto Triangulated Meshes using Horizon Based Ambient Occlusion” (2022). QRelief adds exact size limits, a faster depth search, checked solids, and test decoding.',
    library: 'The C++ library for developers',
    tryIt: 'Open this model in the app',
  },
  de: {
    title: 'Wie QRelief funktioniert – QRelief',
    description:
      'Wie QRelief einen QR-Code in ein 3D-Modell graviert: Richtung, Größe, Verdeckung und Tiefe, das neue Netz und das Lesen, mit live gerechneten Bildern.',
    heading: 'So funktioniert es',
    lead: 'Ein dunkles Modul eines QR-Codes ist hier eine Tasche: dunkel, weil ihre Wände dem Boden den Himmel verdecken. QRelief findet für jede Tasche die kleinste ausreichende Tiefe und baut einen Körper darum.',
    live: 'Alles auf dieser Seite wird jetzt auf diesem Gerät aus diesem Modell berechnet. Es lässt sich drehen.',
    liveView: 'Das Modell',
    fromReader: 'Wie der Betrachter es sieht',
    beside: 'Von der Seite',
    carved: 'Graviert',
    working: '{stage} …',
    starting: 'Modell laden',
    ready: 'In {seconds} Sekunden fertig.',
    failed: 'Die Bilder konnten nicht berechnet werden: {reason}',

    direction: '1. Richtung',
    directionWhat:
      'QRelief zeichnet die Fläche um den gewählten Punkt so, wie ein Auge davor sie sieht, und misst, wohin jede Stelle zeigt und wie weit sie von der Ebene des Codes entfernt ist. Die Blickrichtung ist das Mittel der Normalen, abgewogen gegen die Normalen der nächsten und der fernsten Teile; wenige Runden verfeinern sie.',
    normals: 'Normalen der Fläche: Rot ist rechts, Grün ist oben, Blau ist zum Betrachter hin.',
    heights: 'Höhe über der Ebene des Codes.',

    size: '2. Größe',
    sizeWhat:
      'Um den Punkt herum sieht das Auge ein zusammenhängendes Stück der Fläche; es endet, wo die Fläche sich abwendet oder etwas davorsteht. Das größte Quadrat in der Silhouette dieses Stücks ist der größte Code. Auch seine Ruhezone muss hineinpassen.',
    guaranteed: 'Passt in jeder Drehung',
    chosen: 'Hier graviert',
    module: 'Ein Modul',

    occlusion: '3. Verdeckung und Tiefe',
    occlusionWhat:
      'Jede Wand verläuft entlang eines Strahls vom Auge, also ist der gravierte Code eine einzige Höhenkarte. Für jeden Punkt der Karte sucht die Grafikkarte in vielen Richtungen den Horizont; der Himmel darüber beleuchtet den Punkt. Ist der Boden eines Moduls im Vergleich zu seiner Umgebung noch zu hell, wird das Modul tiefer, in wenigen Durchgängen, bis alle dunkel genug sind oder eine Wand zu dünn würde.',
    light: 'Das Licht auf den Böden, bei den endgültigen Tiefen.',
    depths: 'Die endgültigen Tiefen; jedes Quadrat ist ein Fünftel eines Moduls breit.',
    passes: 'Durchgänge',
    meanDepth: 'Mittlere Tiefe',
    maxDepth: 'Größte Tiefe',

    embedding: '4. Das neue Netz',
    embeddingWhat:
      'QRelief projiziert die Dreiecke unter dem Code und die Umrisse der Taschen auf eine Ebene, zerlegt sie neu und hebt die neuen Dreiecke entlang der Strahlen auf die Fläche zurück; dann kommen Böden und Wände dazu. Alle anderen Dreiecke bleiben Bit für Bit, wie sie sind. Das Ergebnis wird geschrieben, wieder gelesen und als Körper geprüft.',
    trianglesBefore: 'Dreiecke vorher',
    trianglesAfter: 'Dreiecke nachher',
    solid: 'Geprüft',
    isSolid: 'geschlossen, mannigfaltig, nichts kreuzt sich',
    isNotSolid: 'kein Körper',

    reading: '5. Lesen',
    readingWhat:
      'Zuletzt zeichnet QRelief das gravierte Modell, wie ein Handy es sieht, und ein unabhängiger Decoder muss den Text in diesem Bild finden.',
    photo: 'Die Sicht des Handys.',
    readsAs: 'Gelesen: {text}',
    notRead: 'Dieses Bild ließ sich nicht lesen.',

    source: 'Quelle',
    sourceWhat:
      'Das Verfahren folgt Papp, Hoffmann und Papp, „Embedding QR Code onto Triangulated Meshes using Horizon Based Ambient Occlusion“ (2022). QRelief fügt genaue Grenzen der Größe, eine schnellere Tiefensuche, geprüfte Körper und das Probelesen hinzu.',
    library: 'Die C++-Bibliothek für Entwickler (auf Englisch)',
    tryIt: 'Dieses Modell in der App öffnen',
  },
};
