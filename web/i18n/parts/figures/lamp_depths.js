// SPDX-License-Identifier: GPL-3.0-or-later
// The figure of study/figures/lamp_depths.js.

export const lampDepths = {
  en: {
    lampDepthsAlt:
      'A plot for each model: mean depth with no lamp, one and two, for square modules and for whole modules.',
    lampDepthsShown:
      'Mean depth by the number of lamps, each as strong as the sky and 33° above the code, found by the published steps; figure 21 of the paper.',
    lampsPattern:
      'With square modules each lamp makes the code deeper {cases}: {none} mm under the sky alone, {one} with one lamp, {two} with two, in the median.',
    lampsWhole: 'With whole modules each lamp makes the code shallower {cases}: {none}, {one} and {two} mm.',
    lampsWhy:
      'In the paper both hold on all models. The effect of a lamp depends on how much of its light the walls keep off the floors and how bright it makes the light modules, and so on its strength, which the paper does not give.',
  },
  de: {
    lampDepthsAlt:
      'Ein Diagramm je Modell: mittlere Tiefe ohne Lampe, mit einer und mit zweien, für quadratische und für ganze Module.',
    lampDepthsShown:
      'Mittlere Tiefe nach der Zahl der Lampen, jede so stark wie der Himmel und 33° über dem Code, mit den veröffentlichten Schritten gefunden; Abbildung 21 des Artikels.',
    lampsPattern:
      'Mit quadratischen Modulen macht jede Lampe den Code {cases} tiefer: im Median {none} mm unter dem Himmel allein, {one} mit einer Lampe, {two} mit zweien.',
    lampsWhole: 'Mit ganzen Modulen macht ihn jede Lampe {cases} flacher: {none}, {one} und {two} mm.',
    lampsWhy:
      'Im Artikel gilt beides bei allen Modellen. Die Wirkung einer Lampe hängt davon ab, wie viel ihres Lichts die Wände von den Böden abhalten und wie hell sie die hellen Module macht, also auch von ihrer Stärke, die der Artikel nicht nennt.',
  },
};
