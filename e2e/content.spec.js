// SPDX-License-Identifier: GPL-3.0-or-later
// The code's content: its kinds, the symbol drawn while one types, and the advice next to it.
import { expect, test } from '@playwright/test';
import { decodePath } from './support/decode.js';
import { Engraver } from './support/engraver.js';
import { untilKept } from './support/kept.js';
import { poll } from './support/poll.js';

/** @typedef {import('@playwright/test').Page} Page */

/** @param {Page} page */
const symbol = (page) => page.getByRole('img', { name: /^QR code, \d+ × \d+ modules$/ });

/** @param {Page} page */
const advice = (page) => page.getByRole('list', { name: 'Advice' });

/**
 * Expects an independent decoder to read this text from the symbol next to the textbox.
 * @param {Page} page
 * @param {string} text
 */
async function expectSymbol(page, text) {
  await poll(async () => {
    const svg = symbol(page);
    if ((await svg.count()) === 0) return '';
    const [box, path] = await svg.evaluate((element) => [
      element.getAttribute('viewBox'),
      element.lastElementChild?.getAttribute('d'),
    ]);
    return decodePath(path ?? '', Number(box?.split(' ')[2]));
  }).toBe(text);
}

/** @param {Page} page @param {string} kind */
const choose = (page, kind) => page.getByRole('combobox', { name: 'Kind of content' }).selectOption(kind);

/**
 * Fills in fields by name.
 * @param {Page} page
 * @param {string} kind
 * @param {Record<string, string>} values
 */
async function fillIn(page, kind, values) {
  const group = page.getByRole('group', { name: kind, exact: true });
  for (const [name, value] of Object.entries(values)) await group.getByLabel(name, { exact: true }).fill(value);
}

/** Tells whether every edge of a binary STL has two triangles, one in each direction. @param {Uint8Array} bytes */
function isClosedStl(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  /** @type {Set<string>} */ const open = new Set();
  const corner = (/** @type {number} */ at) => [0, 4, 8].map((part) => view.getFloat32(at + part, true)).join();
  for (let triangle = 0; triangle < view.getUint32(80, true); ++triangle) {
    const corners = [12, 24, 36].map((at) => corner(84 + 50 * triangle + at));
    corners.forEach((from, k) => {
      const to = corners[(k + 1) % 3];
      if (!open.delete(`${to} ${from}`)) open.add(`${from} ${to}`);
    });
  }
  return open.size === 0;
}

test.use({ timezoneId: 'America/New_York' }); // to see that an event is written in UTC

/** @type {{ kind: string, values: Record<string, string>, payload: string }[]} */
const kCases = [
  {
    kind: 'Contact',
    values: { 'First name': 'Zoë', 'Last name': 'Müller; Groß', Phone: '+49 30 1234', Website: 'example.org' },
    payload:
      'BEGIN:VCARD\nVERSION:3.0\nN:Müller\\; Groß;Zoë;;;\nFN:Zoë Müller\\; Groß\nTEL:+49301234\nURL:https://example.org\nEND:VCARD',
  },
  {
    kind: 'E-mail',
    values: { 'E-mail address': 'a@example.org', Subject: 'Hi & bye', Message: 'one\ntwo' },
    payload: 'mailto:a@example.org?subject=Hi%20%26%20bye&body=one%0D%0Atwo',
  },
  {
    kind: 'Text message',
    values: { 'Phone number': '+49 151 234567', Message: 'On: my way' },
    payload: 'SMSTO:+49151234567:On: my way',
  },
  { kind: 'Phone call', values: { 'Phone number': '+44 (0)20 7946 0018' }, payload: 'tel:+442079460018' },
  {
    kind: 'Place',
    values: { 'Latitude (°)': '52.5163', 'Longitude (°)': '13,3777', 'Search for': 'Tor' },
    payload: 'geo:52.5163,13.3777?q=Tor',
  },
];

