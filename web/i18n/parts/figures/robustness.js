// SPDX-License-Identifier: GPL-3.0-or-later
// The figure of study/figures/robustness.js.

export const robustness = {
  en: {
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
  },
  de: {
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
  },
};
