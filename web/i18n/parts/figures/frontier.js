// SPDX-License-Identifier: GPL-3.0-or-later
// The figure of study/figures/frontier.js.

export const frontier = {
  en: {
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
    frontierDesignedAlt:
      'A plot for each model: reads as designed against mean depth, a line for each method from shallow to deep.',
    frontierDesignedShown: 'As above, for the surface as designed.',
    frontierLostInPrint: 'Of the {of} engravings that read as designed, {holds} do not read as printed.',
  },
  de: {
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
    frontierDesignedAlt:
      'Ein Diagramm je Modell: gelesene Versuche im Entwurf über der mittleren Tiefe, eine Linie je Verfahren von flach bis tief.',
    frontierDesignedShown: 'Wie oben, für die Fläche, wie sie entworfen ist.',
    frontierLostInPrint: 'Von den {of} Gravuren, die im Entwurf lesbar sind, sind {holds} im Druck nicht mehr lesbar.',
  },
};
