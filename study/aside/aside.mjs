// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the largest viewing angles at which a code on a cylinder decodes, however it is made: painted in black,
// projected as we carve it, wrapped around the cylinder like a label, and half-way between, for versions 2 to 10 and
// each npm decoder.
//
//     node aside.mjs PEERS FILE.csv       PEERS: the folder in which the npm packages are installed
//
// The cylinder is upright and the code faces the reader, who walks around it at a constant distance: seven symbol
// widths, as 250 mm for 35 mm. The arc is the part of the circumference that the symbol's width covers. A pixel is a
// quarter of a module at most; blur 0.3 modules, shot noise of 2 % at white, seeded. Tilts rise in steps of 5° until
// two in a row do not decode; the table has the last tilt that decoded before; empty: not even from the front.
import { createRequire } from 'node:module';
import { writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { npmDecoders, pictureOf } from '../decoders.mjs';

const [peers, file] = process.argv.slice(2);
const require = createRequire(`${peers}/package.json`);
const encode = (await import(pathToFileURL(require.resolve('qr')).href)).default;

const kText = 'https://example.org/p/1';
const kVersions = [2, 3, 4, 5, 6, 7, 8, 10];
const kArcsDeg = [20, 40, 60, 80, 100];
const kLayouts = { projected: 0, halfway: 0.5, wrapped: 1 };
const kEyeWidths = 250 / 35,
  kPixelsPerModule = 6,
  kSamples = 3,
  kBlurModules = 0.3,
  kNoise = 0.02;
const kPaper = 0.85,
  kInk = 0.05,
  kBackground = 0.35;
const kStepDeg = 5,
  kMostDeg = 70,
  kQuietModules = 4;

/** @returns {() => number} uniform numbers in [0, 1): mulberry32 */
function randomFrom(/** @type {number} */ seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/**
 * Returns the position in the symbol of a point of the cylinder, in symbol widths from its middle.
 * @param {number} angle   about the axis, 0 in front, radians
 * @param {number} radius  in symbol widths
 */
function placeInSymbol(
  angle,
  /** @type {number} */ height,
  /** @type {number} */ radius,
  /** @type {number} */ wrapped,
) {
  const depth = radius * (1 - Math.cos(angle)); // behind the tangent plane at the front
  const scale = kEyeWidths / (kEyeWidths + depth);
  const projected = [radius * Math.sin(angle) * scale, height * scale];
  return [projected[0] + wrapped * (radius * angle - projected[0]), projected[1] + wrapped * (height - projected[1])];
}

/** Returns the light that the reader sees in a direction. */
function lightOf(
  /** @type {boolean[][]} */ symbol,
  /** @type {number} */ radius,
  /** @type {number} */ wrapped,
  /** @type {number} */ tilt,
  /** @type {number} */ right,
  /** @type {number} */ up,
) {
  // Axis at the origin, code in front at z = radius; the reader looks at its middle.
  const eye = [kEyeWidths * Math.sin(tilt), 0, radius + kEyeWidths * Math.cos(tilt)];
  const ray = [
    right * Math.cos(tilt) - kEyeWidths * Math.sin(tilt),
    up,
    -right * Math.sin(tilt) - kEyeWidths * Math.cos(tilt),
  ];
  const a = ray[0] ** 2 + ray[2] ** 2,
    b = eye[0] * ray[0] + eye[2] * ray[2],
    c = eye[0] ** 2 + eye[2] ** 2 - radius ** 2;
  const root = b * b - a * c;
  if (root < 0) return kBackground;
  const t = (-b - Math.sqrt(root)) / a;
  const [x, y, z] = [eye[0] + t * ray[0], t * ray[1], eye[2] + t * ray[2]];
  const [u, v] = placeInSymbol(Math.atan2(x, z), y, radius, wrapped);
  const column = Math.floor((u + 0.5) * symbol.length),
    row = Math.floor((0.5 - v) * symbol.length);
  return symbol[row]?.[column] ? kInk : kPaper;
}

function pictureFrom(
  /** @type {boolean[][]} */ symbol,
  /** @type {number} */ radius,
  /** @type {number} */ wrapped,
  /** @type {number} */ tilt,
) {
  const across = symbol.length + 2 * kQuietModules + 4,
    width = kPixelsPerModule * across,
    fine = width * kSamples;
  const sharp = new Float32Array(fine * fine);
  for (let row = 0; row < fine; row += 1) {
    for (let column = 0; column < fine; column += 1) {
      const [right, up] = [column, fine - 1 - row].map((at) => (((at + 0.5) / fine - 0.5) * across) / symbol.length);
      sharp[row * fine + column] = lightOf(symbol, radius, wrapped, tilt, right, up);
    }
  }
  return seenByCamera(sharp, fine, width);
}

/** Simulates a camera: blur along both axes, means over pixels, noise, gamma. */
function seenByCamera(/** @type {Float32Array} */ sharp, /** @type {number} */ fine, /** @type {number} */ width) {
  const sigma = kBlurModules * kPixelsPerModule * kSamples,
    reach = Math.ceil(3 * sigma);
  const weights = Array.from({ length: 2 * reach + 1 }, (_, i) => Math.exp(-(((i - reach) / sigma) ** 2) / 2));
  const sum = weights.reduce((a, b) => a + b);
  const along = (/** @type {Float32Array} */ from, /** @type {number} */ step, /** @type {number} */ other) => {
    const to = new Float32Array(from.length);
    for (let line = 0; line < fine; line += 1) {
      for (let at = 0; at < fine; at += 1) {
        let value = 0;
        for (let k = -reach; k <= reach; k += 1)
          value += weights[k + reach] * from[line * other + Math.min(fine - 1, Math.max(0, at + k)) * step];
        to[line * other + at * step] = value / sum;
      }
    }
    return to;
  };
  const soft = along(along(sharp, 1, fine), fine, 1);
  const random = randomFrom(1);
  const grey = new Uint8Array(width * width);
  for (let i = 0; i < grey.length; i += 1) {
    const row = Math.floor(i / width) * kSamples,
      column = (i % width) * kSamples;
    let mean = 0;
    for (let k = 0; k < kSamples * kSamples; k += 1)
      mean += soft[(row + Math.floor(k / kSamples)) * fine + column + (k % kSamples)] / kSamples ** 2;
    const noise = kNoise * Math.sqrt(3 * mean) * (2 * random() - 1); // shot noise: its square grows with the light
    grey[i] = Math.round(255 * Math.min(1, Math.max(0, mean + noise)) ** (1 / 2.2));
  }
  return pictureOf(grey, width, width);
}

const decoders = Object.entries(await npmDecoders(peers));
const lines = ['reader,version,layout,arc_deg,tilt_deg,failed'];
for (const version of kVersions) {
  const symbol = encode(kText, 'raw', { ecc: 'medium', version, border: 1 })
    .slice(1, -1)
    .map((/** @type {boolean[]} */ row) => row.slice(1, -1));
  for (const [layout, wrapped] of Object.entries(kLayouts)) {
    for (const arc of kArcsDeg) {
      const radius = 180 / (Math.PI * arc); // in symbol widths
      const last = decoders.map(() => /** @type {number | undefined} */ (undefined)),
        missed = decoders.map(() => 0);
      for (let tilt = 0; tilt <= kMostDeg && missed.some((count) => count < 2); tilt += kStepDeg) {
        const picture = pictureFrom(symbol, radius, wrapped, (tilt * Math.PI) / 180);
        for (const [k, [, decode]] of decoders.entries()) {
          if (missed[k] >= 2) continue;
          if ((await decode(picture)) === kText) {
            if (missed[k] === 0) last[k] = tilt;
          } else {
            missed[k] += 1;
          }
        }
      }
      for (const [k, [name]] of decoders.entries()) lines.push(`${name},${version},${layout},${arc},${last[k] ?? ''},`);
    }
  }
  console.error(`version ${version}`);
}
writeFileSync(file, `${lines.join('\n')}\n`);
