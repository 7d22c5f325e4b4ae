// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import test from 'node:test';

import { Frames } from './frames.js';

/** A GPU that takes a few looks at its fence to draw a frame. @param {number} looks */
function slowGpu(looks) {
  let left = 0;
  return /** @type {WebGL2RenderingContext} */ (
    /** @type {unknown} */ ({
      SIGNALED: 1,
      fenceSync: () => {
        left = looks;
        return {};
      },
      deleteSync: () => {},
      flush: () => {},
      getSyncParameter: () => (left-- > 0 ? 0 : 1),
    })
  );
}

for (const looks of [3, 4])
  // either the requested frame or the one who waits looks last
  test(`who waits for the last frame waits for no frame after it: ${looks} looks`, async () => {
    let drawn = 0;
    const frames = new Frames({
      gl: slowGpu(looks),
      draw: () => {
        drawn += 1;
        return () => drawn < 8; // refines
      },
      onFailure: (thrown) => assert.fail(String(thrown)),
      isVisible: true,
    });
    frames.draw();
    assert.ok(frames.lastIsUnderWay());
    await frames.lastDrawn();
    assert.equal(drawn, 1);
    assert.ok(!frames.lastIsUnderWay());
    while (drawn < 8) await new Promise((resolve) => setTimeout(resolve, 5)); // refinement goes on afterwards
  });
