// SPDX-License-Identifier: GPL-3.0-or-later
// Checks a model and a list before anything is engraved: node plan.js MODEL LIST
import { readFile } from 'node:fs/promises';
import { loadPlanner, sentence } from 'qrelief';

const [model, list] = process.argv.slice(2);
const planner = await loadPlanner();
const { sizeMm, engravable } = planner.model(await readFile(model), model);
console.log(`${model}: ${sizeMm.join(' × ')} mm, ${engravable ? 'a solid' : 'no solid'}`);
const { rows, version, modules, problems } = planner.planBatch(await readFile(list));
if (problems.length > 0) throw new Error(problems.map((problem) => sentence(problem)).join(' '));
const { settings } = planner.batchRow(0);
const symbol = planner.symbol(settings);
if ('letters' in symbol) throw new Error('the list asks for texts without codes');
const leastMm = (symbol.leastModuleMm ?? 0) * (modules ?? 0);
console.log(`${rows} codes of version ${version}, level ${symbol.ecc}, at least ${leastMm.toFixed(1)} mm wide`);