test('A Wi-Fi access is filled in, engraved and decoded', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=saddle&process=none');
  await app.expectReady();
  await choose(page, 'Wi-Fi access');
  const [network, password] = [page.getByLabel('Network name'), page.getByLabel('Password', { exact: true })];

  await test.step('a missing value is reported at its field, on leaving it and on Engrave', async () => {
    await expect(network).not.toHaveAttribute('aria-invalid');
    await expect(app.alert).toHaveCount(0);
    await password.fill('short');
    await password.press('Tab');
    await expect(password).toHaveAccessibleDescription(/must have 8 to 63 characters; this one has 5/);
    await expect(app.status).toHaveText('Fill in the fields to get a code.');
    await expect(app.placement).toHaveText('No spot yet'); // the last code has left the model
    await expect(network).not.toHaveAttribute('aria-invalid');
    await app.engraveButton.click();
    await expect(network).toHaveAttribute('aria-invalid', 'true');
    await expect(network).toHaveAccessibleDescription('Required');
    await expect(network).toBeFocused();
    await expect(app.result).toBeHidden();

    await network.fill('net');
    await password.fill('long enough');
    await expect(app.text).toHaveValue('WIFI:T:WPA;S:net;P:long enough;;');
    await page.getByLabel('Protection').selectOption('None');
    await expect(password).toBeHidden();
    await expect(app.text).toHaveValue('WIFI:T:nopass;S:net;;');
    await page.getByLabel('Protection').selectOption('WPA, WPA2 or WPA3');
  });

  await fillIn(page, 'Wi-Fi access', { 'Network name': 'Café; 1', Password: 'pass:"word"' });
  const payload = 'WIFI:T:WPA;S:Café\\; 1;P:pass\\:\\"word\\";;';
  await expect(app.text).toHaveValue(payload);
  await expectSymbol(page, payload);
  await expect(password).toHaveAttribute('type', 'password');
  await page.getByRole('button', { name: 'Show the password' }).click();
  await expect(password).toHaveAttribute('type', 'text');

  await app.engrave();
  await expect(app.result).toContainText(`Reads as ${payload}`);
  expect((await app.report()).verification.text).toBe(payload);
  const { name } = await app.download();
  expect(name).toMatch(/^saddle-qr-wifi-Cafe-1-\d+mm\.stl$/);
  await app.openSettings();
  await expect(page.getByText('The settings contain the Wi-Fi password')).toBeVisible();
  const stored = await page.evaluate(() => JSON.stringify({ ...localStorage }) + JSON.stringify({ ...sessionStorage }));
  expect(stored).not.toContain('word');
});

test('A text alone is shown, engraved and saved as a solid; the code comes back', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=vase');
  await app.expectReady();
  const link = await app.text.inputValue();
  await choose(page, 'Text alone');
  const letters = page.getByRole('textbox', { name: 'Text; each line is a line of letters' });
  await expect(letters).toHaveValue('');
  await app.engraveButton.click();
  await expect(letters).toBeFocused();
  await expect(app.alert).toHaveCount(0);
  await letters.fill('Rev B\n2026');
  await expect(page.getByRole('img', { name: 'The text Rev B 2026' })).toBeVisible();
  await expect(page.locator('#symbol-facts')).toContainText(/^[\d.]+\smm across, capitals [\d.]+\smm high$/);
  await expect(page.locator('#code-state')).toHaveText(/^Text alone, capitals [\d.]+\smm high$/);
  await expect(app.setting('How deep')).toBeHidden();
  await expect(page.locator('fieldset:has(#filament)')).toHaveAttribute('hidden'); // a text needs no light
  await expect(page.getByRole('button', { name: 'Phone view' })).toBeDisabled();
  await expect(page.getByRole('button', { name: 'Code as SVG' })).toBeHidden();

  await app.engrave();
  await expect(app.result).toContainText(/A person can read it: capitals [\d.]+\smm high, strokes [\d.]+\smm wide/);
  await expect(app.result).toContainText('Solid');
  await expect(page.locator('#grades')).toBeHidden();
  const report = await app.report();
  expect(report.content).toBe('text');
  expect(report.symbol).toBeNull();
  expect(report.verification.verdict.passed).toBe(true);
  const { name, bytes } = await app.download();
  expect(name).toMatch(/^vase-text-Rev-B-2026-\d+mm\.stl$/);
  expect(isClosedStl(bytes)).toBe(true);

  await untilKept(page, (work) => work?.text === 'Rev B\n2026' && work.settings.content === 'text');
  await choose(page, 'Link or text');
  await expect(app.text).toHaveValue(link);
  await expectSymbol(page, link);
  await app.expectReady();
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(letters).toHaveValue('Rev B\n2026');
});

