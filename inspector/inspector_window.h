// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/engine.h"
#include "settings/request_overrides.h"

namespace qrelief {

/// Letters for the inspector as the browser draws them, in device pixels.
struct DrawnGlyphs {
  struct Glyph {
    std::uint32_t codePoint;
    int width, height;
    float left, top, advance;  ///< from the pen and from the line's upper edge
  };
  float lineHeight = 16;
  std::vector<Glyph> glyphs;
  std::vector<std::uint8_t> alpha;  ///< of one glyph after the other, row-major
};

/// A window over the canvas for those who want to know how an engraving came about: every channel of the G-buffer,
/// depth and luminance pass by pass, convergence, times, and what can be tuned. Lengths are CSS pixels. An interface,
/// as what is behind it is loaded later (split_inspector.js): nothing else may be called directly.
class InspectorWindow {
 public:
  virtual ~InspectorWindow() = default;

  virtual void resize(double width, double height, double devicePixelRatio) = 0;
  /// Where the window opens, and how large it may be then: the part of the canvas that no control of the page covers.
  virtual void setFreeArea(double x, double y, double width, double height) = 0;
  virtual void setTheme(bool dark) = 0;
  virtual void setGlyphs(DrawnGlyphs glyphs) = 0;

  /// @param buttons  as in PointerEvent.buttons: 1 = left, 2 = right, 4 = middle
  /// @param wheel    lines, up positive
  /// @returns whether the pointer is the inspector's and must not move the camera
  virtual bool pointer(double x, double y, int buttons, double wheel) = 0;
  /// A key that went down. @param key  as in KeyboardEvent.key
  virtual void key(const std::string& key, bool control, bool shift) = 0;
  /// A click on the model. @returns whether a submodule of the engraved code is there, and is shown now
  virtual bool pickSubmodule(const Engine& engine, double x, double y) = 0;

  /// Draws over what the canvas shows. @returns whether another frame is wanted
  virtual bool draw(const Engine& engine) = 0;

  /// JSON: {tab, channel, pass, passes, selected: null | {row, column, role, carved, LS, AL, G, depthMm, limitMm},
  /// overridden, overrides, engraveAsked, keyboard, cursor, window: [x, y, width, height],
  /// controls: {name: [x, y, width, height]}}; `engraveAsked` counts the presses of "Engrave again", `keyboard` says
  /// whether keys are the inspector's.
  virtual std::string state() const = 0;
  virtual const RequestOverrides& overrides() const = 0;
};

/// Needs the engine's GL context, and the inspector's part of the module.
std::unique_ptr<InspectorWindow> makeInspector();

}  // namespace qrelief
