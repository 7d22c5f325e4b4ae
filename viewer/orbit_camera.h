// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>

#include "math/box.h"
#include "math/frame.h"
#include "math/vec.h"

namespace qrelief {

/// Which axis of the model points up on the screen.
enum class UpAxis { Y, Z };

/// From which side the whole scene is looked at, upright: front is from -y of a scene whose up is z.
enum class StandardView { Front, Back, Left, Right, Top, Bottom, Iso };

/// Where the camera is: on a sphere about the target, turned about the up axis (yaw), raised over the horizon (pitch),
/// tilted about the line of sight (roll).
struct CameraPose {
  Vec3 target{0};  ///< mm, model space
  double yaw = -1.05, pitch = 0.35, roll = 0;
  double distance = 100;      ///< eye to target, mm
  double fieldOfView = 0.52;  ///< vertical, radians

  bool operator==(const CameraPose&) const = default;
};

/// What a renderer needs to know of a camera. View space: origin at the *target* (positions near it keep their digits),
/// axes right, up, back; the eye is at (0, 0, distance).
struct CameraView {
  Vec3 target{0};
  Vec3 right{1, 0, 0}, up{0, 1, 0}, back{0, 0, 1};
  Vec3 skyward{0, 0, 1};  ///< the up axis of the scene, model space
  double distance = 100;
  Vec2 tanHalf{1};           ///< tangents of half the horizontal and vertical field of view
  Vec2 depthRange{1, 1000};  ///< near and far distance along the line of sight, mm

  Vec3 eye() const { return target + back * distance; }
  /// What is seen, as a projection onto the plane through the target.
  ProjectionFrame frame() const { return {target, right, up, back, distance}; }
  /// Edge of the square about the target that holds all of the picture.
  double widthAtTargetMm() const { return 2 * distance * std::max(tanHalf.x, tanHalf.y); }
  bool operator==(const CameraView&) const = default;
};

struct Ray {
  Vec3 origin, direction;  ///< direction is unit
};

/// Turntable camera: orbit, pan, zoom towards the pointer, moves that glide. Positions on the screen in CSS pixels from
/// the upper left.
class OrbitCamera {
 public:
  void setViewport(double width, double height);
  void setUpAxis(UpAxis axis);
  UpAxis upAxis() const { return upAxis_; }
  Vec3 skyward() const { return fromTurntable({0, 0, 1}); }

  /// The box to look at: limits of panning and zooming follow from it. Does not move the camera.
  void setScene(const Box3& box);

  void orbit(double dx, double dy);
  void pan(double dx, double dy);
  /// @param factor  > 1 comes nearer
  /// @param focus   stays under its pixel: the surface point under the pointer, or where the pointer's ray meets the
  ///                plane through the target if there is none
  void zoom(double factor, Vec3 focus);
  /// Where the pointer's ray meets the plane through the target that faces the camera.
  Vec3 onTargetPlane(double x, double y) const;

  /// All of the scene, upright, from the side the camera is on; `fromDefaultSide` from the front, somewhat above.
  void fit();
  void fitFromDefaultSide();
  void lookFrom(StandardView side);
  /// From the reader's eye: the square of `extentMm` on the frame's plane fills the view.
  void lookThrough(const ProjectionFrame& frame, double extentMm);

  /// Lets a glide come along. @returns true while one is under way
  bool advance(double nowMs);
  /// Ends a glide where it leads.
  void finishGlide();

  CameraView view() const;
  Ray ray(double x, double y) const;
  /// Pixel of a point in front of the eye.
  Vec2 toScreen(Vec3 point) const;
  const CameraPose& pose() const { return pose_; }
  /// A direction of the model in axes whose z is up.
  Vec3 toTurntable(Vec3 v) const;

 private:
  struct Glide {
    CameraPose from, to;
    std::optional<double> startMs;  // set by the first frame
  };
  Vec3 fromTurntable(Vec3 v) const;
  CameraPose fitted(CameraPose pose) const;
  void interrupt() { glide_.reset(); }
  void keepInLimits();

  CameraPose pose_;
  std::optional<Glide> glide_;
  Box3 scene_;
  UpAxis upAxis_ = UpAxis::Z;
  double width_ = 1, height_ = 1;
};

}  // namespace qrelief
