// SPDX-License-Identifier: GPL-3.0-or-later
// The figure of study/figures/pattern_depths.js.

export const patternDepths = {
  en: {
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
  },
  de: {
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
  },
};
