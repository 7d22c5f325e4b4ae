// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "math/box.h"
#include "math/frame.h"
#include "math/vec.h"

namespace qrelief {

/// The axis of the model that points up on the screen.
enum class UpAxis { Y, Z };

/// The side from which the whole scene is viewed, upright. Front is from -y of a scene whose up is z.
enum class StandardView { Front, Back, Left, Right, Top, Bottom, Iso };

/// Position of the camera on a sphere about the target: turned about the up axis (yaw), raised above the horizon
/// (pitch), tilted about the line of sight (roll).
struct CameraPose {
  Vec3 target{0};  ///< mm, model space
  double yaw = -1.05, pitch = 0.35, roll = 0;
  double distance = 100;      ///< eye to target, mm
  double fieldOfView = 0.52;  ///< vertical, radians

  bool operator==(const CameraPose&) const = default;
};

/// The camera as a renderer needs it. View space: origin at the *target* (positions near it keep their digits), axes
/// right, up, back; the eye is at (0, 0, distance).
struct CameraView {
  Vec3 target{0};
  Vec3 right{1, 0, 0}, up{0, 1, 0}, back{0, 0, 1};
  Vec3 skyward{0, 0, 1};  ///< points up on the screen unless the camera rolls; model space
  double distance = 100;
  Vec2 tanHalf{1};           ///< tangents of half the horizontal and vertical field of view
  Vec2 depthRange{1, 1000};  ///< near and far distance along the line of sight, mm

  Vec3 eye() const { return target + back * distance; }
  /// Converts a direction or a point to view space.
  Vec3f inView(Vec3 direction) const {
    return Vec3f(Vec3(glm::dot(direction, right), glm::dot(direction, up), glm::dot(direction, back)));
  }
  Vec3f pointInView(Vec3 point) const { return inView(point - target); }
  /// Returns the view as a projection onto the plane through the target.
  ProjectionFrame frame() const { return {target, right, up, back, distance}; }
  /// Returns the edge of the square about the target that holds the whole picture.
  double widthAtTargetMm() const { return 2 * distance * std::max(tanHalf.x, tanHalf.y); }
  bool operator==(const CameraView&) const = default;
};

struct Ray {
  Vec3 origin, direction;  ///< direction is unit
};

/// Turntable camera: orbits, pans, zooms towards the pointer, and glides to new positions. Screen positions are CSS
/// pixels from the upper left.
class OrbitCamera {
 public:
  void setViewport(double width, double height);
  /// Sets the model's axis that points up, on the screen, too.
  void setUpAxis(UpAxis axis);
  Vec3 modelUp() const { return upAxis_ == UpAxis::Z ? Vec3(0, 0, 1) : Vec3(0, 1, 0); }
  /// Glides to where another direction points up on the screen. @param up  model space, unit
  void standOn(Vec3 up);
  Vec3 skyward() const { return turntable_[2]; }

  /// Sets the box to view, which also limits panning and zooming. Does not move the camera.
  void setScene(const Box3& box);

  void orbit(double dx, double dy);
  void pan(double dx, double dy);
  /// Moves the camera towards `focus` or away from it.
  /// @param factor  > 1 comes nearer
  /// @param focus   stays under its pixel: the surface point under the pointer or, if there is none, the intersection
  ///                of the pointer's ray with the plane through the target
  void zoom(double factor, Vec3 focus);
  /// Returns the intersection of the pointer's ray with the plane through the target that faces the camera.
  Vec3 onTargetPlane(double x, double y) const;

  /// Shows the whole scene, upright, from the current side; `fitFromDefaultSide` from the front, slightly raised.
  void fit();
  void fitFromDefaultSide();
  /// Shows a part of the scene from the current side, upright.
  void fitTo(const Box3& part);
  void lookFrom(StandardView side);
  /// Looks from the code's eye: a square of `extentMm` on the frame's plane fills the view.
  void lookThrough(const ProjectionFrame& frame, double extentMm);

  /// Moves the camera along its glide. @returns true while the glide lasts
  bool advance(double nowMs);
  /// Ends a glide at its destination.
  void finishGlide();

  CameraView view() const;
  Ray ray(double x, double y) const;
  /// Returns the pixel of a point in front of the eye.
  Vec2 toScreen(Vec3 point) const;
  const CameraPose& pose() const { return pose_; }
  /// Converts a direction of the model to axes whose z is up.
  Vec3 toTurntable(Vec3 v) const;

 private:
  struct Glide {
    CameraPose from, to;
    std::optional<double> startMs;  // set by the first frame
  };
  Vec3 fromTurntable(Vec3 v) const;
  void setSkyward(Vec3 up);
  CameraPose fitted(CameraPose pose, const Box3& box) const;
  void interrupt() { glide_.reset(); }
  void keepInLimits();

  CameraPose pose_;
  std::optional<Glide> glide_;
  Box3 scene_;
  UpAxis upAxis_ = UpAxis::Z;
  std::array<Vec3, 3> turntable_ = {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};  // its axes in model space, z up
  double width_ = 1, height_ = 1;
};

}  // namespace qrelief
