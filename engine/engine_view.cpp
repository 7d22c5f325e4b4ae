// SPDX-License-Identifier: GPL-3.0-or-later
// What the engine shows, and the code that follows the pointer.
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "base/clock.h"
#include "engine/answers.h"
#include "engine/engine.h"
#include "engine/symbol_print.h"
#include "math/angle.h"
#include "viewer/depth_colours.h"

namespace qrelief {
namespace {

constexpr double kFacingEdges = 2;     // of the square that is seen around a code that is faced, at least, and
constexpr double kFacingShare = 0.7;   // its share of the model's diagonal
constexpr double kReaderMargin = 1.1;  // air around symbol and quiet zone in the reader's view
constexpr double kSectionYaw = 0.9;    // of the camera from the reader's direction, to see a section, radians
constexpr double kSectionPitch = 0.3;
constexpr int kReachTexels = 192;
constexpr double kReachEdges = 3;   // edge of the map around a placed code, in its own: it can be turned and enlarged
constexpr double kSpotEdges = 1.7;  // of the square that a spot's picture shows, in those of the code
constexpr int kSpotFrames = 6;

Json jsonOf(Vec2 v) { return {v.x, v.y}; }

const Error kNoCode = {ErrorKind::BadUsage,
                       untold("no code has a place", "click on the model where the code should go")};

std::optional<StandardView> standardViewByName(std::string_view name) {
  constexpr std::array<const char*, 7> kNames = {"front", "back", "left", "right", "top", "bottom", "iso"};
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (name == kNames[i]) return static_cast<StandardView>(i);
  return {};
}

}  // namespace

void Engine::resize(double width, double height, double devicePixelRatio) {
  camera_.setViewport(width, height);
  const auto devicePixels = [=](double length) { return static_cast<int>(std::lround(length * devicePixelRatio)); };
  if (viewer_) viewer_->resize(devicePixels(width), devicePixels(height));
}

void Engine::setTheme(bool dark) {
  dark_ = dark;
  if (viewer_) viewer_->setTheme(dark);
}

void Engine::setUpAxis(const std::string& axis) {
  camera_.setUpAxis(axis == "y" ? UpAxis::Y : UpAxis::Z);
  camera_.fitFromDefaultSide();
}

void Engine::showCarved(bool carved) {
  showCarved_ = carved;
  if (carved) makeCarvedDisplay();
  if (carved) showSizes_ = false;
  endHover();
  updateView();
}

void Engine::orbit(double dx, double dy) { camera_.orbit(dx, dy); }

void Engine::pan(double dx, double dy) { camera_.pan(dx, dy); }

void Engine::zoom(double factor, double x, double y) {
  const auto surface = surfaceAt(x, y);
  camera_.zoom(factor, surface ? surface->position : camera_.onTargetPlane(x, y));
}

void Engine::fit() { camera_.fit(); }

void Engine::standardView(const std::string& name) {
  if (const auto view = standardViewByName(name)) camera_.lookFrom(*view);
}

void Engine::readerView() {
  if (placement_ && code_) camera_.lookThrough(placement_->frame, code_->print.edgeMm * kReaderMargin);
}

void Engine::faceCode() {
  if (!placement_ || !code_) return;
  const double extent = std::max(kFacingEdges * code_->print.edgeMm, kFacingShare * model_->display->box().diagonal());
  camera_.lookThrough(placement_->frame, extent);
}

std::optional<CuttingPlane> Engine::cut() const {
  if (!sectionShown_ || !code_) return {};
  const ProjectionFrame& frame = code_->print.frame;
  return CuttingPlane{frame.centre + frame.right * (sectionOffset_ * code_->print.edgeMm / 2), frame.right};
}

void Engine::showSection(bool shown, double offset) {
  sectionShown_ = shown;
  sectionOffset_ = std::clamp(offset, -1.0, 1.0);
  updateView();
}

void Engine::faceSection() {
  if (!code_) return;
  const ProjectionFrame& frame = code_->print.frame;
  const Vec3 sideways = frame.normal * std::cos(kSectionYaw) + frame.right * std::sin(kSectionYaw);
  const ProjectionFrame oblique =
      makeFrame(frame.centre, sideways + camera_.skyward() * kSectionPitch, camera_.skyward(), frame.eyeDistance);
  camera_.lookThrough(oblique, kFacingEdges * code_->print.edgeMm);
}

std::string Engine::showDepths(bool shown) {
  showDepths_ = shown;
  updateView();
  return textOf({{"ok", true}, {"topMm", result_ ? depthColoursTopMm(result_->depths) : 0}});
}

bool Engine::draw(bool always) {
  if (!viewer_) return false;
  const double now = nowMs();
  const bool gliding = camera_.advance(now);
  const Result<bool> more = viewer_->draw(camera_.view(), now, nullptr, always);
  if (more) return *more || gliding;
  problems_.push_back(toldText(more.error().message));
  return false;
}

bool Engine::takesCode() const { return model_ && !jobRuns_ && symbol_ && model_->engravable->prepared.engravable(); }

Result<Engine::CodeOnSurface> Engine::estimatedCode(const SurfacePoint& at, std::optional<double> expectedMm) const {
  PlacementRequest request = request_.placement;
  request.upHint = camera_.skyward();
  auto estimate = estimateCode(*model_->engravable, model_->look, at, symbol_->size, request, expectedMm);
  if (!estimate) return tl::unexpected(estimate.error());
  CodeOnSurface code;
  code.symbolMm = estimate->symbolMm;
  code.rotationDeg = estimate->rotationDeg;
  code.guaranteedMm = estimate->guaranteedMm;
  code.missingShare = estimate->missingShare;
  code.reach = estimate->reach;
  code.print = symbolPrint(*symbol_, estimate->frame, estimate->symbolMm, request_);
  code.print.reach = estimate->reach;
  return code;
}

Result<Engine::CodeOnSurface> Engine::exactCode(const Symbol& symbol, const EngraveRequest& request,
                                                const Placement& placement) const {
  CodeOnSurface code;
  code.print = symbolPrint(symbol, placement.frame, placement.symbolMm, request);
  code.symbolMm = placement.symbolMm;
  code.rotationDeg = placement.rotationDeg;
  code.guaranteedMm = placement.guaranteedMm;
  code.isExact = true;
  auto reach = lookAround(model_->look, placement.frame, {kReachEdges * code.print.edgeMm, kReachTexels});
  if (!reach) return tl::unexpected(reach.error());
  auto trusted = std::make_shared<EyeReach>(*reach);
  trusted->trust();
  code.print.reach = std::move(trusted);
  code.reach = std::make_shared<const EyeReach>(std::move(*reach));
  return code;
}

std::string Engine::describeCode(const CodeOnSurface& code) const {
  return textOf({{"ok", true},
                 {"hit", true},
                 {"done", true},
                 {"onCode", false},
                 {"code",
                  {{"symbolMm", code.symbolMm},
                   {"moduleMm", code.symbolMm / symbol_->size},
                   {"guaranteedMm", code.guaranteedMm},
                   {"missingShare", code.missingShare},
                   {"exact", code.isExact}}}});
}

std::string Engine::hover(double x, double y) {
  settling_.reset();
  const auto at = takesCode() && !(showCarved_ && carvedDisplay_) ? surfaceAt(x, y) : std::nullopt;
  if (!at) {
    endHover();
    return textOf({{"ok", true}, {"hit", false}});
  }
  if (code_) {
    const SurfacePrint& print = code_->print;
    const Vec2 onPlane = glm::abs(print.frame.project(at->position));
    const bool isTowards =
        glm::dot(triangleNormal(model_->engravable->prepared.mesh, at->triangle), print.frame.eye() - at->position) > 0;
    if (isTowards && std::max(onPlane.x, onPlane.y) < print.edgeMm / 2) {
      endHover();
      return textOf({{"ok", true}, {"hit", true}, {"onCode", true}});
    }
  }
  auto code = estimatedCode(*at, hovered_ ? std::optional(hovered_->symbolMm) : std::nullopt);
  if (!code) return answer(code.error());
  hoveredAt_ = at;
  hovered_ = std::move(*code);
  viewer_->setGhost(hovered_->print);
  return describeCode(*hovered_);
}

void Engine::endHover() {
  settling_.reset();
  hovered_.reset();
  hoveredAt_.reset();
  if (viewer_) viewer_->setGhost({});
}

std::string Engine::startSettling() {
  if (!hoveredAt_ || !takesCode()) return answer(kNoCode);
  PlacementRequest request = request_.placement;
  request.centreMm = hoveredAt_->position;
  request.upHint = camera_.skyward();
  settling_.emplace(model_->engravable->prepared, model_->engravable->gpu, *pass_, symbol_->size, request);
  return done();
}

std::string Engine::advanceSettling() {
  if (!settling_) return answer(kNoCode);
  const Result<bool> found = settling_->step();
  if (found && !*found) return textOf({{"ok", true}, {"done", false}});
  auto code = found ? exactCode(*symbol_, request_, settling_->placement()) : tl::unexpected(found.error());
  settling_.reset();
  if (!code) return answer(code.error());
  hovered_ = std::move(*code);
  viewer_->setGhost(hovered_->print);
  return describeCode(*hovered_);
}

std::string Engine::moveCode(double x, double y) {
  const auto at = takesCode() ? surfaceAt(x, y) : std::nullopt;
  if (!at) return textOf({{"ok", true}, {"hit", false}});
  auto code = estimatedCode(*at);
  if (!code) return answer(code.error());
  endHover();
  placement_.reset();
  code_ = std::move(*code);
  if (viewer_) viewer_->setPrint(code_->print);
  return describeCode(*code_);
}

std::string Engine::adjustCode(double rotateDeg, double symbolMm) {
  if (!code_ || !takesCode()) return answer(kNoCode);
  if (!std::isfinite(rotateDeg) || !(symbolMm > 0))
    return answer(ErrorKind::BadUsage, fmt::format("a code of {:g} mm at {:g}° is asked for", symbolMm, rotateDeg),
                  "Give a size above 0");
  const double outer = roomFactor(symbol_->size, request_.placement.quietZone);
  code_->print.frame = turned(code_->print.frame, toRadians(rotateDeg - code_->rotationDeg));
  code_->print.edgeMm *= symbolMm / code_->symbolMm;
  code_->rotationDeg = rotateDeg;
  code_->symbolMm = symbolMm;
  code_->isExact = false;
  code_->print.reach = code_->reach;
  const Vec3 right = code_->print.frame.right;
  const double turn = std::atan2(glm::dot(right, code_->reach->frame.up), glm::dot(right, code_->reach->frame.right));
  code_->missingShare = code_->reach->missingShare(symbolMm * outer, turn);
  viewer_->setPrint(code_->print);
  return describeCode(*code_);
}

std::string Engine::viewState() const {
  const CameraView view = camera_.view();
  Json code;
  if (code_ && !(showCarved_ && carvedDisplay_)) {
    const SurfacePrint& print = code_->print;
    const Vec3 eye = view.eye();
    Json corners = Json::array();
    bool isBefore = true;
    for (const Vec2 corner : {Vec2(-1, 1), Vec2(1, 1), Vec2(1, -1), Vec2(-1, -1)}) {
      const Vec3 point = print.frame.onPlane(corner * (print.edgeMm / 2));
      isBefore = isBefore && glm::dot(eye - point, view.back) > 0;
      corners.push_back(jsonOf(camera_.toScreen(point)));
    }
    if (isBefore) {
      code = {{"corners", corners},
              {"facing", glm::dot(glm::normalize(eye - print.frame.centre), print.frame.normal)},
              {"symbolMm", code_->symbolMm},
              {"rotationDeg", code_->rotationDeg}};
    }
  }
  Json axes = Json::array();
  for (const Vec3 axis : {view.right, view.up, view.back}) axes.push_back(jsonOf(camera_.toTurntable(axis)));
  return textOf({{"code", code}, {"axes", axes}});
}

Engine::Picture Engine::spotPicture(std::size_t index, int width, int height) {
  if (index >= spots_.size() || !model_ || !symbol_) return {};
  if (!spotViewer_) {
    ViewQuality quality;
    quality.movingScale = 1;
    quality.settleMs = 0;
    quality.stillSamples = kSpotFrames;
    auto made = Viewer::create(quality);
    if (!made) return {};
    spotViewer_ = std::make_unique<Viewer>(std::move(*made));
  }
  const OfferedSpot& spot = spots_[index];
  const PlacementRequest& request = placingRequest_.placement;
  const ProjectionFrame upright = makeFrame(spot.centreMm, spot.direction, camera_.skyward(), request.eyeDistanceMm);
  const ProjectionFrame frame = turned(upright, toRadians(request.rotateDeg));
  SurfacePrint print = symbolPrint(*symbol_, frame, spot.symbolMm, request_);
  auto reach = lookAround(model_->look, frame, {kReachEdges * print.edgeMm, kReachTexels});
  if (!reach) return {};
  reach->trust();
  print.reach = std::make_shared<const EyeReach>(std::move(*reach));

  OrbitCamera camera = camera_;
  camera.setViewport(width, height);
  camera.lookThrough(upright, kSpotEdges * print.edgeMm);
  camera.finishGlide();
  spotViewer_->resize(width, height);
  spotViewer_->setTheme(dark_);
  spotViewer_->setMesh(model_->display);
  spotViewer_->setPrint(std::move(print));
  const gl::Texture canvas(width, height, gl::Format::RGBA8);
  const gl::Texture* const colours[] = {&canvas};
  const auto target = gl::Framebuffer::create(colours, false);
  if (!target) return {};
  double clock = 0;
  for (bool more = true; more;) {
    const auto drawn = spotViewer_->draw(camera.view(), clock += 1, &*target);
    if (!drawn) return {};
    more = *drawn;
  }
  spotViewer_->setMesh(nullptr);  // which may be replaced by another model
  Picture picture{width, height,
                  std::vector<std::uint8_t>(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
  target->bind();
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
  const auto stride = 4 * static_cast<std::ptrdiff_t>(width);
  for (int row = 0; row < height / 2; ++row)
    std::swap_ranges(picture.rgba.begin() + row * stride, picture.rgba.begin() + (row + 1) * stride,
                     picture.rgba.begin() + (height - 1 - row) * stride);
  return picture;
}

}  // namespace qrelief
