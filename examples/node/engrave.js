// SPDX-License-Identifier: GPL-3.0-or-later
// Engraves a link into a model at its best spot, and writes OUT.stl and its report OUT.json:
// node engrave.js MODEL LINK OUT.stl
import { readFile, writeFile } from 'node:fs/promises';
import { engrave, sentence } from 'qrelief';

const [model, text, output] = process.argv.slice(2);
const { verdict, report, files } = await engrave(await readFile(model), {
  fileName: model,
  settings: { text },
  onProgress: ({ stage, fraction }) => process.stderr.write(`${sentence(stage)} ${Math.round(100 * fraction)} %\n`),
});
if (files.stl) await writeFile(output, files.stl);
await writeFile(output.replace(/(\.stl)?$/, '.json'), JSON.stringify(report));
console.log(`${output}: ${verdict.passed ? 'passed' : 'failed'}, ${report.size.symbolMm.toFixed(1)} mm`);
