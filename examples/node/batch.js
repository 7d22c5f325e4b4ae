// SPDX-License-Identifier: GPL-3.0-or-later
// Engraves each code of a list into a copy of a model, all at the best spot for the first: node batch.js MODEL LIST
// The list is CSV or JSON lines, with the column text. Writes the files that its rows name, into this folder.
import { readFile, writeFile } from 'node:fs/promises';
import { Engine, loadPlanner, sentence } from 'qrelief';

const [model, list] = process.argv.slice(2);
const settings = { preset: /** @type {const} */ ('robust') }; // of all rows
const planner = await loadPlanner();
const { rows, problems } = planner.planBatch(await readFile(list), { settings });
if (problems.length > 0) throw new Error(problems.map((problem) => sentence(problem)).join(' '));
const engine = await Engine.start();
try {
  await engine.loadModel(await readFile(model), model);
  for (let index = 0; index < rows; index += 1) {
    const row = planner.batchRow(index);
    await engine.configure({ ...settings, text: row.text, ...row.settings });
    if (index === 0) {
      await engine.findSpots();
      await engine.chooseSpot(0);
    }
    const { verdict } = await engine.engrave();
    for (const { name, bytes } of await engine.exportFiles(row.file)) await writeFile(name, bytes);
    console.log(`${row.file}: ${verdict.passed ? 'passed' : 'failed'}. ${sentence(verdict.reads.summary)}`);
  }
} finally {
  engine.end();
}
