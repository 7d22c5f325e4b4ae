// SPDX-License-Identifier: GPL-3.0-or-later
import { AxeBuilder } from '@axe-core/playwright';
import { expect } from '@playwright/test';

/**
 * Expects axe to find no violations, light and dark. Only its colour rules depend on the colour scheme. Begins with the
 * page's scheme, because a change draws the whole view anew.
 * @param {import('@playwright/test').Page} page
 * @param {string} state  name of the page's state
 */
export async function expectNoViolations(page, state) {
  const isDark = await page.evaluate(() => matchMedia('(prefers-color-scheme: dark)').matches);
  /** @type {('dark' | 'light')[]} */ const schemes = isDark ? ['dark', 'light'] : ['light', 'dark'];
  for (const [index, colorScheme] of schemes.entries()) {
    await page.emulateMedia({ colorScheme, reducedMotion: 'reduce' });
    // Legacy mode opens no further page for the result. What passes is counted, so one element each will do.
    const axe = new AxeBuilder({ page }).setLegacyMode().options({ resultTypes: ['violations'] });
    if (index > 0) axe.withRules(['color-contrast', 'link-in-text-block']);
    const { violations, passes, incomplete } = await axe.analyze();
    // Axe must have run checks. `incomplete` are the checks that it could not decide.
    expect(passes.length + incomplete.length, 'axe has looked').toBeGreaterThan(0);
    const faults = violations.flatMap(({ id, help, nodes }) =>
      nodes.map(({ html, failureSummary }) => `${id}: ${help}: ${html} ${failureSummary}`),
    );
    expect.soft(faults, `${state}, ${colorScheme}`).toEqual([]);
  }
}
