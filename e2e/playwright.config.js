// SPDX-License-Identifier: GPL-3.0-or-later
import { createServer } from 'node:net';
import { fileURLToPath } from 'node:url';
import { defineConfig } from '@playwright/test';

/** Chooses a free port. The workers, which read this file too, inherit the choice. */
async function choosePort() {
  process.env.QRELIEF_E2E_PORT ??= await new Promise((resolve) => {
    const server = createServer().listen(0, '127.0.0.1', () => {
      const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
      server.close(() => resolve(String(port)));
    });
  });
  return process.env.QRELIEF_E2E_PORT;
}

const root = fileURLToPath(new URL('..', import.meta.url));
const address = `http://127.0.0.1:${await choosePort()}/`;

export default defineConfig({
  testDir: '.',
  outputDir: 'results',
  workers: 1, // the software renderer uses every core
  timeout: 600_000, // long enough for a whole journey on a busy machine
  expect: { timeout: 120_000 },
  forbidOnly: Boolean(process.env.CI),
  reporter: [['list']],
  use: {
    baseURL: address,
    serviceWorkers: 'block', // except in tests of service workers: cached files would hide the served ones
    // A trace with pictures makes the browser compress each frame, and a trace with the page's state reads it before and
    // after each action, also in tests that pass.
    trace: { mode: 'retain-on-failure', screenshots: false, snapshots: false },
    screenshot: 'only-on-failure',
    contextOptions: { reducedMotion: 'reduce' }, // a moving progress bar is painted 60 times a second
    launchOptions: {
      executablePath: process.env.QRELIEF_CHROMIUM ?? '/usr/bin/chromium',
      args: [
        '--use-angle=swiftshader',
        '--enable-unsafe-swiftshader',
        '--no-sandbox',
        '--disable-background-networking',
        '--disable-component-update',
        '--disable-sync',
        '--no-first-run',
      ],
    },
  },
  projects: [
    // A small window: the software renderer takes time by the pixel.
    { name: 'desktop', testIgnore: 'phone.spec.js', use: { viewport: { width: 1024, height: 640 } } },
    {
      name: 'phone',
      // specs that depend on the layout
      testMatch: ['phone.spec.js', 'controls.spec.js', 'open.spec.js', 'articles.spec.js', 'axe.spec.js'],
      grepInvert: /@desktop/,
      use: { viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 },
    },
  ],
  webServer: {
    command: `npm run preview -- --host 127.0.0.1 --port ${process.env.QRELIEF_E2E_PORT} --strictPort`,
    cwd: root,
    url: address,
    reuseExistingServer: false,
    stdout: 'ignore',
  },
});
