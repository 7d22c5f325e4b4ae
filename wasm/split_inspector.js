#!/usr/bin/env node
// SPDX-License-Identifier: GPL-3.0-or-later
// Moves the functions that only the inspector needs, mostly Dear ImGui, from a linked module into one of their own,
// which is loaded when the inspector is opened:
//   split_inspector.js MODULE.wasm INSPECTOR.wasm
// Both then share one memory and one table of functions (wasm-split of Binaryen). A call to a function that is not
// loaded yet would arrive in the import namespace "inspector". There is none, because only the inspector's own
// functions lead to the moved ones.
import { execFileSync } from 'node:child_process';
import { renameSync, rmSync, writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';

/** Functions called through the table, and only once the inspector is loaded. */
const kEntrance = /^(qrelief::Inspector::|ImGui|Im[A-Z]|qrelief::makeInspector\\28\\29)/;

/**
 * @typedef {object} CallGraph
 * @property {Map<string, string[]>} callees  by caller: direct calls
 * @property {string[]} entrances  exported, or in the table of functions
 * @property {Set<string>} imports
 */

/**
 * @param {string} dot  output of `wasm-opt --print-call-graph`
 * @returns {CallGraph}
 */
export function readCallGraph(dot) {
  /** @type {CallGraph} */ const graph = { callees: new Map(), entrances: [], imports: new Set() };
  for (const line of dot.split('\n')) {
    const call = /^ {2}"(.+)" -> "(.+)"; \/\/ call$/.exec(line);
    const node = /^ {2}"(.+)" \[style="filled(, rounded)?"(?:, fillcolor="(\w+)")?\];/.exec(line);
    if (call) graph.callees.set(call[1], [...(graph.callees.get(call[1]) ?? []), call[2]]);
    else if (node?.[3] === 'turquoise') graph.imports.add(node[1]);
    else if (node && (node[2] || node[3] === 'gray')) graph.entrances.push(node[1]);
  }
  return graph;
}

/**
 * Returns all functions that are called, directly or not.
 * @param {CallGraph} graph
 * @param {string[]} from
 * @param {Set<string>} without  functions to stop at
 */
function reached({ callees }, from, without) {
  const names = new Set(from);
  const open = [...from];
  for (let name = open.pop(); name !== undefined; name = open.pop()) {
    for (const callee of callees.get(name) ?? []) {
      if (names.has(callee) || without.has(callee)) continue;
      names.add(callee);
      open.push(callee);
    }
  }
  return names;
}

/**
 * Returns the functions that can be reached only through the inspector's entrances.
 * @param {CallGraph} graph
 */
export function onlyForInspector(graph) {
  const inspectors = new Set(graph.entrances.filter((name) => kEntrance.test(name)));
  const others = reached(
    graph,
    graph.entrances.filter((name) => !inspectors.has(name)),
    new Set(),
  );
  const own = [...inspectors].filter((name) => !others.has(name));
  return [...reached(graph, own, others)].filter((name) => !graph.imports.has(name));
}

/** @param {string[]} argv */
function main([module, inspector]) {
  const dot = execFileSync('wasm-opt', ['--all-features', '--print-call-graph', module, '-o', '/dev/null'], {
    encoding: 'utf8',
    maxBuffer: 1 << 28,
  });
  const later = onlyForInspector(readCallGraph(dot));
  if (later.length < 100)
    throw new Error(`only ${later.length} functions are the inspector's alone: are there names in ${module}?`);
  const list = `${module}.later`;
  const first = `${module}.first`;
  writeFileSync(list, later.join('\n'));
  execFileSync(
    'wasm-split',
    [
      '--all-features',
      module,
      `--split-funcs=@${list}`,
      '--export-prefix=%',
      '--placeholder-namespace=inspector',
      `--primary-output=${first}`,
      `--secondary-output=${inspector}`,
    ],
    { stdio: 'inherit' },
  );
  renameSync(first, module);
  rmSync(list);
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) main(process.argv.slice(2));
