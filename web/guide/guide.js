// SPDX-License-Identifier: GPL-3.0-or-later
import { currentLanguage, onLanguage, startTexts, text } from '../i18n/catalogue.js';
import { byId, make } from '../dom/dom.js';
import { openArticle } from './article.js';
import { kSizes, widthMm } from './sizes.js';

const kSmallestModuleMm = 0.6; // the smallest module printed and decoded with a 0.4 mm nozzle: Papp 2022, figure 11
const kComfortableModuleMm = 1.2; // the module of most prints in that paper

function showSizes() {
  const mm = new Intl.NumberFormat(currentLanguage(), { minimumFractionDigits: 1, maximumFractionDigits: 1 });
  byId('sizes', HTMLElement).replaceChildren(
    ...kSizes.map(({ letters, modules }) => {
      const head = make('th', { text: text('guide.lettersCount', { count: letters }) });
      head.scope = 'row';
      const cells = [
        `${modules} × ${modules}`,
        ...[kSmallestModuleMm, kComfortableModuleMm].map((module) => `${mm.format(widthMm(modules, module))}\u00a0mm`),
      ];
      return make('tr', {}, head, ...cells.map((cell) => make('td', { text: cell })));
    }),
  );
}

await startTexts('guide');
openArticle();
onLanguage(showSizes);
showSizes();