test('Every other kind writes its payload to the textbox and the symbol; a contact is shorter as a MeCard', async ({
  page,
}) => {
  const app = new Engraver(page);
  await app.open('?sample=saddle');
  await app.expectReady();
  const before = await app.text.inputValue();
  for (const { kind, values, payload } of kCases) {
    await choose(page, kind);
    await fillIn(page, kind, values);
    await expect(app.text).toHaveValue(payload); // a textbox has LF line ends
    await expectSymbol(page, kind === 'Contact' ? payload.replaceAll('\n', '\r\n') : payload);
  }

  await test.step('a MeCard', async () => {
    await choose(page, 'Contact');
    await fillIn(page, 'Contact', {
      'First name': 'Ada',
      'Last name': 'Lovelace',
      Phone: '+44 20 7946 0018',
      Website: '',
      'E-mail address': 'ada@example.org',
    });
    const line = advice(page).getByRole('listitem').filter({ hasText: 'As a MeCard it needs version' });
    await line.getByRole('button', { name: 'Use it' }).click();
    await expect(app.text).toHaveValue('MECARD:N:Lovelace,Ada;TEL:+442079460018;EMAIL:ada@example.org;;');
    await expect(page.getByLabel('Written as')).toHaveValue('mecard');
    await expectSymbol(page, 'MECARD:N:Lovelace,Ada;TEL:+442079460018;EMAIL:ada@example.org;;');
  });

  await test.step('an event is written in UTC, unless it ends before it starts', async () => {
    await choose(page, 'Event');
    await fillIn(page, 'Event', { Title: 'Party', Start: '2027-07-01T18:30', End: '2027-07-01T17:00' });
    await page.getByLabel('Where', { exact: true }).focus();
    const end = page.getByLabel('End', { exact: true });
    await expect(end).toHaveAttribute('aria-invalid', 'true');
    await expect(end).toHaveAccessibleDescription(/It ends before it starts/);
    await expect(app.text).toHaveValue('');
    await end.fill('2027-07-01T22:00');
    await expect(end).not.toHaveAttribute('aria-invalid');
    await expectSymbol(
      page,
      'BEGIN:VEVENT\r\nSUMMARY:Party\r\nDTSTART:20270701T223000Z\r\nDTEND:20270702T020000Z\r\nEND:VEVENT',
    );
  });

  await test.step('the keyboard alone fills in a phone call; typing in the textbox closes the builder and keeps the text', async () => {
    await page.reload(); // so that no kind has kept values
    await app.expectReady();
    const kind = page.getByRole('combobox', { name: 'Kind of content' });
    await choose(page, 'Place');
    await expect(app.text).toHaveValue('');
    await choose(page, 'Link or text');
    await expect(app.text).toHaveValue(before);
    await kind.focus();
    await page.keyboard.type('Phone');
    await page.keyboard.press('Tab');
    await page.keyboard.type('+49301234');
    await expect(app.text).toHaveValue('tel:+49301234');

    await app.text.fill('tel:+4930');
    await expect(kind).toHaveValue('text');
    await expect(page.getByLabel('Phone number')).toHaveCount(0);
    await expect(app.text).toHaveValue('tel:+4930');
    await expectSymbol(page, 'tel:+4930');
  });
});

test('The symbol shows version, fill and room; a click corrects a link', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=saddle');
  await app.expectReady();
  const facts = page.locator('#symbol-facts');
  await app.text.fill('a'.repeat(25));
  await expect(facts).toContainText('Version 2-M, 25 × 25 modules');
  await expect(facts).toContainText('25 of 26 bytes');
  await expect(facts).toContainText('One more byte fits');
  await app.text.fill('a'.repeat(26));
  await expect(facts).toContainText('One more byte, and the modules get smaller');
  await expect(page.getByRole('meter', { name: 'Bytes used' })).toHaveJSProperty('value', 26);
  await app.text.fill('a'.repeat(27));
  await expect(facts).toContainText('Version 3-Q, 29 × 29 modules'); // the same size with more error correction
  await app.text.fill('a'.repeat(2332));
  await expect(facts).toContainText('too long for any QR Code');
  await expect(symbol(page)).toHaveCount(0);

  await app.text.fill('example.org/a');
  await page.getByRole('button', { name: 'Add https://' }).click();
  await expect(app.text).toHaveValue('https://example.org/a');
  await expectSymbol(page, 'https://example.org/a');
  await app.text.fill('https://example.org/a b?utm_source=x&c=d');
  await page.getByRole('button', { name: 'Write them as %20' }).click();
  await page.getByRole('button', { name: 'Leave them out' }).click();
  await expect(app.text).toHaveValue('https://example.org/a%20b?c=d');
  await expect(page.getByRole('button', { name: 'Leave them out' })).toHaveCount(0);

  // The page warns of modules too small for the nozzle before carving, and offers a form with larger modules.
  await app.text.fill('short');
  await expect(advice(page)).toBeHidden();
  await app.text.fill(`https://example.org/${'x'.repeat(300)}`);
  const line = advice(page).getByRole('listitem').filter({ hasText: 'each module is' });
  await expect(line).toContainText(
    /At\s[\d.]+\smm each module is\s0\.\d\d\smm; a\s0\.4\smm nozzle needs about\s0\.6\smm for this pattern\./,
  );
  await expect(line).toContainText(/ [\d.]+\smm wide.* Or shorten the text to fit \d+ × \d+ modules\./);
  await app.openSettings();
  await app.setting('Nozzle (mm)').fill('0.1');
  await app.setting('Nozzle (mm)').blur();
  await expect(line).toHaveCount(0);

  await app.text.fill('https://subdomain.example.org/a'); // 31 bytes: version 3-M; in capitals version 2
  const capitals = advice(page).getByRole('listitem').filter({ hasText: 'in capitals needs version 2' });
  await expect(capitals).toContainText('modules 16 % larger');
  await capitals.getByRole('button', { name: 'Use it' }).click();
  await expect(app.text).toHaveValue('HTTPS://SUBDOMAIN.EXAMPLE.ORG/a');
  await expect(page.locator('#symbol-facts')).toContainText('Version 2-');
  await expectSymbol(page, 'HTTPS://SUBDOMAIN.EXAMPLE.ORG/a');
});
