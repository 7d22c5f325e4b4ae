// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the blocks as STL, and prints a line for each: its name, and the centre and direction of its code.
//
//     node make_blocks.mjs FOLDER
import { writeFileSync } from 'node:fs';
import { blocks, stl } from './models.mjs';

for (const block of blocks) {
  writeFileSync(`${process.argv[2]}/${block.name}.stl`, stl(block));
  console.log(block.name, block.centre.join(','), block.normal.join(','));
}
