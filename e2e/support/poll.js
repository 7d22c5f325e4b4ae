// SPDX-License-Identifier: GPL-3.0-or-later
import { expect } from '@playwright/test';

const kPauseMs = 50;

/**
 * Asks until the answer meets the expectation, like `expect.poll`, whose pauses grow to a second. While a test pauses,
 * the page refines its picture, which takes both cores from what the test waits for.
 * @template T
 * @param {() => T | Promise<T>} ask
 * @param {{ timeout?: number, intervals?: number[], message?: string }} [options]
 */
export const poll = (ask, options) => expect.poll(ask, { intervals: [kPauseMs], ...options });
