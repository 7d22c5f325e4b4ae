// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/engine.h"
#include "inspector/request_overrides.h"

namespace qrelief {

/// Glyphs for the inspector, drawn by the browser, in device pixels.
struct DrawnGlyphs {
  struct Glyph {
    std::uint32_t codePoint;
    int width, height;
    float left, top, advance;  ///< from the pen and from the line's upper edge
  };
  float lineHeight = 16;
  std::vector<Glyph> glyphs;
  std::vector<std::uint8_t> alpha;  ///< glyph after glyph, row-major
};

/// A window over the canvas that shows how an engraving came about: every channel of the G-buffer, depth and luminance
/// pass by pass, convergence, times, and the settings to tune. Lengths are CSS pixels. It is an interface because only
/// the browser's build can draw it.
class InspectorWindow {
 public:
  virtual ~InspectorWindow() = default;

  virtual void resize(double width, double height, double devicePixelRatio) = 0;
  /// Sets where the window opens, and its largest size then: the part of the canvas that no control of the page covers.
  virtual void setFreeArea(double x, double y, double width, double height) = 0;
  virtual void setTheme(bool dark) = 0;
  virtual void setGlyphs(DrawnGlyphs glyphs) = 0;

  /// Handles a pointer event.
  /// @param buttons  as in PointerEvent.buttons: 1 = left, 2 = right, 4 = middle
  /// @param wheel    lines, up positive
  /// @returns true if the inspector uses the event, so that it must not move the camera
  virtual bool pointer(double x, double y, int buttons, double wheel) = 0;
  /// Handles a pressed key. @param key  as in KeyboardEvent.key
  virtual void key(const std::string& key, bool control, bool shift) = 0;
  /// Handles a click on the model. @returns true if it hit a submodule of the engraved code, which is now selected
  virtual bool pickSubmodule(const Engine& engine, double x, double y) = 0;

  /// Draws over the canvas. @returns true if it needs another frame
  virtual bool draw(const Engine& engine) = 0;

  /// Returns JSON: {tab, channel, pass, passes, selected: null | {row, column, role, carved, LS, AL, G, depthMm,
  /// limitMm}, overridden, overrides, engraveAsked, keyboard, cursor, window: [x, y, width, height], figures:
  /// [[text]], controls: {name: [x, y, width, height]}}. `engraveAsked` counts the presses of "Engrave again";
  /// `keyboard` is true while keys go to the inspector; `figures` are the texts and numbers drawn last, in rows.
  virtual std::string state() const = 0;
  virtual const RequestOverrides& overrides() const = 0;
};

/// Makes the window. Needs the engine's GL context.
std::unique_ptr<InspectorWindow> makeInspector();

}  // namespace qrelief
