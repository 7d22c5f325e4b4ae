// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "gl/objects.h"
#include "math/frame.h"
#include "projection/visibility_map.h"
#include "render/gpu_mesh.h"
#include "viewer/build_plate.h"
#include "viewer/lamp_light.h"
#include "viewer/line_drawing.h"
#include "viewer/orbit_camera.h"

namespace qrelief {

/// Linear colours of a surface: of the body's material, and of the ink on it.
struct SurfaceColours {
  Vec3f body{0.56f, 0.55f, 0.53f};
  Vec3f ink{0.035f, 0.04f, 0.055f};

  bool operator==(const SurfaceColours&) const = default;
};

/// A square picture that the viewer projects onto the surface, by a frame's central projection.
struct Decal {
  ProjectionFrame frame;
  double edgeMm = 0;                        ///< of the picture on the QR plane
  int size = 0;                             ///< texels along an edge
  std::vector<std::uint8_t> ink;            ///< size², row 0 at the top; 255 = ink, 0 = none
  std::vector<std::uint8_t> inkUnderLamps;  ///< takes the place of `ink` in the light of lamps; empty: the same
  SurfaceColours colours{{0.78f, 0.78f, 0.77f}, SurfaceColours{}.ink};
  bool isInkOnly = false;  ///< draws the ink alone: no paper below, no outline, no warning colour
  /// Surface that takes the decal. Parts of the square that are not reached get a warning colour, hidden parts none.
  /// None: every surface that faces the eye takes the decal. Its centre and normal are the frame's.
  std::shared_ptr<const VisibilityMap> reach;
};

/// The values of a mesh that are shown as colours. Colours: the mesh's own colours take the place of values.
enum class HeatShown { None, All, AboveZero, Colours };

/// Limits on the cost of a frame. The defaults suit a software renderer; `suitedTo` chooses better ones for a faster
/// renderer.
struct ViewQuality {
  double movingScale = 0.5;   ///< resolution while something changes, 0 … 1
  double movingCanvas = 0.6;  ///< the same of codes and of the plate over the model, as a part of the canvas's
  int movingSteps = 3;        ///< occlusion samples on each side of a slice while something changes
  int stillSteps = 5;         ///< the same at rest
  int stillSlices = 2;        ///< of occlusion in a picture at rest
  int stillSamples = 8;       ///< pictures averaged at rest; with 16 slices in all or a multiple they leave no pattern
  int movingShadowTexels = 512;  ///< along an edge of a lamp's shadow map while something changes
  int stillShadowTexels = 1024;  ///< the same at rest
  double mostPixels = 8e5;       ///< larger canvases are drawn at a lower resolution and scaled up
  double settleMs = 120;         ///< without a change, before refinement starts

  static ViewQuality suitedTo(const gl::Capabilities& capabilities);
};

/// Frame times and picture quality, for the inspector.
struct ViewStatistics {
  double coarseFrameMs = 0;   ///< smoothed interval between frames while something changes
  int samples = 0;            ///< pictures averaged so far
  int width = 0, height = 0;  ///< of the last frame's G-buffer
};

/// Draws a mesh by deferred shading: G-buffer, horizon-based occlusion, lighting. Draws coarsely while something
/// changes; at rest, averages jittered full-resolution pictures, which smooths both edges and occlusion.
///
/// Needs the GL context that was current when it was made.
class Viewer {
 public:
  static Result<Viewer> create(const ViewQuality& quality = {});

  /// Sets the size of the target, in device pixels.
  void resize(int width, int height);
  /// @param mesh  with normals split at creases (display_mesh.h); may be null: background only
  void setMesh(std::shared_ptr<const GpuMesh> mesh);
  /// Shows the mesh in the colours of its values, 0 … 1 (GpuMesh::setValues), or in its own (GpuMesh::setColours).
  void showHeat(HeatShown heat);
  void setColours(const SurfaceColours& colours);
  void setDecal(std::optional<Decal> decal);
  /// Sets a second, fainter decal of the same symbol at another place.
  void setGhost(std::optional<Decal> ghost);
  /// Cuts the mesh open. Closed solids show a coloured section.
  void setCut(std::optional<CuttingPlane> cut);
  /// Lights the mesh by a uniform sky and lamps with their shadows; none: by lights of the viewer's own.
  void setLight(std::optional<LampLight> light);
  /// Draws a printer's plate, and marks the surfaces that hang over it too steeply to print well.
  void setPlate(std::optional<BuildPlate> plate);
  void setMarker(std::optional<Vec3> marker);
  /// Draws lines over the model, and over codes on it.
  void setLines(LineDrawing lines);
  void setTheme(bool dark);

  /// Draws the next picture, if one is due.
  /// @param nowMs   a clock that never goes back
  /// @param target  null: the canvas (framebuffer 0)
  /// @param always  present the last picture again even if nothing is due (something else draws on top)
  /// @returns true if another call will improve the picture
  Result<bool> draw(const CameraView& camera, double nowMs, const gl::Framebuffer* target = nullptr,
                    bool always = false);

  const ViewStatistics& statistics() const { return statistics_; }

