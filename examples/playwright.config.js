// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the examples of the npm package in the browser of e2e/: see script/test-npm.
import { defineConfig } from '@playwright/test';
import config from '../e2e/playwright.config.js';

const { webServer: _, projects: __, ...shared } = config;

export default defineConfig({ ...shared, testDir: 'page', outputDir: '../e2e/results' });
