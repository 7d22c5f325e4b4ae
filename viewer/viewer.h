// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "gl/objects.h"
#include "math/frame.h"
#include "projection/eye_reach.h"
#include "render/gpu_mesh.h"
#include "viewer/orbit_camera.h"

namespace qrelief {

/// A square picture that the viewer shows on the surface, carried there by a frame's central projection.
struct SurfacePrint {
  ProjectionFrame frame;
  double edgeMm = 0;              ///< of the picture on the QR plane
  int size = 0;                   ///< texels along an edge
  std::vector<std::uint8_t> ink;  ///< size², row 0 at the top; 255 = dark
  /// What takes the print: what of its square is not reached has a warning colour, and what is hidden none. None: all
  /// that faces the eye takes it. Its centre and normal are the frame's.
  std::shared_ptr<const EyeReach> reach;
};

/// What lies on the side of the plane that the normal points to is cut away.
struct CuttingPlane {
  Vec3 point{0};
  Vec3 normal{0, 0, 1};  ///< unit
};

/// Which values of a mesh are shown as colours.
enum class HeatShown { None, All, AboveZero };

/// What a frame may cost. The defaults suit a software renderer; `suitedTo` knows better ones.
struct ViewQuality {
  double movingScale = 0.5;  ///< resolution while something changes, 0 … 1
  int movingSteps = 3;       ///< occlusion samples on each side of a slice while something changes
  int stillSteps = 5;        ///< the same at rest
  int stillSamples = 16;     ///< pictures that are averaged at rest; multiples of 16 leave no pattern
  double mostPixels = 8e5;   ///< larger canvases are drawn at a lower resolution and scaled up
  double settleMs = 120;     ///< without a change before refinement starts

  static ViewQuality suitedTo(const gl::Capabilities& capabilities);
};

/// Milliseconds from the last change to the finished picture, and the frames it took; for the inspector.
struct ViewStatistics {
  double coarseFrameMs = 0;   ///< mean interval between frames while something changed
  int samples = 0;            ///< averaged so far
  int width = 0, height = 0;  ///< of the last frame's G-buffer
};

/// Draws a mesh by deferred shading: G-buffer, horizon-based occlusion, lighting. Coarsely while something changes; at
/// rest it averages jittered full-resolution pictures, which smooths edges and occlusion alike.
///
/// Needs the GL context current that it was made in.
class Viewer {
 public:
  static Result<Viewer> create(const ViewQuality& quality = {});

  /// Size of what is drawn to, in device pixels.
  void resize(int width, int height);
  /// @param mesh  with normals split at creases (display_mesh.h); may be null: background only
  void setMesh(std::shared_ptr<const GpuMesh> mesh);
  /// Shows the mesh in the colours of its values, 0 … 1 (GpuMesh::setValues).
  void showHeat(HeatShown shown);
  void setPrint(std::optional<SurfacePrint> print);
  /// A second, fainter one of the same symbol, at another place.
  void setGhost(std::optional<SurfacePrint> ghost);
  /// Closed solids show a coloured section.
  void setCut(std::optional<CuttingPlane> cut);
  void setMarker(std::optional<Vec3> marker);
  void setTheme(bool dark);

  /// Draws what is due, if anything is.
  /// @param nowMs   a clock that never goes back
  /// @param target  null: the canvas (framebuffer 0)
  /// @param always  present the last picture again even if nothing is due (something else draws over it)
  /// @returns true if the picture will get better by another call
  Result<bool> draw(const CameraView& camera, double nowMs, const gl::Framebuffer* target = nullptr,
                    bool always = false);

  const ViewStatistics& statistics() const { return statistics_; }

 private:
  // Textures of one resolution.
  struct Stage {
    int width = 0, height = 0;
    gl::Texture surface, visibility, colour;
    gl::Framebuffer surfaceTarget, visibilityTarget, colourTarget;
  };
  // A finished picture: its colours, and the G-buffer that was drawn last for it.
  struct Picture {
    const Stage* colours = nullptr;
    const Stage* surface = nullptr;
    Vec2 jitter{0};
  };
  // A print and what the graphics processor holds of it.
  struct Shown {
    std::optional<SurfacePrint> print;
    gl::Texture reach;
    bool isUploaded = false;
  };
  struct Sample {
    Vec2 jitterPx{0};
    double turn = 0, shift = 0.35;
    int slices = 1, steps = 3;
    bool blur = false;
    double weight = 1;  // of this picture in the average
  };
  static Result<Stage> makeStage(int width, int height, bool colourOnly);
  Status prepareStage(std::optional<Stage>& stage, double scale, bool colourOnly);
  void setCamera(const gl::Program& program, const CameraView& camera, Vec2 jitter) const;
  void setGBuffer(const gl::Program& program, const Stage& stage, const CameraView& camera, Vec2 jitter) const;
  void drawSurface(const Stage& stage, const CameraView& camera, Vec2 jitter) const;
  void drawOcclusion(const Stage& stage, const CameraView& camera, Vec2 jitter, const Sample& sample) const;
  void drawLighting(const Stage& stage, const Stage& into, const CameraView& camera, Vec2 jitter,
                    const Sample& sample) const;
  static Vec2 jitterOf(const Sample& sample, const Stage& stage);
  void drawSample(const Stage& stage, const Stage& into, const CameraView& camera, const Sample& sample) const;
  void drawPrint(const Shown& shown, double strength, const CameraView& camera, const gl::Framebuffer* target);
  void drawPrints(const CameraView& camera, const gl::Framebuffer* target);
  void uploadPrint(Shown& shown);
  void uploadInk();
  void uploadPrints();
  void setPicture(const gl::Program& program, const CameraView& camera) const;
  void presentPicture(const CameraView& camera, const gl::Framebuffer* target);
  void present(const CameraView& camera, const gl::Framebuffer* target);
  Status presentPrints(const CameraView& camera, const gl::Framebuffer* target);
  Status makePlain(const CameraView& camera);
  void bindCanvas(const gl::Framebuffer* target) const;
  Result<bool> drawMoving(const CameraView& camera, double nowMs, const gl::Framebuffer* target);
  Result<bool> drawStill(const CameraView& camera, const gl::Framebuffer* target);
  double radiusMm() const;
  void adaptToInterval(double nowMs);

  ViewQuality quality_;
  gl::Program surface_, occlusion_, lighting_, present_, printing_, copy_;
  std::optional<Stage> moving_, still_, sum_;
  Picture picture_;
  // What is presented without the print that moves (the ghost, if there is one), while the picture stays as it is.
  gl::Texture plain_;
  gl::Framebuffer plainTarget_;
  bool plainIsCurrent_ = false, plainHasPrint_ = false;
  std::shared_ptr<const GpuMesh> mesh_;
  Shown print_, ghost_;
  gl::Texture ink_, nothing_;
  std::vector<std::uint8_t> inkShown_;
  std::optional<Vec3> marker_;
  std::optional<CuttingPlane> cut_;
  bool dark_ = false;
  HeatShown heatShown_ = HeatShown::None;
  int width_ = 1, height_ = 1;
  CameraView lastCamera_;
  bool changed_ = true;
  bool printsChanged_ = false;
  double lastChangeMs_ = 0;
  std::optional<double> lastMovingMs_;
  double mostScale_ = 1;  // of movingScale: as it was at first
  int slowFrames_ = 0, fastFrames_ = 0;
  ViewStatistics statistics_;
};

}  // namespace qrelief
