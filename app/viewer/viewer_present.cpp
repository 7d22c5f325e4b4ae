// SPDX-License-Identifier: GPL-3.0-or-later
// Implements how Viewer presents a drawn picture, with plate, marker, codes and lines over it.
#include <algorithm>
#include <cmath>
#include <vector>

#include "viewer/decal_bounds.h"
#include "viewer/viewer.h"

namespace qrelief {
namespace {

constexpr double kGhostStrength = 0.8;
constexpr double kBesideGhost = 0.45;  // strength of the other decal while there is a ghost
constexpr Vec3f kAccent = {0.01f, 0.30f, 0.85f};
constexpr Vec3f kWarn = {0.95f, 0.22f, 0.01f};

}  // namespace

void Viewer::uploadDecal(Shown& layer) {
  if (!layer.decal || layer.isUploaded) return;
  layer.isUploaded = true;
  const Decal& decal = *layer.decal;
  if (decal.ink != layer.inkUploaded || decal.inkUnderLamps != layer.inkUnderLampsUploaded) {
    layer.inkUploaded = decal.ink;
    layer.inkUnderLampsUploaded = decal.inkUnderLamps;
    const auto& underLamps = decal.inkUnderLamps.empty() ? decal.ink : decal.inkUnderLamps;
    std::vector<std::uint8_t> texels(4 * decal.ink.size(), 255);
    for (std::size_t i = 0; i < decal.ink.size(); ++i) {
      texels[4 * i] = decal.ink[i];
      texels[4 * i + 1] = underLamps[i];
    }
    layer.ink = gl::Texture(decal.size, decal.size, gl::Format::RGBA8, texels.data());
  }
  if (!decal.reach) return;
  const int texels = decal.reach->window.texels;
  const void* const data = decal.reach->texels.data();
  if (layer.reach.width() == texels)
    layer.reach.upload(data);
  else
    layer.reach = gl::Texture(texels, texels, gl::Format::RGBA32F, data);
}

void Viewer::bindCanvas(const Canvas& canvas) {
  if (canvas.target) {
    canvas.target->bind();
  } else {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
  }
  glViewport(0, 0, canvas.width, canvas.height);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
}

void Viewer::setSight(const gl::Program& program, const CameraView& camera, const Canvas& canvas) const {
  setGBuffer(program, *picture_.surface, camera, picture_.jitter);
  program.setTexture("u_surface", 1, picture_.surface->surface);
  program.set("u_canvas", glm::vec2(canvas.width, canvas.height));
  program.set("u_pixelMm", static_cast<float>(2 * camera.tanHalf.y * camera.distance / canvas.height));
}

void Viewer::setPicture(const gl::Program& program, const CameraView& camera, const Canvas& canvas) const {
  setSight(program, camera, canvas);
  program.setTexture("u_colour", 0, picture_.colours->colour);
  program.set("u_accent", kAccent);
}

/// Presents everything except the decals.
void Viewer::presentPicture(const CameraView& camera, const Canvas& canvas) {
  bindCanvas(canvas);
  setPicture(present_, camera, canvas);
  present_.set("u_markerShown", marker_ ? 1 : 0);
  if (marker_) present_.set("u_marker", camera.pointInView(*marker_));
  gl::drawFullscreen();
  if (!plate_) return;
  setSight(plateProgram_, camera, canvas);
  drawPlate(plateProgram_, *plate_, camera, dark_);
}

void Viewer::drawDecal(const Shown& layer, double strength, const CameraView& camera, const Canvas& canvas) {
  if (!layer.decal) return;
  const Decal& decal = *layer.decal;
  bindCanvas(canvas);
  const PixelBox box = decalBounds(decal, camera, canvas.width, canvas.height);
  glEnable(GL_SCISSOR_TEST);
  glScissor(box.x, box.y, box.width, box.height);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  setPicture(decalProgram_, camera, canvas);
  decalProgram_.set("u_warn", kWarn);
  decalProgram_.set("u_paperColour", decal.colours.body);
  decalProgram_.set("u_inkColour", decal.colours.ink);
  decalProgram_.set("u_paper", decal.isInkOnly ? 0.0f : 1.0f);
  decalProgram_.set("u_isUnderLamps", light_ ? 1.0f : 0.0f);
  decalProgram_.setTexture("u_ink", 2, layer.ink);
  decalProgram_.setTexture("u_reach", 3, decal.reach ? layer.reach : nothing_);
  decalProgram_.set("u_strength", static_cast<float>(strength));
  decalProgram_.set("u_centre", camera.pointInView(decal.frame.centre));
  decalProgram_.set("u_right", camera.inView(decal.frame.right));
  decalProgram_.set("u_up", camera.inView(decal.frame.up));
  decalProgram_.set("u_normal", camera.inView(decal.frame.normal));
  decalProgram_.set("u_eyeDistance", static_cast<float>(decal.frame.eyeDistance));
  decalProgram_.set("u_edge", static_cast<float>(decal.edgeMm));
  decalProgram_.set("u_window", decal.reach ? static_cast<float>(decal.reach->window.extentMm) : 0.0f);
  const ProjectionFrame& seen = decal.reach ? decal.reach->frame : decal.frame;
  decalProgram_.set("u_turn", glm::vec2(glm::dot(decal.frame.right, seen.right), glm::dot(decal.frame.right, seen.up)));
  gl::drawFullscreen();
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
}

void Viewer::drawPrints(const CameraView& camera, const Canvas& canvas) {
  drawDecal(decal_, ghost_.decal ? kBesideGhost : 1, camera, canvas);
  drawDecal(ghost_, kGhostStrength, camera, canvas);
  printsChanged_ = false;
}

void Viewer::drawLines(const CameraView& camera, const Canvas& canvas) const {
  if (lines_.plane) {
    setSight(plateProgram_, camera, canvas);
    drawGridPlane(plateProgram_, *lines_.plane, camera);
  }
  if (linePass_.isEmpty()) return;
  setSight(linePass_.program(), camera, canvas);
  linePass_.draw(camera, dark_);
}

void Viewer::uploadPrints() {
  uploadDecal(decal_);
  uploadDecal(ghost_);
  if (nothing_.width() == 0) nothing_ = gl::Texture(1, 1, gl::Format::RGBA32F);
}

void Viewer::present(const CameraView& camera, const gl::Framebuffer* target) {
  uploadPrints();
  const Canvas canvas = canvasOf(target);
  presentPicture(camera, canvas);
  drawPrints(camera, canvas);
  drawLines(camera, canvas);
  isCoarse_ = false;
}

/// Does the same as `present`, more cheaply: codes and the plate are as coarse as quality_.movingCanvas says.
Status Viewer::presentMoving(const CameraView& camera, const gl::Framebuffer* target) {
  if (quality_.movingCanvas >= 1 || marker_) {  // the size of the marker is in pixels of the canvas
    present(camera, target);
    return {};
  }
  const auto coarser = [&](int pixels) {
    return std::max(1, static_cast<int>(std::lround(pixels * quality_.movingCanvas)));
  };
  uploadPrints();
  QRELIEF_TRY(makePresented(coarse_, coarser(width_), coarser(height_)));
  coarse_.colours.useLinearFilter();
  const Canvas coarse{&coarse_.target, coarse_.colours.width(), coarse_.colours.height()}, canvas = canvasOf(target);
  presentPicture(camera, coarse);
  drawPrints(camera, coarse);
  copy(coarse_.colours, canvas);
  drawLines(camera, canvas);
  isCoarse_ = true;
  return {};
}

Status Viewer::makePresented(Presented& presented, int width, int height) {
  if (presented.colours.width() == width && presented.colours.height() == height) return {};
  presented.colours = gl::Texture(width, height, gl::Format::RGBA8);
  const gl::Texture* const colours[] = {&presented.colours};
  auto target = gl::Framebuffer::create(colours, false);
  QRELIEF_TRY(target);
  presented.target = std::move(*target);
  return {};
}

void Viewer::copy(const gl::Texture& picture, const Canvas& canvas) const {
  bindCanvas(canvas);
  copy_.use();
  copy_.setTexture("u_picture", 0, picture);
  copy_.set("u_canvas", glm::vec2(canvas.width, canvas.height));
  gl::drawFullscreen();
}

Status Viewer::makePlain(const CameraView& camera) {
  const bool withDecal = ghost_.decal.has_value();
  if (plainIsCurrent_ && plainHasPrint_ == withDecal) return {};
  QRELIEF_TRY(makePresented(plain_, width_, height_));
  const Canvas plain = canvasOf(&plain_.target);
  presentPicture(camera, plain);
  if (withDecal) drawDecal(decal_, kBesideGhost, camera, plain);
  plainIsCurrent_ = true;
  plainHasPrint_ = withDecal;
  return {};
}

/// Does the same as `present`, more cheaply if only decals have changed.
Status Viewer::presentPrints(const CameraView& camera, const gl::Framebuffer* target) {
  uploadPrints();
  QRELIEF_TRY(makePlain(camera));
  const Canvas canvas = canvasOf(target);
  copy(plain_.colours, canvas);
  if (ghost_.decal) {
    drawDecal(ghost_, kGhostStrength, camera, canvas);
  } else {
    drawDecal(decal_, 1, camera, canvas);
  }
  drawLines(camera, canvas);
  printsChanged_ = false;
  isCoarse_ = false;
  return {};
}

}  // namespace qrelief
