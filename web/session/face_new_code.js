// SPDX-License-Identifier: GPL-3.0-or-later
// Turns the camera to the code when it is engraved, because on a large model the code is too small to see.

/**
 * Turns the camera to each new code, unless the user has chosen another view meanwhile.
 * @param {object} options
 * @param {Pick<import('../engine/client.js').EngineClient, 'act'>} options.client
 * @param {Pick<import('./carving.js').Carving, 'started' | 'finished'>} options.carving
 * @param {Pick<import('../view/view_tools.js').ViewTools, 'onMoved' | 'seesCode' | 'reader'>} options.tools
 * @param {() => boolean} options.prefersStill  tells whether the user wants no motion
 */
export function faceNewCodes({ client, carving, tools, prefersStill }) {
  let hasMoved = false;
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
