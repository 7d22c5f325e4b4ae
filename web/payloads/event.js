// SPDX-License-Identifier: GPL-3.0-or-later
// Calendar event: iCalendar [RFC 5545], complete or as the bare VEVENT that decoder apps also accept.
import { contentLines, escapeText } from './escaping.js';
import { Findings } from './findings.js';

/** @typedef {import('./types.js').Values} Values */

const kLocalTime = /^\d{4}-\d{2}-\d{2}T\d{2}:\d{2}(:\d{2})?$/;

/**
 * Parses a time in the browser's time zone.
 * @param {Findings} findings @param {string} field @param {string} value
 * @returns {Date | undefined}
 */
function checkTime(findings, field, value) {
  if (value === '') {
    findings.error(field, 'code.needed');
    return undefined;
  }
  const time = kLocalTime.test(value) ? new Date(value) : new Date(NaN);
  if (!Number.isNaN(time.getTime())) return time;
  findings.error(field, 'code.event.time');
  return undefined;
}

/** Formats a time as UTC, which needs no time zone definition. @param {Date} time */
const writeUtc = (time) =>
  time
    .toISOString()
    .replace(/\.\d+Z$/, 'Z')
    .replace(/[-:]/g, '');

/** Returns the FNV-1a hash of the UTF-16 code units. @param {string} text */
function fingerprint(text) {
  let hash = 0x811c9dc5;
  for (let i = 0; i < text.length; i += 1) hash = Math.imul(hash ^ text.charCodeAt(i), 0x01000193) >>> 0;
  return hash.toString(16).padStart(8, '0');
}

/** @param {Values} values @param {Date} start @param {Date} end */
function eventLines({ title, location, description }, start, end) {
  return [
    `SUMMARY:${escapeText(title.trim())}`,
    `DTSTART:${writeUtc(start)}`,
    `DTEND:${writeUtc(end)}`,
    ...(location.trim() === '' ? [] : [`LOCATION:${escapeText(location.trim())}`]),
    ...(description.trim() === '' ? [] : [`DESCRIPTION:${escapeText(description.trim())}`]),
  ];
}

/** @param {string[]} lines @param {Date} start */
function calendarLines(lines, start) {
  // Time stamp and UID depend only on the event, so that the same event gives the same code.
  const stamp = writeUtc(start);
  return [
    'BEGIN:VCALENDAR',
    'VERSION:2.0',
    'PRODID:-//QRelief//EN',
    'BEGIN:VEVENT',
    `UID:${stamp}-${fingerprint(lines.join('\n'))}@qrelief`,
    `DTSTAMP:${stamp}`,
    ...lines,
    'END:VEVENT',
    'END:VCALENDAR',
  ];
}

/** @type {import('./types.js').Content} */
export const event = {
  id: 'event',
  label: 'code.event',
  fields: [
    { id: 'title', label: 'code.event.title', kind: 'text' },
    { id: 'start', label: 'code.event.start', kind: 'datetime' },
    { id: 'end', label: 'code.event.end', kind: 'datetime', hint: 'code.event.zone' },
    { id: 'location', label: 'code.event.location', kind: 'text', optional: true },
    { id: 'description', label: 'code.event.description', kind: 'lines', optional: true },
    {
      id: 'form',
      label: 'code.form',
      kind: 'choice',
      options: [
        { value: 'event', label: 'code.event.short' },
        { value: 'calendar', label: 'code.event.whole' },
      ],
    },
  ],
  build(values) {
    const findings = new Findings();
    if (values.title.trim() === '') findings.error('title', 'code.needed');
    const start = checkTime(findings, 'start', values.start);
    const end = checkTime(findings, 'end', values.end);
    if (start && end && end < start) findings.error('end', 'code.event.endsFirst');
    return findings.built(() => {
      const [from, to] = [/** @type {Date} */ (start), /** @type {Date} */ (end)];
      const lines = eventLines(values, from, to);
      return contentLines(
        values.form === 'calendar' ? calendarLines(lines, from) : ['BEGIN:VEVENT', ...lines, 'END:VEVENT'],
      );
    });
  },
};
