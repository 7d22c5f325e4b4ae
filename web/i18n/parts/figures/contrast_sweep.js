// SPDX-License-Identifier: GPL-3.0-or-later
// The figure of study/figures/contrast_sweep.js.

export const contrastSweep = {
  en: {
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
  },
  de: {
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
  },
};
