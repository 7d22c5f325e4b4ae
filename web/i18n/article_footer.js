// SPDX-License-Identifier: GPL-3.0-or-later
// Part of the build: the footer of the articles (guide, method, study, gallery), with the choice of language and
// appearance that ui/preferences.js serves.

const kPlace = /[^\S\n]*<footer data-article-footer><\/footer>\n/;

const kFooter = `    <footer class="foot">
      <div class="choices">
        <div class="choice">
          <label for="language" data-text="page.language"></label>
          <select id="language"></select>
        </div>
        <div class="choice">
          <label for="theme" data-text="page.theme"></label>
          <select id="theme">
            <option value="auto" data-text="page.themeAuto"></option>
            <option value="light" data-text="page.themeLight"></option>
            <option value="dark" data-text="page.themeDark"></option>
          </select>
        </div>
      </div>
      <p data-text="page.promise"></p>
      <p data-project-links></p>
    </footer>
`;

/** Fills the place for the footer, if the page has one. @param {string} html */
export const withArticleFooter = (html) => html.replace(kPlace, kFooter);
