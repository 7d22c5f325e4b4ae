// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "base/clock.h"
#include "viewer/inked_surface.h"

namespace qrelief {
namespace {

constexpr double kFacingFraction = 0.7;  // edge of the visible square around a faced code, as a part of the model's
                                         // diagonal,
constexpr double kLeastFacingEdges = 2;  // and its limits in edges of the code: some surroundings, and a code large
constexpr double kMostFacingEdges = 4;   // enough to see its modules
constexpr double kSectionEdges = 2;      // the same square around a section
constexpr double kReaderMargin = 1.1;    // room around symbol and quiet zone in the reader's view
constexpr double kSectionYaw = 0.9;      // angle of the camera from the reader's direction when it faces a section,
                                         // radians
constexpr double kSectionPitch = 0.3;
constexpr double kConstructionYaw = 0.75;  // the same for the construction
constexpr double kConstructionPitch = 0.45;
constexpr double kConstructionEdges = 3;
constexpr double kPictureEdges = 1.7;  // edge of the square in a place's picture, in code edges
constexpr int kPictureFrames = 6;

std::optional<StandardView> standardViewByName(std::string_view name) {
  constexpr std::array<const char*, 7> kNames = {"front", "back", "left", "right", "top", "bottom", "iso"};
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (name == kNames[i]) return static_cast<StandardView>(i);
  return {};
}

std::optional<Decal> decalOf(const CodeOnSurface* code) { return code ? std::optional(code->decal) : std::nullopt; }

ColourImage readColours(const gl::Framebuffer& target, int width, int height) {
  ColourImage picture{
      width, height, std::vector<std::uint8_t>(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
  target.bind();
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
  const auto stride = 4 * static_cast<std::ptrdiff_t>(width);
  for (int row = 0; row < height / 2; ++row)
    std::swap_ranges(picture.rgba.begin() + row * stride, picture.rgba.begin() + (row + 1) * stride,
                     picture.rgba.begin() + (height - 1 - row) * stride);
  return picture;
}

}  // namespace

Status Scene::open(const ViewQuality& quality) {
  auto viewer = Viewer::create(quality);
  QRELIEF_TRY(viewer);
  viewer_ = std::make_unique<Viewer>(std::move(*viewer));
  return {};
}

std::optional<CuttingPlane> Scene::cut(const CodeOnSurface* code) const {
  if (!sectionShown_ || !code) return {};
  const ProjectionFrame& frame = code->decal.frame;
  return CuttingPlane{frame.centre + frame.right * (sectionOffset_ * code->decal.edgeMm / 2), frame.right};
}

void Scene::update(const SceneContents& contents) {
  if (!viewer_) return;
  const bool carved = surface_ == Surface::Carved && contents.carved;
  const bool printed = carved && contents.print;
  const bool sizes = surface_ == Surface::Sizes && contents.sizes;
  viewer_->setMesh(printed ? contents.model : carved ? contents.carved : sizes ? contents.sizes : contents.model);
  const HeatShown own = contents.isColoured ? HeatShown::Colours : HeatShown::None;
  viewer_->showHeat(printed                        ? own
                    : sizes                        ? HeatShown::All
                    : carved && contents.carvedInk ? HeatShown::Colours
                    : carved && depthsShown_       ? HeatShown::AboveZero
                                                   : own);
  const std::optional<Ink>& ink = carved ? contents.carvedInk : contents.ink;
  colours_ = ink ? coloursOf(*ink) : SurfaceColours{};
  viewer_->setColours(colours_);
  viewer_->setDecal(printed ? std::optional(*contents.print) : carved ? std::nullopt : decalOf(contents.code));
  viewer_->setGhost(carved ? std::nullopt : decalOf(contents.hovered));
  viewer_->setMarker(carved || contents.code ? std::nullopt : contents.centreMm);
  viewer_->setCut(cut(contents.code));
  setPlate(contents.plate);
  setConstruction(contents.construction);
}

void Scene::setGhost(const CodeOnSurface* hovered) {
  if (viewer_) viewer_->setGhost(decalOf(hovered));
}

void Scene::setDecal(const CodeOnSurface* code) {
  if (viewer_) viewer_->setDecal(decalOf(code));
}

void Scene::setPlate(std::optional<BuildPlate> plate) {
  plate_ = plate;
  if (viewer_) viewer_->setPlate(shownPlate());
}

void Scene::showPlate(bool isShown) {
  plateShown_ = isShown;
  setPlate(plate_);
}

std::optional<BuildPlate> Scene::shownPlate() const { return plateShown_ && !isReaders_ ? plate_ : std::nullopt; }

void Scene::setConstruction(const Construction* construction) {
  construction_ = construction ? drawingOf(*construction, devicePixelRatio_) : LineDrawing{};
  setLines();
}

void Scene::setLight(std::optional<LampLight> light) {
  if (viewer_) viewer_->setLight(lampLightShown_ ? std::move(light) : std::nullopt);
}

/// Shows the construction. A phone sees none.
void Scene::setLines() {
  if (viewer_) viewer_->setLines(isReaders_ ? LineDrawing{} : construction_);
}

void Scene::show(Surface surface, bool isShown) {
  if (isShown) surface_ = surface;
  if (!isShown && surface_ == surface) surface_ = Surface::Model;
}

void Scene::showSection(bool isShown, double offset) {
  sectionShown_ = isShown;
  sectionOffset_ = std::clamp(offset, -1.0, 1.0);
}

void Scene::resize(double width, double height, double devicePixelRatio) {
  camera_.setViewport(width, height);
  devicePixelRatio_ = devicePixelRatio;
  const auto devicePixels = [=](double length) { return static_cast<int>(std::lround(length * devicePixelRatio)); };
  if (viewer_) viewer_->resize(devicePixels(width), devicePixels(height));
}

void Scene::setTheme(bool dark) {
  dark_ = dark;
  if (viewer_) viewer_->setTheme(dark);
}

void Scene::standardView(const std::string& name) {
  if (const auto view = standardViewByName(name)) camera_.lookFrom(*view);
}

void Scene::lookAsReader(const ProjectionFrame& frame, double edgeMm) {
  camera_.lookThrough(frame, edgeMm * kReaderMargin);
  setReaders(true);
}

void Scene::freeLook() { setReaders(false); }

void Scene::setReaders(bool isReaders) {
  if (isReaders == isReaders_) return;
  isReaders_ = isReaders;
  setPlate(plate_);
  setLines();
}

void Scene::faceCode(const ProjectionFrame& frame, double edgeMm, double diagonalMm) {
  camera_.lookThrough(frame,
                      std::clamp(kFacingFraction * diagonalMm, kLeastFacingEdges * edgeMm, kMostFacingEdges * edgeMm));
}

void Scene::faceSection(const CodeOnSurface& code) {
  const ProjectionFrame& frame = code.decal.frame;
  const Vec3 sideways = frame.normal * std::cos(kSectionYaw) + frame.right * std::sin(kSectionYaw);
  const ProjectionFrame oblique =
      makeFrame(frame.centre, sideways + camera_.skyward() * kSectionPitch, camera_.skyward(), frame.eyeDistance);
  camera_.lookThrough(oblique, kSectionEdges * code.decal.edgeMm);
}

void Scene::faceConstruction(const Construction& construction) {
  const ProjectionFrame& frame = construction.frame;
  const Vec3 sideways = frame.normal * std::cos(kConstructionYaw) + frame.right * std::sin(kConstructionYaw);
  const ProjectionFrame oblique =
      makeFrame(frame.centre, sideways + camera_.skyward() * kConstructionPitch, camera_.skyward(), frame.eyeDistance);
  camera_.lookThrough(oblique, kConstructionEdges * construction.squareMm);
}

Result<bool> Scene::draw(bool always) {
  if (!viewer_) return false;
  const double now = nowMs();
  const bool gliding = camera_.advance(now);
  const Result<bool> more = viewer_->draw(camera_.view(), now, nullptr, always);
  if (!more) return more;
  return *more || gliding;
}

ColourImage Scene::picture(const std::shared_ptr<const GpuMesh>& model, const Decal& decal,
                           const ProjectionFrame& upright, int width, int height) {
  if (!viewer_) return {};
  if (!pictureViewer_) {
    ViewQuality quality;
    quality.movingScale = quality.movingCanvas = 1;
    quality.settleMs = 0;
    quality.stillSamples = kPictureFrames;
    auto viewer = Viewer::create(quality);
    if (!viewer) return {};
    pictureViewer_ = std::make_unique<Viewer>(std::move(*viewer));
  }
  OrbitCamera camera = camera_;
  camera.setViewport(width, height);
  camera.lookThrough(upright, kPictureEdges * decal.edgeMm);
  camera.finishGlide();
  pictureViewer_->resize(width, height);
  pictureViewer_->setTheme(dark_);
  pictureViewer_->setColours(colours_);
  pictureViewer_->setMesh(model);
  pictureViewer_->setDecal(decal);
  const gl::Texture canvas(width, height, gl::Format::RGBA8);
  const gl::Texture* const colours[] = {&canvas};
  const auto target = gl::Framebuffer::create(colours, false);
  if (!target) return {};
  double clock = 0;
  for (bool more = true; more;) {
    const auto drawn = pictureViewer_->draw(camera.view(), clock += 1, &*target);
    if (!drawn) return {};
    more = *drawn;
  }
  pictureViewer_->setMesh(nullptr);  // the model may be replaced
  return readColours(*target, width, height);
}

}  // namespace qrelief
