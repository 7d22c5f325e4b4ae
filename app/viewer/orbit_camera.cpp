// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/orbit_camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace qrelief {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kGlideMs = 350;
constexpr double kRollFadePx = 80;   // a drag this long reduces the roll to 1/e, so that free turning ends upright
constexpr double kFitMargin = 1.03;  // room around the model
constexpr double kClosest = 0.004;   // shortest distance to the target, as a part of the scene's diagonal
constexpr double kFarthest = 12;     // longest, likewise
constexpr double kLeash = 0.5;       // farthest distance of the target from the scene's box, as a part of its diagonal

struct Axes {
  Vec3 right, up, back;
};

// In turntable space, z up. At the poles the yaw still says where up is.
Axes axesOf(const CameraPose& pose) {
  const Vec3 back(std::cos(pose.pitch) * std::cos(pose.yaw), std::cos(pose.pitch) * std::sin(pose.yaw),
                  std::sin(pose.pitch));
  const Vec3 right(-std::sin(pose.yaw), std::cos(pose.yaw), 0);
  const Vec3 up = glm::cross(back, right);
  const double c = std::cos(pose.roll), s = std::sin(pose.roll);
  return {right * c + up * s, up * c - right * s, back};
}

// Returns the same angle within half a turn of `near`, so that a glide takes the short way round.
double wrappedNear(double angle, double near) { return angle - 2 * kPi * std::round((angle - near) / (2 * kPi)); }

// Returns a pose that looks from `back` with `up` upward, in turntable space.
CameraPose turnedTo(CameraPose pose, Vec3 back, Vec3 up) {
  pose.pitch = std::asin(std::clamp(back.z, -1.0, 1.0));
  // Straight from above or below, only the yaw says where up is.
  const bool atPole = std::hypot(back.x, back.y) < 1e-9;
  const double sign = back.z > 0 ? -1 : 1;
  pose.yaw = atPole ? std::atan2(sign * up.y, sign * up.x) : std::atan2(back.y, back.x);
  pose.roll = 0;
  const Axes upright = axesOf(pose);
  pose.roll = std::atan2(-glm::dot(up, upright.right), glm::dot(up, upright.up));
  return pose;
}

double mix(double a, double b, double t) { return a + (b - a) * t; }

// Returns the height of the visible part of the plane through the target: perceived as nearness.
double visibleHeight(const CameraPose& pose) { return 2 * pose.distance * std::tan(pose.fieldOfView / 2); }

CameraPose between(const CameraPose& a, const CameraPose& b, double t) {
  CameraPose pose;
  pose.target = a.target + (b.target - a.target) * t;
  pose.yaw = mix(a.yaw, b.yaw, t);
  pose.pitch = mix(a.pitch, b.pitch, t);
  pose.roll = mix(a.roll, b.roll, t);
  pose.fieldOfView = mix(a.fieldOfView, b.fieldOfView, t);
  const double height = std::exp(mix(std::log(visibleHeight(a)), std::log(visibleHeight(b)), t));
  pose.distance = height / (2 * std::tan(pose.fieldOfView / 2));
  return pose;
}

}  // namespace

void OrbitCamera::setViewport(double width, double height) {
  width_ = std::max(1.0, width);
  height_ = std::max(1.0, height);
}

void OrbitCamera::setUpAxis(UpAxis axis) {
  upAxis_ = axis;
  setSkyward(modelUp());
}

/// Turns the turntable. Its x axis is the model's x, or y where x points up, as far as it is level.
void OrbitCamera::setSkyward(Vec3 up) {
  const Vec3 across = std::abs(up.x) < 0.9 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  const Vec3 right = glm::normalize(across - up * glm::dot(across, up));
  turntable_ = {right, glm::cross(up, right), up};
}

void OrbitCamera::standOn(Vec3 up) {
  const CameraView now = view();
  setSkyward(up);
  pose_ = turnedTo(pose_, toTurntable(now.back), toTurntable(now.up));
  CameraPose to = pose_;
  to.pitch = std::max(to.pitch, CameraPose{}.pitch);
  glide_ = Glide{pose_, fitted(to, scene_), {}};
}

