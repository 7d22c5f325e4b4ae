// SPDX-License-Identifier: GPL-3.0-or-later
// Turns the camera to the code when it is engraved, because on a large model the code is too small to see.

/**
 * @typedef {object} FacingOptions
 * @property {Pick<import('../engine/client.js').EngineClient, 'act'>} client
 * @property {Pick<import('./carving.js').Carving, 'started' | 'finished'>} carving
 * @property {Pick<import('../view/view_tools.js').ViewTools, 'onMoved' | 'seesCode' | 'reader'>} tools
 * @property {() => boolean} prefersStill  tells whether the user wants no motion
 */

export class Facing {
  /** @param {FacingOptions} options */
  constructor({ client, carving, tools, prefersStill }) {
    let hasMoved = false; // the user chose another view meanwhile
    tools.onMoved = () => {
      hasMoved = true;
    };
    carving.started.on(() => {
      hasMoved = false;
    });
    carving.finished.on(() => {
      if (hasMoved || prefersStill() || tools.seesCode || tools.reader.shown) return;
      void client.act({ kind: 'face' }).catch(() => {}); // a module that fails tells so elsewhere
    });
  }
}
