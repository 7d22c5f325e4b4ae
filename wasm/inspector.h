// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "wasm/engine.h"
#include "wasm/map_picture.h"

struct ImGuiContext;

namespace qrelief {

/// A window over the canvas, drawn by Dear ImGui, that shows what the engraving works with: normals, heights,
/// luminance, depths, and what each stage cost. Only looks, changes nothing. Made on first use; needs the engine's GL
/// context.
class Inspector {
 public:
  Inspector();
  ~Inspector();
  Inspector(const Inspector&) = delete;
  Inspector& operator=(const Inspector&) = delete;

  /// @param width, height  CSS pixels
  void resize(double width, double height, double devicePixelRatio);
  void setTheme(bool dark);

  /// @param buttons  as in PointerEvent.buttons: 1 = left, 2 = right, 4 = middle
  /// @param wheel    lines, up positive
  /// @returns whether the pointer is the inspector's and must not move the camera
  bool pointer(double x, double y, int buttons, double wheel);

  /// Draws over what the canvas shows. @returns whether another frame is wanted
  bool draw(const Engine& engine);

 private:
  enum class Map { Normals, Heights, Luminance, Depths };
  void buildFont();
  void showMap(const Engine& engine, Map map);
  void showValueUnderPointer(Map map, double across, double down) const;
  void showTimings(const Engine& engine) const;
  void refresh(const Engine& engine, Map map);

  ImGuiContext* context_ = nullptr;
  double devicePixelRatio_ = 1;
  bool fontIsStale_ = true;
  bool pressed_ = false;         // since the last frame, so that no short click is lost
  bool releasePending_ = false;  // takes effect after the frame that saw the press
  Vec2 windowMin_{0}, windowMax_{0};
  int framesWanted_ = 0;  // ImGui lays out what has changed only in the frame after
  double lastFrameMs_ = 0;

  std::optional<MapPicture> picture_;
  Map shown_ = Map::Normals;
  const void* source_ = nullptr;  // the texture that `picture_` was made of
  double madeMs_ = 0;
  bool madeOfResult_ = false;
};

}  // namespace qrelief