void OrbitCamera::setScene(const Box3& box) { scene_ = box; }

Vec3 OrbitCamera::fromTurntable(Vec3 v) const {
  return turntable_[0] * v.x + turntable_[1] * v.y + turntable_[2] * v.z;
}

Vec3 OrbitCamera::toTurntable(Vec3 v) const {
  return {glm::dot(v, turntable_[0]), glm::dot(v, turntable_[1]), glm::dot(v, turntable_[2])};
}

void OrbitCamera::orbit(double dx, double dy) {
  interrupt();
  // Express the drag in the axes of the unrolled camera, so that the surface follows the pointer in a rolled view, too.
  const double c = std::cos(pose_.roll), s = std::sin(pose_.roll);
  const double across = dx * c + dy * s, upwards = dx * s - dy * c;
  const double perPixel = kPi / std::min(width_, height_);
  pose_.yaw = std::remainder(pose_.yaw - across * perPixel, 2 * kPi);
  pose_.pitch = std::clamp(pose_.pitch - upwards * perPixel, -kPi / 2, kPi / 2);
  pose_.roll *= std::exp(-std::hypot(dx, dy) / kRollFadePx);
}

void OrbitCamera::pan(double dx, double dy) {
  interrupt();
  const CameraView now = view();
  const double perPixel = visibleHeight(pose_) / height_;
  pose_.target += (now.up * dy - now.right * dx) * perPixel;
  keepInLimits();
}

void OrbitCamera::zoom(double factor, Vec3 focus) {
  interrupt();
  if (!(factor > 0) || !std::isfinite(factor)) return;
  const double diagonal = std::max(scene_.diagonal(), 1e-6);
  // The size of the visible area counts, not the distance alone: the reader's eye is far away, with a long lens.
  const double lens = std::tan(pose_.fieldOfView / 2) / std::tan(CameraPose{}.fieldOfView / 2);
  const double distance = std::clamp(pose_.distance / factor, kClosest * diagonal / lens, kFarthest * diagonal / lens);
  // Scaling eye and target about the focus keeps every ray through the focus.
  const double scale = distance / pose_.distance;
  pose_.target = focus + (pose_.target - focus) * scale;
  pose_.distance = distance;
  keepInLimits();
}

void OrbitCamera::keepInLimits() {
  if (scene_.empty()) return;
  const Vec3 leash(kLeash * scene_.diagonal());
  pose_.target = glm::clamp(pose_.target, scene_.min - leash, scene_.max + leash);
}

Vec3 OrbitCamera::onTargetPlane(double x, double y) const {
  const Ray through = ray(x, y);
  return through.origin + through.direction * (pose_.distance / -glm::dot(through.direction, view().back));
}

CameraPose OrbitCamera::fitted(CameraPose pose, const Box3& box) const {
  pose.roll = 0;
  pose.fieldOfView = CameraPose{}.fieldOfView;
  pose.yaw = std::remainder(pose.yaw, 2 * kPi);
  if (box.empty()) return pose;
  pose.target = box.centre();
  const Axes axes = axesOf(pose);
  const double tanY = std::tan(pose.fieldOfView / 2), tanX = tanY * width_ / height_;
  double needed = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 sign(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
    const Vec3 p = toTurntable(sign * box.size());
    const double sideways = std::max(std::abs(glm::dot(p, axes.right)) / tanX, std::abs(glm::dot(p, axes.up)) / tanY);
    needed = std::max(needed, sideways * kFitMargin + glm::dot(p, axes.back));
  }
  pose.distance = std::max(needed, 1e-6);
  return pose;
}

void OrbitCamera::fit() { fitTo(scene_); }

void OrbitCamera::fitTo(const Box3& part) { glide_ = Glide{pose_, fitted(pose_, part), {}}; }

