// SPDX-License-Identifier: GPL-3.0-or-later
// Geographic position [RFC 5870], with an optional search term for maps on Android.
import { escapeUri } from './escaping.js';
import { Findings } from './findings.js';

const kDecimals = 6; // 0.1 m
const kDegrees = /^[+-]?\d{1,3}([.,]\d+)?\s*°?$/;

/** Parses decimal degrees, with a point or a comma. @param {string} value @returns {number | undefined} */
function parseDegrees(value) {
  const trimmed = value.trim().replace('\u2212', '-');
  return kDegrees.test(trimmed) ? Number.parseFloat(trimmed.replace(',', '.')) : undefined;
}

/** @param {Findings} findings @param {string} field @param {string} value @param {number} most */
function checkDegrees(findings, field, value, most) {
  const degrees = parseDegrees(value);
  if (value.trim() === '') findings.error(field, 'code.needed');
  else if (degrees === undefined) findings.error(field, 'code.place.degrees');
  else if (Math.abs(degrees) > most) findings.error(field, 'code.place.range', { most });
  return degrees ?? 0;
}

/** Formats degrees without trailing zeros and never as “-0” [RFC 5870, 3.4.2]. @param {number} degrees */
const writeDegrees = (degrees) => String(Number(degrees.toFixed(kDecimals)) || 0);

/** @type {import('./types.js').Content} */
export const place = {
  id: 'place',
  label: 'code.place',
  fields: [
    { id: 'latitude', label: 'code.place.latitude', kind: 'decimal', hint: 'code.place.latitudeHint', half: true },
    { id: 'longitude', label: 'code.place.longitude', kind: 'decimal', hint: 'code.place.longitudeHint', half: true },
    { id: 'query', label: 'code.place.query', kind: 'text', hint: 'code.place.queryHint', optional: true },
  ],
  build({ latitude, longitude, query }) {
    const findings = new Findings();
    const lat = checkDegrees(findings, 'latitude', latitude, 90);
    const lon = checkDegrees(findings, 'longitude', longitude, 180);
    return findings.built(
      () =>
        `geo:${writeDegrees(lat)},${writeDegrees(lon)}${query.trim() === '' ? '' : `?q=${escapeUri(query.trim())}`}`,
    );
  },
};
