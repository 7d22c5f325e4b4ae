// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { withArticleFooter } from './article_footer.js';
import { linkProject } from './project_links.js';

const kFooter = '<footer>\n  <p data-project-links></p>\n</footer>\n';
const linksIn = (/** @type {string} */ html) =>
  [...html.matchAll(/href="([^"]+)"[^>]* data-text="([^"]+)"/g)].map(([, url, words]) => `${words} ${url}`);

test('the footer links the source and the issue tracker that package.json names', () => {
  const project = {
    repository: { type: 'git', url: 'git+https://example.org/a/qrelief.git' },
    bugs: { url: 'https://example.org/a/qrelief/issues' },
  };
  assert.deepEqual(linksIn(linkProject(kFooter, project)), [
    'links.source https://example.org/a/qrelief',
    'links.issues https://example.org/a/qrelief/issues',
  ]);
  assert.deepEqual(linksIn(linkProject(kFooter, { repository: 'https://example.org/a' })), [
    'links.source https://example.org/a',
  ]);
});

test('without an address that a browser opens the footer has no links', () => {
  for (const project of [{}, { repository: 'git@example.org:a/qrelief.git', bugs: { url: '' } }])
    assert.equal(linkProject(kFooter, project), '<footer>\n</footer>\n');
});

test('every page has a place for the links', () => {
  for (const page of ['index', 'guide', 'method', 'study', 'gallery']) {
    const html = withArticleFooter(readFileSync(new URL(`../${page}.html`, import.meta.url), 'utf8'));
    assert.notEqual(linkProject(html, { repository: 'https://example.org' }), linkProject(html, {}), page);
  }
});
