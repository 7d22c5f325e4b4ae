// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/engine.h"
#include "inspector/inspector_window.h"

namespace qrelief {

/// The engine and, once opened, the inspector's window over it. Its verbs concern both.
class InspectedEngine {
 public:
  using WindowMaker = std::unique_ptr<InspectorWindow> (*)();

  /// @param renderer, hasGl   see Engine
  /// @param withTimerQueries  whether the context can time the passes
  /// @param makeWindow        called when the inspector is opened
  InspectedEngine(const std::string& renderer, bool hasGl, bool withTimerQueries, WindowMaker makeWindow)
      : engine_(renderer, hasGl), withTimerQueries_(withTimerQueries), makeWindow_(makeWindow) {}

  Engine& engine() { return engine_; }

  void resize(double width, double height, double devicePixelRatio);
  /// Shows or hides what `what` names, see Engine::show(). `what` has also {"dark": dark colours}.
  std::string show(const std::string& what);
  /// Starts a job, see Engine::startJob(). `options` of "engrave" has also {"withOverrides"}: use the inspector's
  /// settings where they differ from the page's.
  std::string startJob(const std::string& job, const std::string& options);
  /// Draws a frame. Returns {more, view, inspector}: another call would improve the picture; Engine::viewState(); and
  /// InspectorWindow::state(), null if it is not shown.
  std::string draw();

  /// Tells the inspector of an event. Returns {takes}: the inspector uses the event, so that nothing else may. No
  /// effect before there is a window; keys, pointer and picks also need it to be shown.
  /// @param event  {"kind": "open"}: makes the window, and times the passes from then on
  ///               {"kind": "show", "shown"}
  ///               {"kind": "texts", "texts": {…}}: sets the translations, keyed by the English texts
  ///               {"kind": "area", "x", "y", "width", "height"}, {"kind": "pointer", "x", "y", "buttons", "wheel"},
  ///               {"kind": "key", "key", "control", "shift"}, {"kind": "pick", "x", "y"}: see InspectorWindow
  std::string inspector(const std::string& event);
  /// Sets the letters, see InspectorWindow.
  /// @param metrics  six numbers per glyph: code point, width, height, left, top, advance
  void inspectorGlyphs(float lineHeight, const std::vector<float>& metrics, std::vector<std::uint8_t> alpha);

 private:
  void open();
  void showWindow(bool isShown);
  InspectorWindow* shownWindow() const { return isShown_ ? window_.get() : nullptr; }

  Engine engine_;
  bool withTimerQueries_;
  WindowMaker makeWindow_;
  std::unique_ptr<InspectorWindow> window_;
  bool isShown_ = false;
  bool hasGone_ = false;  // the window was hidden since the last frame
  bool dark_ = false;
  Vec2 size_{1};
  double devicePixelRatio_ = 1;
};

}  // namespace qrelief
