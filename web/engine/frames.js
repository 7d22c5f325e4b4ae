// SPDX-License-Identifier: GPL-3.0-or-later
// The frames on the canvas: requests for them, and the GPU's progress with the last one.
import { EngineFailure, internal } from './engine_error.js';
import { message } from './message.js';

/** @type {WebGLContextAttributes} */
const kContextAttributes = {
  antialias: false,
  alpha: false,
  depth: false,
  stencil: false,
  powerPreference: 'high-performance',
};

/** @param {HTMLCanvasElement | OffscreenCanvas} canvas */
export function contextOf(canvas) {
  const gl = /** @type {WebGL2RenderingContext | null} */ (canvas.getContext('webgl2', kContextAttributes));
  if (!gl) throw new EngineFailure(internal(message('no-webgl2')));
  gl.getExtension('EXT_color_buffer_float');
  return gl;
}

/** @returns {Promise<void>} */
const nextFrame = () => new Promise((resolve) => onNextFrame(() => resolve()));

/** @param {() => void} run */
function onNextFrame(run) {
  if (typeof requestAnimationFrame === 'function') requestAnimationFrame(run);
  else setTimeout(run, 16);
}

/** Draws frames on demand, at most one at a time. */
export class Frames {
  /**
   * @param {object} options
   * @param {WebGL2RenderingContext | null} options.gl  null: nothing is drawn
   * @param {() => () => boolean} options.draw  draws a frame; its function reports the frame, and returns true to refine it
   * @param {(thrown: unknown) => void} options.onFailure  is called once
   * @param {boolean} options.isVisible  false: draws only when asked directly
   */
  constructor({ gl, draw, onFailure, isVisible }) {
    this.gl_ = /** @type {WebGL2RenderingContext} */ (gl);
    this.draw_ = draw;
    this.onFailure_ = onFailure;
    this.isVisible_ = isVisible;
    this.isRequested_ = false;
    this.isLost = false; // no context any more
    this.waiting_ = 0; // callers of lastDrawn() that wait
    /** @type {WebGLSync | null} */ this.fence_ = null; // signals the end of the last frame
  }

  /** Stops drawing: the context is lost. */
  lose() {
    this.isLost = true;
  }

  /** Requests a frame. Requests before the next frame are merged. */
  request() {
    if (this.isRequested_ || this.isLost || !this.isVisible_) return;
    this.isRequested_ = true;
    onNextFrame(() => {
      this.isRequested_ = false;
      if (this.waiting_ > 0 || this.lastIsUnderWay()) this.request();
      else this.draw();
    });
  }

  /** Draws a frame at once. */
  draw() {
    if (this.isLost) return;
    try {
      const report = this.draw_();
      this.gl_.deleteSync(this.fence_);
      this.fence_ = this.gl_.fenceSync(this.gl_.SYNC_GPU_COMMANDS_COMPLETE, 0);
      this.gl_.flush();
      if (report()) this.request();
    } catch (thrown) {
      this.isLost = true;
      this.onFailure_(thrown);
    }
  }

  /** Tells whether the GPU still draws the last frame. Sending more frames now would delay everything after them. */
  lastIsUnderWay() {
    if (!this.fence_ || this.isLost) return false;
    if (this.gl_.getSyncParameter(this.fence_, this.gl_.SYNC_STATUS) !== this.gl_.SIGNALED) return true;
    this.gl_.deleteSync(this.fence_);
    this.fence_ = null;
    return false;
  }

  /** Waits until the last frame is drawn. Requested frames wait meanwhile: each would make the caller wait again. */
  async lastDrawn() {
    this.waiting_ += 1;
    try {
      while (this.lastIsUnderWay()) await nextFrame();
    } finally {
      this.waiting_ -= 1;
    }
  }

  /** Blocks until the last frame is drawn, by reading a pixel of it: drawing only queues commands. */
  waitForLast() {
    this.gl_.bindFramebuffer(this.gl_.READ_FRAMEBUFFER, null);
    this.gl_.readPixels(0, 0, 1, 1, this.gl_.RGBA, this.gl_.UNSIGNED_BYTE, new Uint8Array(4));
  }
}