 private:
  // The textures of one resolution.
  struct Stage {
    int width = 0, height = 0;
    gl::Texture surface, visibility, smoothVisibility, colour;
    gl::Framebuffer surfaceTarget, visibilityTarget, smoothVisibilityTarget, colourTarget;
  };
  // A finished picture: its colours, and the last G-buffer drawn for it.
  struct Picture {
    const Stage* colours = nullptr;
    const Stage* surface = nullptr;
    Vec2 jitter{0};
  };
  // A decal and its data on the graphics processor.
  struct Shown {
    std::optional<Decal> decal;
    gl::Texture ink, reach;
    std::vector<std::uint8_t> inkUploaded, inkUnderLampsUploaded;
    bool isUploaded = false;
  };
  // Where pictures are presented: a framebuffer (null: the page's) and its size in pixels.
  struct Canvas {
    const gl::Framebuffer* target = nullptr;
    int width = 0, height = 0;
  };
  // A picture that has been presented.
  struct Presented {
    gl::Texture colours;
    gl::Framebuffer target;
  };
  struct Sample {
    Vec2 jitterPx{0};
    double turn = 0, shift = 0.35;
    int slices = 1, steps = 3;
    bool blur = false;
    int shadowTexels = 1024;
    bool isLightOnly = false;  // the stage has surface and occlusion of the last such sample
    double weight = 1;         // of this picture in the average
  };
  enum class StageUse { Moving, Still, Sum };
  static Result<Stage> makeStage(int width, int height, StageUse use);
  Status prepareStage(std::optional<Stage>& stage, double scale, StageUse use);
  void setCamera(const gl::Program& program, const CameraView& camera, Vec2 jitter) const;
  void setGBuffer(const gl::Program& program, const Stage& stage, const CameraView& camera, Vec2 jitter) const;
  void drawSurface(const Stage& stage, const CameraView& camera, Vec2 jitter) const;
  void drawOcclusion(const Stage& stage, const CameraView& camera, Vec2 jitter, const Sample& sample) const;
  void blurOcclusion(const Stage& stage, const CameraView& camera, Vec2 jitter) const;
  void drawLighting(const Stage& stage, const Stage& into, const CameraView& camera, Vec2 jitter,
                    const Sample& sample) const;
  static Vec2 jitterOf(const Sample& sample, const Stage& stage);
  Status drawSample(const Stage& stage, const Stage& into, const CameraView& camera, const Sample& sample);
  void drawDecal(const Shown& layer, double strength, const CameraView& camera, const Canvas& canvas);
  void drawPrints(const CameraView& camera, const Canvas& canvas);
  void drawLines(const CameraView& camera, const Canvas& canvas) const;
  void uploadDecal(Shown& layer);
  void uploadPrints();
  void setSight(const gl::Program& program, const CameraView& camera, const Canvas& canvas) const;
  void setPicture(const gl::Program& program, const CameraView& camera, const Canvas& canvas) const;
  void presentPicture(const CameraView& camera, const Canvas& canvas);
  void present(const CameraView& camera, const gl::Framebuffer* target);
  Status presentMoving(const CameraView& camera, const gl::Framebuffer* target);
  Status presentPrints(const CameraView& camera, const gl::Framebuffer* target);
  Status makePlain(const CameraView& camera);
  Canvas canvasOf(const gl::Framebuffer* target) const { return {target, width_, height_}; }
  static void bindCanvas(const Canvas& canvas);
  static Status makePresented(Presented& presented, int width, int height);
  void copy(const gl::Texture& picture, const Canvas& canvas) const;
  Result<bool> drawMoving(const CameraView& camera, double nowMs, const gl::Framebuffer* target, bool isLightOnly);
  Result<bool> drawStill(const CameraView& camera, const gl::Framebuffer* target, bool always);
  double radiusMm() const;
  void adaptToInterval(double nowMs);

  ViewQuality quality_;
  gl::Program surface_, occlusion_, blur_, lighting_, present_, decalProgram_, plateProgram_, copy_;
  std::optional<Stage> moving_, still_, sum_;
  Picture picture_;
  // The presented picture without the moving decal (the ghost, if there is one). Valid while the picture stays the
  // same.
  Presented plain_;
  bool plainIsCurrent_ = false, plainHasPrint_ = false;
  Presented coarse_;       // while something changes
  bool isCoarse_ = false;  // the canvas shows `coarse_`
  std::shared_ptr<const GpuMesh> mesh_;
  Shown decal_, ghost_;
  gl::Texture nothing_;
  std::optional<Vec3> marker_;
  std::optional<CuttingPlane> cut_;
  std::optional<BuildPlate> plate_;
  std::optional<LampLight> light_;
  LampShadows shadows_;
  LineDrawing lines_;
  LinePass linePass_;
  bool dark_ = false;
  HeatShown heatShown_ = HeatShown::None;
  SurfaceColours colours_;
  int width_ = 1, height_ = 1;
  CameraView lastCamera_;
  bool changed_ = true, lightChanged_ = false;
  bool printsChanged_ = false;
  double lastChangeMs_ = 0;
  std::optional<double> lastMovingMs_;
  double mostScale_ = 1;  // initial movingScale, its upper limit
  int slowFrames_ = 0, fastFrames_ = 0;
  ViewStatistics statistics_;
};

}  // namespace qrelief
