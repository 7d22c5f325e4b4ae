// SPDX-License-Identifier: GPL-3.0-or-later
// Measures each page with Lighthouse as on a desktop computer with a wired connection: `script/lighthouse`.
import { mkdirSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { chromium } from '@playwright/test';
import lighthouse, { desktopConfig } from 'lighthouse';
import { Site } from './site.js';

const kPages = ['', 'guide.html', 'method.html', 'study.html', 'gallery.html'];
const kLeast = { performance: 90, accessibility: 95, 'best-practices': 95, seo: 95 };
const kResults = fileURLToPath(new URL('../../build/lighthouse', import.meta.url));

const kPort = 9333; // for Lighthouse to control the browser

mkdirSync(kResults, { recursive: true });
const site = await new Site('/').open();
const browser = await chromium.launch({
  executablePath: process.env.QRELIEF_CHROMIUM ?? '/usr/bin/chromium',
  // Paint with the processor, as on a page without WebGL, but run WebGL with SwiftShader. Painting with SwiftShader
  // takes longer than the steps being measured.
  args: [
    `--remote-debugging-port=${kPort}`,
    '--no-sandbox',
    '--enable-unsafe-swiftshader',
    '--disable-gpu-compositing',
    '--disable-background-networking',
  ],
});
let failed = false;
try {
  for (const page of kPages) {
    const result = await lighthouse(
      site.address + page,
      { port: kPort, output: 'json', logLevel: 'error' },
      desktopConfig,
    );
    if (!result) throw new Error(`Lighthouse gave no result for ${page}`);
    const { categories, audits } = result.lhr;
    const scores = Object.entries(kLeast).map(([id, least]) => {
      const score = Math.round(100 * (categories[id].score ?? 0));
      failed ||= score < least;
      return `${id} ${score}${score < least ? ` (at least ${least})` : ''}`;
    });
    const timings = [
      'first-contentful-paint',
      'largest-contentful-paint',
      'total-blocking-time',
      'cumulative-layout-shift',
      'interactive',
    ].map((id) => `${id} ${audits[id]?.displayValue ?? '–'}`);
    console.log(`${page || 'index.html'}: ${scores.join(', ')}; ${timings.join(', ')}`);
    for (const category of Object.values(categories)) {
      for (const { id, weight } of category.auditRefs) {
        const { score, title } = audits[id];
        if (weight > 0 && score !== null && score < 0.9)
          console.log(`  ${category.id}: ${title} (${id}, ${Math.round(100 * score)})`);
      }
    }
    writeFileSync(`${kResults}/${page || 'index.html'}.json`, JSON.stringify(result.lhr, null, 2));
  }
} finally {
  await browser.close();
  await site.close();
}
process.exitCode = failed ? 1 : 0;
