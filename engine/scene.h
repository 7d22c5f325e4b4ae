// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/code_on_surface.h"
#include "viewer/orbit_camera.h"
#include "viewer/viewer.h"

namespace qrelief {

/// Colours, row 0 at the top.
struct ColourImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// What can be shown; null or none: it is not there.
struct SceneContents {
  std::shared_ptr<const GpuMesh> model, carved, sizes;
  const CodeOnSurface* code = nullptr;
  const CodeOnSurface* hovered = nullptr;
  std::optional<Vec3> centreMm;
};

/// What is shown, from where, and in which colours. Screen positions as in Engine.
class Scene {
 public:
  /// Needs the GL context; before, and after an error, nothing is drawn.
  Status open(const ViewQuality& quality);
  bool isOpen() const { return viewer_ != nullptr; }

  void update(const SceneContents& contents);
  /// Only the code under the pointer, or the one that is moved: cheaper than update().
  void setGhost(const CodeOnSurface* hovered);
  void setPrint(const CodeOnSurface* code);

  enum class Surface { Model, Carved, Sizes };
  /// Shows that surface from the next update on, where it is there; taken away, the model.
  void show(Surface surface, bool shown);
  Surface surface() const { return surface_; }
  void showDepths(bool shown) { depthsShown_ = shown; }
  /// Cuts the model open across the code. @param offset  in half edges of its square, brought into -1 … 1
  void showSection(bool shown, double offset);

  void resize(double width, double height, double devicePixelRatio);
  void setTheme(bool dark);
  OrbitCamera& camera() { return camera_; }
  const OrbitCamera& camera() const { return camera_; }
  /// "front", "back", "left", "right", "top", "bottom" or "iso"; others are ignored.
  void standardView(const std::string& name);
  void lookAsReader(const ProjectionFrame& frame, double edgeMm);
  /// From the reader's side, with the surroundings in view.
  /// @param diagonalMm  of the model
  void faceCode(const ProjectionFrame& frame, double edgeMm, double diagonalMm);
  /// To where the section is seen.
  void faceSection(const CodeOnSurface& code);

  /// @param always  present again even if nothing changed
  /// @returns whether another call would improve the picture
  Result<bool> draw(bool always);
  /// A place with the code on it; empty where it cannot be drawn.
  /// @param upright  frame whose up is the picture's
  ColourImage picture(const std::shared_ptr<const GpuMesh>& model, const SurfacePrint& print,
                      const ProjectionFrame& upright, int width, int height);

  const Viewer* viewer() const { return viewer_.get(); }

 private:
  std::optional<CuttingPlane> cut(const CodeOnSurface* code) const;

  std::unique_ptr<Viewer> viewer_, pictureViewer_;
  OrbitCamera camera_;
  Surface surface_ = Surface::Model;
  bool depthsShown_ = false, sectionShown_ = false, dark_ = false;
  double sectionOffset_ = 0;
};

}  // namespace qrelief
