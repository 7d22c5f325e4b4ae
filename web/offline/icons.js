// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the app's icon to public/icons/ as the PNG files needed for installation: `npm run icons`.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { drawIcon, readIcon } from './app_icon.js';
import { writePng } from './png.js';

const kPublic = fileURLToPath(new URL('../../public', import.meta.url));

/** The touch icon is maskable, since the phone rounds it. */
const kFiles = [
  { name: 'icon-192.png', pixels: 192, maskable: false },
  { name: 'icon-512.png', pixels: 512, maskable: false },
  { name: 'maskable-512.png', pixels: 512, maskable: true },
  { name: 'touch-180.png', pixels: 180, maskable: true },
];

const icon = readIcon(readFileSync(`${kPublic}/favicon.svg`, 'utf8'));
mkdirSync(`${kPublic}/icons`, { recursive: true });
for (const { name, pixels, maskable } of kFiles) {
  writeFileSync(`${kPublic}/icons/${name}`, writePng(pixels, pixels, drawIcon(icon, pixels, { maskable })));
}
