// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/code_on_surface.h"
#include "engine/construction.h"
#include "verification/ink.h"
#include "viewer/orbit_camera.h"
#include "viewer/viewer.h"

namespace qrelief {

/// A colour picture, row 0 at the top.
struct ColourImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Everything that can be shown. Null or none: does not exist.
struct SceneContents {
  std::shared_ptr<const GpuMesh> model, carved, sizes;
  const CodeOnSurface* code = nullptr;
  const CodeOnSurface* hovered = nullptr;
  const Decal* print = nullptr;  ///< of the carved model; takes its place
  std::optional<Vec3> centreMm;
  std::optional<Ink> ink, carvedInk;  ///< materials of the code that is wanted, or carved; none: no code in colour
  bool isColoured = false;            ///< the model's file has colours
  std::optional<BuildPlate> plate;    ///< under the model as it is printed
  const Construction* construction = nullptr;
};

/// Chooses what is shown, from which camera and in which colours. Screen positions as in Engine.
class Scene {
 public:
  /// Makes the viewer. Needs the GL context. Before this call, and after an error, nothing is drawn.
  Status open(const ViewQuality& quality);
  bool isOpen() const { return viewer_ != nullptr; }

  void update(const SceneContents& contents);
  /// Updates only the hovered code, or only the moved one: cheaper than update().
  void setGhost(const CodeOnSurface* hovered);
  void setDecal(const CodeOnSurface* code);
  void setPlate(std::optional<BuildPlate> plate);

  enum class Surface { Model, Carved, Sizes };
  /// Shows that surface from the next update on, if it exists. With `shown` false, shows the model.
  void show(Surface surface, bool isShown);
  Surface surface() const { return surface_; }
  void showDepths(bool isShown) { depthsShown_ = isShown; }
  void showPlate(bool isShown);
  /// Returns the plate as it is shown. A phone sees none.
  std::optional<BuildPlate> shownPlate() const;
  /// Shows how the code was placed, from the next update on.
  void showConstruction(bool isShown) { constructionShown_ = isShown; }
  bool constructionShown() const { return constructionShown_; }
  void setConstruction(const Construction* construction);
  /// Shows the model in the light that setLight() gives next, if there is one, instead of the viewer's own.
  void showLampLight(bool isShown) { lampLightShown_ = isShown; }
  void setLight(std::optional<LampLight> light);
  /// Cuts the model open across the code. @param offset  in half edges of its square, clamped to -1 … 1
  void showSection(bool isShown, double offset);

  void resize(double width, double height, double devicePixelRatio);
  void setTheme(bool dark);
  OrbitCamera& camera() { return camera_; }
  const OrbitCamera& camera() const { return camera_; }
  /// Turns the camera to "front", "back", "left", "right", "top", "bottom" or "iso"; ignores other names.
  void standardView(const std::string& name);
  /// Looks as a phone does, until freeLook().
  void lookAsReader(const ProjectionFrame& frame, double edgeMm);
  void freeLook();
  bool isReaders() const { return isReaders_; }
  /// Looks from the viewer's side of the code, with the surroundings in view.
  /// @param diagonalMm  of the model
  void faceCode(const ProjectionFrame& frame, double edgeMm, double diagonalMm);
  /// Turns the camera to where the section is visible.
  void faceSection(const CodeOnSurface& code);
  /// Turns the camera to where the construction is visible.
  void faceConstruction(const Construction& construction);

  /// @param always  present again even if nothing changed
  /// @returns true if another call would improve the picture
  Result<bool> draw(bool always);
  /// Draws a place with the code on it; empty if it cannot be drawn.
  /// @param upright  frame whose up axis is the picture's
  ColourImage picture(const std::shared_ptr<const GpuMesh>& model, const Decal& decal, const ProjectionFrame& upright,
                      int width, int height);

  const Viewer* viewer() const { return viewer_.get(); }

 private:
  void setReaders(bool isReaders);
  void setLines();
  std::optional<CuttingPlane> cut(const CodeOnSurface* code) const;

  std::unique_ptr<Viewer> viewer_, pictureViewer_;
  OrbitCamera camera_;
  SurfaceColours colours_;
  std::optional<BuildPlate> plate_;
  LineDrawing construction_;
  Surface surface_ = Surface::Model;
  bool depthsShown_ = false, sectionShown_ = false, plateShown_ = false, constructionShown_ = false,
       lampLightShown_ = false, isReaders_ = false, dark_ = false;
  double sectionOffset_ = 0, devicePixelRatio_ = 1;
};

}  // namespace qrelief
