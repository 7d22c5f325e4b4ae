#!/usr/bin/env node
// SPDX-License-Identifier: GPL-3.0-or-later
// Lists the verbs of web/engine/verbs.js as C++ macros, one per class of the module, for bindings.cpp:
//   list_verbs.js HEADER.h
import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { pathToFileURL } from 'node:url';
import { kBatchVerbs, kFactVerbs, kInnerVerbs, kPageVerbs, kPrintVerbs, kTrackVerbs } from '../web/engine/verbs.js';

/** @typedef {Record<string, import('../web/engine/verbs.js').Verb<any>>} Rows */

/** The macros, each with the C++ class of its rows. @type {[string, string, Rows][]} */
const kTables = [
  ['QRELIEF_ENGINE_VERBS', 'Engine', { ...kPageVerbs, ...kInnerVerbs }],
  ['QRELIEF_PRINT_VERBS', 'PrintedCode', kPrintVerbs],
  ['QRELIEF_BATCH_VERBS', 'PlannedBatch', kBatchVerbs],
  ['QRELIEF_TRACK_VERBS', 'TrackedBatch', kTrackVerbs],
  ['QRELIEF_FACT_VERBS', 'Facts', kFactVerbs],
];

/** Returns a macro that applies another one to the class and name of each row. @param {string} macro @param {string} ownClass @param {Rows} rows */
export const macroOf = (macro, ownClass, rows) =>
  [`#define ${macro}(verb)`, ...Object.entries(rows).map(([name, { of = ownClass }]) => `  verb(${of}, ${name})`)].join(
    ' \\\n',
  );

if (process.argv[2] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  mkdirSync(dirname(process.argv[2]), { recursive: true });
  writeFileSync(process.argv[2], `#pragma once\n${kTables.map((table) => macroOf(...table)).join('\n')}\n`);
}
