// SPDX-License-Identifier: GPL-3.0-or-later
// Language and appearance: chosen on the page, effective at once and kept for the next visit.
import { recall, remember } from '../storage/remembered.js';
import { currentLanguage, localise, offeredLanguages, onLanguage, setLanguage, text } from '../i18n/catalogue.js';
import { byId } from '../dom/dom.js';

const kThemes = ['auto', 'light', 'dark'];
const kThemeName = 'theme';
const kGround = { light: '#f4f4f1', dark: '#17191c' }; // --ground of styles.css, for the browser's toolbar

/** Writes every text of the page and lists the languages. */
export function offerLanguages() {
  const select = byId('language', HTMLSelectElement);
  select.replaceChildren(...offeredLanguages().map(({ code, name }) => new Option(name, code)));
  const follow = () => {
    document.documentElement.lang = currentLanguage();
    select.value = currentLanguage();
    localise(document);
  };
  onLanguage(follow);
  follow();
  select.addEventListener('change', () => {
    select.setCustomValidity('');
    setLanguage(select.value).catch(() => {
      select.value = currentLanguage();
      select.setCustomValidity(text('page.languageNotLoaded'));
      select.reportValidity();
    });
  });
}

export class Theme {
  /** @param {(dark: boolean) => void} onChange  `dark`: the appearance is dark now */
  constructor(onChange) {
    this.system_ = matchMedia('(prefers-color-scheme: dark)');
    this.select_ = byId('theme', HTMLSelectElement);
    const stored = recall(kThemeName) ?? '';
    this.select_.value = kThemes.includes(stored) ? stored : 'auto';
    this.apply_();
    this.select_.addEventListener('change', () => {
      remember(kThemeName, this.select_.value);
      this.apply_();
      onChange(this.dark);
    });
    this.system_.addEventListener('change', () => {
      if (this.select_.value === 'auto') onChange(this.dark);
    });
  }

  get dark() {
    return this.select_.value === 'auto' ? this.system_.matches : this.select_.value === 'dark';
  }

  apply_() {
    const chosen = this.select_.value;
    document.documentElement.dataset.theme = chosen;
    for (const meta of document.querySelectorAll('meta[name="theme-color"]')) {
      const own = meta.getAttribute('media')?.includes('dark') ? 'dark' : 'light';
      meta.setAttribute('content', kGround[chosen === 'auto' ? own : /** @type {'light' | 'dark'} */ (chosen)]);
    }
  }
}