void OrbitCamera::fitFromDefaultSide() {
  interrupt();
  pose_ = fitted(CameraPose{}, scene_);
}

void OrbitCamera::lookFrom(StandardView side) {
  struct Angles {
    double yaw, pitch;
  };
  constexpr double kIsometric = 0.6154797086703873;  // atan(1/√2)
  constexpr std::array<Angles, 7> kSides = {{
      {-kPi / 2, 0},
      {kPi / 2, 0},
      {kPi, 0},
      {0, 0},
      {-kPi / 2, kPi / 2},
      {-kPi / 2, -kPi / 2},
      {-kPi / 4, kIsometric},
  }};
  CameraPose to = pose_;
  to.yaw = kSides[static_cast<std::size_t>(side)].yaw;
  to.pitch = kSides[static_cast<std::size_t>(side)].pitch;
  to = fitted(to, scene_);
  to.yaw = wrappedNear(to.yaw, pose_.yaw);
  glide_ = Glide{pose_, to, {}};
}

void OrbitCamera::lookThrough(const ProjectionFrame& frame, double extentMm) {
  CameraPose to = turnedTo({}, toTurntable(frame.normal), toTurntable(frame.up));
  to.target = frame.centre;
  to.distance = frame.eyeDistance;
  const double shownHeight = extentMm * std::max(1.0, height_ / width_);
  to.fieldOfView = 2 * std::atan(shownHeight / (2 * frame.eyeDistance));
  to.yaw = wrappedNear(to.yaw, pose_.yaw);
  to.roll = wrappedNear(to.roll, pose_.roll);
  glide_ = Glide{pose_, to, {}};
}

bool OrbitCamera::advance(double nowMs) {
  if (!glide_) return false;
  if (!glide_->startMs) glide_->startMs = nowMs;
  const double t = std::clamp((nowMs - *glide_->startMs) / kGlideMs, 0.0, 1.0);
  if (t >= 1) {
    finishGlide();
    return false;
  }
  pose_ = between(glide_->from, glide_->to, t * t * (3 - 2 * t));
  return true;
}

void OrbitCamera::finishGlide() {
  if (!glide_) return;
  pose_ = glide_->to;
  glide_.reset();
}

CameraView OrbitCamera::view() const {
  const Axes axes = axesOf(pose_);
  CameraView view;
  view.target = pose_.target;
  view.right = fromTurntable(axes.right);
  view.up = fromTurntable(axes.up);
  view.back = fromTurntable(axes.back);
  view.skyward = skyward();
  view.distance = pose_.distance;
  const double tanY = std::tan(pose_.fieldOfView / 2);
  view.tanHalf = {tanY * width_ / height_, tanY};
  if (!scene_.empty()) {
    const double middle = glm::dot(view.eye() - scene_.centre(), view.back), reach = scene_.diagonal() / 2;
    // With the near plane at a hundredth of the distance or farther, the depth buffer stays precise.
    const double nearest = std::max(pose_.distance / 100, middle - reach);
    view.depthRange = {nearest, std::max(nearest * 1.01, middle + reach)};
  }
  return view;
}

Ray OrbitCamera::ray(double x, double y) const {
  const CameraView now = view();
  const Vec2 ndc(2 * x / width_ - 1, 1 - 2 * y / height_);
  return {now.eye(), glm::normalize(now.right * (ndc.x * now.tanHalf.x) + now.up * (ndc.y * now.tanHalf.y) - now.back)};
}

Vec2 OrbitCamera::toScreen(Vec3 point) const {
  const CameraView now = view();
  const Vec3 fromEye = point - now.eye();
  const double w = -glm::dot(fromEye, now.back);
  const Vec2 ndc(glm::dot(fromEye, now.right) / (w * now.tanHalf.x), glm::dot(fromEye, now.up) / (w * now.tanHalf.y));
  return {(ndc.x + 1) * width_ / 2, (1 - ndc.y) * height_ / 2};
}

}  // namespace qrelief
