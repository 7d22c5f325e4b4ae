// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { onlyForInspector, readCallGraph } from './split_inspector.js';

const kOpen = String.raw`qrelief::makeInspector\28\29`;
const kDraw = String.raw`qrelief::Inspector::draw\28qrelief::Engine\20const&\29`;

/** Writes a graph like `wasm-opt --print-call-graph`: a key, then a line for each function, its kinds and its calls. */
const graphOf = (
  /** @type {{ plain: string[], table: string[], exported: string[], calls: [string, string][] }} */ graph,
) =>
  [
    'digraph call {',
    '  subgraph cluster_key {',
    '    "Export" [style="filled", fillcolor="gray"];',
    '    "A" -> "B" [style="filled, rounded", label = "Direct Call"];',
    '  }',
    '  "fimport$1" [style="filled", fillcolor="turquoise"];',
    ...[...graph.plain, ...graph.table, ...graph.exported].map(
      (name) => `  "${name}" [style="filled", fillcolor="white"];`,
    ),
    ...graph.exported.map((name) => `  "${name}" [style="filled", fillcolor="gray"];`),
    ...graph.table.map((name) => `  "${name}" [style="filled, rounded"];`),
    ...graph.calls.map(([caller, callee]) => `  "${caller}" -> "${callee}"; // call`),
    '}',
  ].join('\n');

test('Functions that only the inspector calls move with it, whatever their names', () => {
  const graph = readCallGraph(
    graphOf({
      plain: ['ImGui::Begin', 'ImVector::~ImVector', 'colours', 'deeper', 'unused'],
      table: [kOpen, kDraw, 'qrelief::Viewer::draw'],
      exported: ['__wasm_call_ctors'],
      calls: [
        [kOpen, 'ImGui::Begin'],
        [kDraw, 'ImGui::Begin'],
        [kDraw, 'colours'],
        ['colours', 'deeper'],
        ['colours', 'fimport$1'],
        [kDraw, 'ImVector::~ImVector'],
        ['qrelief::Viewer::draw', 'ImVector::~ImVector'], // two functions merged into one
        ['__wasm_call_ctors', 'qrelief::Viewer::draw'],
      ],
    }),
  );
  assert.deepEqual(onlyForInspector(graph).sort(), ['ImGui::Begin', 'colours', 'deeper', kOpen, kDraw].sort());
});

test('An entry point of the inspector with other callers stays, with all its callees', () => {
  const graph = readCallGraph(
    graphOf({
      plain: ['ImGui::Begin', 'colours'],
      table: [kOpen, kDraw],
      exported: ['main'],
      calls: [
        ['main', kDraw],
        [kDraw, 'ImGui::Begin'],
        [kOpen, 'ImGui::Begin'],
        [kOpen, 'colours'],
      ],
    }),
  );
  assert.deepEqual(onlyForInspector(graph).sort(), ['colours', kOpen].sort());
});
