// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/viewer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "base/halton.h"
#include "math/angle.h"
#include "printing/build_direction.h"
#include "shaders.h"

namespace qrelief {
namespace {

constexpr double kRadiusShare = 0.08;  // reach of the occlusion, as a part of the model's diagonal
constexpr double kRadiusLimit = 0.15;  // greatest reach on the screen, as a part of the picture's height
// Sixteenths of a turn, each far from the previous ones: even a few pictures average to little pattern.
constexpr std::array<int, 16> kTurns = {0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15};
// Pictures averaged before the average is shown again: of fewer it is noisier than the blurred first one, and each time
// costs a software renderer a third of a picture.
constexpr int kShownEvery = 4;
constexpr double kSlowFrameMs = 50;  // intervals above this lower the resolution while moving,
constexpr double kFastFrameMs = 22;  // and below this raise it again
constexpr int kSlowFrames = 4;       // this many in a row
constexpr int kFastFrames = 20;
constexpr double kCoarsestScale = 0.4;
constexpr double kHatchShare = 0.016;  // distance between stripes of a cut, as a part of the model's diagonal

constexpr Vec3f kLightBackground[2] = {{0.66f, 0.69f, 0.73f}, {0.87f, 0.89f, 0.92f}};
constexpr Vec3f kDarkBackground[2] = {{0.010f, 0.012f, 0.016f}, {0.035f, 0.041f, 0.051f}};

bool isSoftware(std::string_view renderer) {
  return renderer.find("SwiftShader") != std::string_view::npos ||
         renderer.find("llvmpipe") != std::string_view::npos || renderer.find("Basic Render") != std::string_view::npos;
}

}  // namespace

ViewQuality ViewQuality::suitedTo(const gl::Capabilities& capabilities) {
  ViewQuality quality;
  if (isSoftware(capabilities.renderer)) return quality;
  quality.movingScale = quality.movingCanvas = 1;
  quality.movingSteps = 4;
  quality.stillSteps = 8;
  quality.stillSlices = 1;
  quality.stillSamples = 32;
  quality.movingShadowTexels = quality.stillShadowTexels = 2048;
  quality.mostPixels = 4.2e6;
  return quality;
}

Result<Viewer> Viewer::create(const ViewQuality& quality) {
  struct Source {
    gl::Program Viewer::*program;
    const char* name;
    const char* vertex;
    const char* fragment;
  };
  const std::array<Source, 8> sources = {{
      {&Viewer::surface_, "view surface", shaders::view_surface_vert, shaders::view_surface_frag},
      {&Viewer::occlusion_, "view occlusion", shaders::fullscreen_vert, shaders::view_hbao_frag},
      {&Viewer::blur_, "view blur", shaders::fullscreen_vert, shaders::view_blur_frag},
      {&Viewer::lighting_, "view lighting", shaders::fullscreen_vert, shaders::view_lighting_frag},
      {&Viewer::present_, "view present", shaders::fullscreen_vert, shaders::view_present_frag},
      {&Viewer::decalProgram_, "view decal", shaders::fullscreen_vert, shaders::view_decal_frag},
      {&Viewer::plateProgram_, "view plate", shaders::view_plate_vert, shaders::view_plate_frag},
      {&Viewer::copy_, "view copy", shaders::fullscreen_vert, shaders::view_copy_frag},
  }};
  Viewer viewer;
  viewer.quality_ = quality;
  viewer.mostScale_ = quality.movingScale;
  for (const Source& source : sources) {
    auto program = gl::Program::create(source.name, source.vertex, source.fragment);
    QRELIEF_TRY(program);
    viewer.*source.program = std::move(*program);
  }
  auto lines = LinePass::create();
  QRELIEF_TRY(lines);
  viewer.linePass_ = std::move(*lines);
  auto shadows = LampShadows::create();
  QRELIEF_TRY(shadows);
  viewer.shadows_ = std::move(*shadows);
  return viewer;
}

void Viewer::resize(int width, int height) {
  width_ = std::max(1, width);
  height_ = std::max(1, height);
  changed_ = true;
}

void Viewer::setMesh(std::shared_ptr<const GpuMesh> mesh) {
  if (mesh_ == mesh) return;
  mesh_ = std::move(mesh);
  shadows_.forget();
  changed_ = true;
}

void Viewer::showHeat(HeatShown heat) {
  if (heatShown_ == heat) return;
  heatShown_ = heat;
  changed_ = true;
}

void Viewer::setColours(const SurfaceColours& colours) {
  if (colours_ == colours) return;
  colours_ = colours;
  changed_ = true;
}

void Viewer::setDecal(std::optional<Decal> decal) {
  decal_.decal = std::move(decal);
  decal_.isUploaded = false;
  printsChanged_ = true;
  if (plainHasPrint_) plainIsCurrent_ = false;
}

void Viewer::setGhost(std::optional<Decal> ghost) {
  if (!ghost && !ghost_.decal) return;
  ghost_.decal = std::move(ghost);
  ghost_.isUploaded = false;
  printsChanged_ = true;
}

void Viewer::setCut(std::optional<CuttingPlane> cut) {
  if (!cut && !cut_) return;
  cut_ = cut;
  shadows_.forget();
  changed_ = true;
}

void Viewer::setLight(std::optional<LampLight> light) {
  if (light == light_) return;
  light_ = std::move(light);
  lightChanged_ = true;
}

void Viewer::setPlate(std::optional<BuildPlate> plate) {
  if (plate == plate_) return;
  plate_ = plate;
  changed_ = true;
}

void Viewer::setMarker(std::optional<Vec3> marker) {
  marker_ = marker;
  printsChanged_ = true;
  plainIsCurrent_ = false;
}

void Viewer::setLines(LineDrawing lines) {
  if (lines == lines_) return;
  lines_ = std::move(lines);
  linePass_.set(lines_);
  printsChanged_ = true;
}

void Viewer::setTheme(bool dark) {
  dark_ = dark;
  changed_ = true;
}

Result<Viewer::Stage> Viewer::makeStage(int width, int height, StageUse use) {
  Stage stage;
  stage.width = width;
  stage.height = height;
  struct Target {
    gl::Texture Stage::*texture;
    gl::Framebuffer Stage::*framebuffer;
    gl::Format format;
    StageUse neededFor;  // and for the uses before it
    bool withDepth = false;
  };
  const std::array<Target, 4> targets = {{
      {&Stage::colour, &Stage::colourTarget, gl::Format::RGBA16F, StageUse::Sum},
      {&Stage::visibility, &Stage::visibilityTarget, gl::Format::RGBA16F, StageUse::Still},
      {&Stage::surface, &Stage::surfaceTarget, gl::Format::RGBA32F, StageUse::Still, true},
      {&Stage::smoothVisibility, &Stage::smoothVisibilityTarget, gl::Format::RGBA16F, StageUse::Moving},
  }};
  for (const Target& target : targets) {
    if (use > target.neededFor) continue;
    gl::Texture& texture = stage.*target.texture;
    texture = gl::Texture(width, height, target.format);
    const gl::Texture* const colours[] = {&texture};
    auto framebuffer = gl::Framebuffer::create(colours, target.withDepth);
    QRELIEF_TRY(framebuffer);
    stage.*target.framebuffer = std::move(*framebuffer);
  }
  stage.colour.useLinearFilter();
  return stage;
}

Status Viewer::prepareStage(std::optional<Stage>& stage, double scale, StageUse use) {
  const double pixels = static_cast<double>(width_) * height_;
  const double bounded = scale * std::min(1.0, std::sqrt(quality_.mostPixels / pixels));
  const int width = std::max(1, static_cast<int>(std::lround(width_ * bounded)));
  const int height = std::max(1, static_cast<int>(std::lround(height_ * bounded)));
  if (stage && stage->width == width && stage->height == height) return {};
  stage.reset();  // before making the new one: two sets of full size may not fit
  auto created = makeStage(width, height, use);
  QRELIEF_TRY(created);
  stage = std::move(*created);
  return {};
}

void Viewer::setCamera(const gl::Program& program, const CameraView& camera, Vec2 jitter) const {
  program.use();
  program.set("u_tanHalf", glm::vec2(camera.tanHalf));
  program.set("u_distance", static_cast<float>(camera.distance));
  program.set("u_jitter", glm::vec2(jitter));
}

void Viewer::setGBuffer(const gl::Program& program, const Stage& stage, const CameraView& camera, Vec2 jitter) const {
  setCamera(program, camera, jitter);
  program.set("u_size", glm::vec2(stage.width, stage.height));
}

void Viewer::drawSurface(const Stage& stage, const CameraView& camera, Vec2 jitter) const {
  stage.surfaceTarget.bind();
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);  // open models are visible from inside, too
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glFrontFace(GL_CCW);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  if (!mesh_) return;
  setCamera(surface_, camera, jitter);
  surface_.set("u_right", Vec3f(camera.right));
  surface_.set("u_up", Vec3f(camera.up));
  surface_.set("u_back", Vec3f(camera.back));
  surface_.set("u_target", Vec3f(camera.target - mesh_->origin()));
  surface_.set("u_depthRange", glm::vec2(camera.depthRange));
  surface_.set("u_isColoured", heatShown_ == HeatShown::Colours ? 1 : 0);
  surface_.set("u_isCut", cut_ ? 1 : 0);
  if (cut_) {
    const double along = glm::dot(cut_->point - camera.target, cut_->normal);
    surface_.set("u_cut", glm::vec4(camera.inView(cut_->normal), static_cast<float>(along)));
  }
  mesh_->draw();
  glDisable(GL_DEPTH_TEST);
}

double Viewer::radiusMm() const { return mesh_ ? kRadiusShare * mesh_->box().diagonal() : 1; }

void Viewer::drawOcclusion(const Stage& stage, const CameraView& camera, Vec2 jitter, const Sample& sample) const {
  stage.visibilityTarget.bind();
  setGBuffer(occlusion_, stage, camera, jitter);
  occlusion_.setTexture("u_surface", 0, stage.surface);
  occlusion_.set("u_slices", sample.slices);
  occlusion_.set("u_steps", sample.steps);
  occlusion_.set("u_radius", static_cast<float>(radiusMm()));
  occlusion_.set("u_radiusLimit", static_cast<float>(kRadiusLimit * stage.height));
  occlusion_.set("u_turn", static_cast<float>(sample.turn));
  occlusion_.set("u_shift", static_cast<float>(sample.shift));
  gl::drawFullscreen();
}

void Viewer::blurOcclusion(const Stage& stage, const CameraView& camera, Vec2 jitter) const {
  stage.smoothVisibilityTarget.bind();
  const double pixelMm = 2 * camera.tanHalf.y * camera.distance / stage.height;
  setGBuffer(blur_, stage, camera, jitter);
  blur_.setTexture("u_surface", 0, stage.surface);
  blur_.setTexture("u_visibility", 1, stage.visibility);
  blur_.set("u_unit", static_cast<float>(radiusMm()));
  blur_.set("u_reach", static_cast<float>(8 * pixelMm));
  gl::drawFullscreen();
}

void Viewer::drawLighting(const Stage& stage, const Stage& into, const CameraView& camera, Vec2 jitter,
                          const Sample& sample) const {
  into.colourTarget.bind();
  const CuttingPlane cut = cut_.value_or(CuttingPlane{});
  const Vec3 across = glm::normalize(makeFrame({}, cut.normal, camera.skyward, 1).onPlane({1, 1}));
  setGBuffer(lighting_, stage, camera, jitter);
  lighting_.setTexture("u_surface", 0, stage.surface);
  lighting_.setTexture("u_visibility", 1, sample.blur ? stage.smoothVisibility : stage.visibility);
  lighting_.set("u_skyward", camera.inView(camera.skyward));
  lighting_.set("u_background[0]", dark_ ? kDarkBackground[0] : kLightBackground[0]);
  lighting_.set("u_background[1]", dark_ ? kDarkBackground[1] : kLightBackground[1]);
  lighting_.set("u_heatShown", static_cast<int>(heatShown_));
  lighting_.set("u_material", colours_.body);
  lighting_.set("u_hatch", glm::vec4(camera.inView(across), static_cast<float>(glm::dot(camera.target, across))));
  lighting_.set("u_hatchMm", static_cast<float>(kHatchShare / kRadiusShare * radiusMm()));
  const BuildPlate plate = plate_.value_or(BuildPlate{});
  lighting_.set("u_plate", glm::vec4(camera.inView(plate.up),
                                     static_cast<float>(glm::dot(plate.centre - camera.target, plate.up))));
  lighting_.set("u_overhangCosine", plate_ ? static_cast<float>(std::cos(toRadians(kSteepestOverhangDeg))) : -2.0f);
  if (light_ && mesh_)
    shadows_.set(lighting_, camera, 2);
  else
    shadows_.setNone(lighting_, 2);
  if (sample.weight < 1) {
    glEnable(GL_BLEND);
    glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    glBlendColor(0, 0, 0, static_cast<float>(sample.weight));
  }
  gl::drawFullscreen();
  glDisable(GL_BLEND);
}

Vec2 Viewer::jitterOf(const Sample& sample, const Stage& stage) {
  return {2 * sample.jitterPx.x / stage.width, 2 * sample.jitterPx.y / stage.height};
}

Status Viewer::drawSample(const Stage& stage, const Stage& into, const CameraView& camera, const Sample& sample) {
  if (light_ && mesh_) QRELIEF_TRY(shadows_.draw(*light_, *mesh_, cut_, sample.shadowTexels));
  const Vec2 jitter = jitterOf(sample, stage);
  if (!sample.isLightOnly) {
    drawSurface(stage, camera, jitter);
    drawOcclusion(stage, camera, jitter, sample);
    if (sample.blur) blurOcclusion(stage, camera, jitter);
  }
  drawLighting(stage, into, camera, jitter, sample);
  return {};
}

void Viewer::adaptToInterval(double nowMs) {
  if (!lastMovingMs_) return;
  const double interval = nowMs - *lastMovingMs_;
  statistics_.coarseFrameMs =
      statistics_.coarseFrameMs > 0 ? 0.8 * statistics_.coarseFrameMs + 0.2 * interval : interval;
  slowFrames_ = interval > kSlowFrameMs ? slowFrames_ + 1 : 0;
  fastFrames_ = interval < kFastFrameMs ? fastFrames_ + 1 : 0;
  if (slowFrames_ < kSlowFrames && fastFrames_ < kFastFrames) return;
  const double scale = quality_.movingScale * (slowFrames_ > 0 ? 0.75 : 1.15);
  quality_.movingScale = std::clamp(scale, std::min(kCoarsestScale, mostScale_), mostScale_);
  slowFrames_ = fastFrames_ = 0;
}

Result<bool> Viewer::drawMoving(const CameraView& camera, double nowMs, const gl::Framebuffer* target,
                                bool isLightOnly) {
  adaptToInterval(nowMs);
  const int width = moving_ ? moving_->width : 0, height = moving_ ? moving_->height : 0;
  QRELIEF_TRY(prepareStage(moving_, quality_.movingScale, StageUse::Moving));
  Sample sample;
  sample.isLightOnly = isLightOnly && moving_->width == width && moving_->height == height;
  sample.steps = quality_.movingSteps;
  sample.shadowTexels = quality_.movingShadowTexels;
  sample.blur = true;
  QRELIEF_TRY(drawSample(*moving_, *moving_, camera, sample));
  picture_ = {&*moving_, &*moving_, {}};
  plainIsCurrent_ = false;
  QRELIEF_TRY(presentMoving(camera, target));
  statistics_ = {statistics_.coarseFrameMs, 0, moving_->width, moving_->height};
  lastMovingMs_ = nowMs;
  return true;
}

Result<bool> Viewer::drawStill(const CameraView& camera, const gl::Framebuffer* target, bool always) {
  QRELIEF_TRY(prepareStage(still_, 1, StageUse::Still));
  QRELIEF_TRY(prepareStage(sum_, 1, StageUse::Sum));
  const auto index = static_cast<std::uint32_t>(++statistics_.samples);
  const auto [x, y] = halton23(index);
  Sample sample;
  sample.jitterPx = {x - 0.5, y - 0.5};
  sample.turn = kTurns[index % 16] / 16.0;
  const std::uint32_t round = index / 16;
  sample.shift = 0.35 + 0.5 * round;
  sample.slices = quality_.stillSlices;
  sample.steps = quality_.stillSteps;
  sample.shadowTexels = quality_.stillShadowTexels;
  sample.weight = 1.0 / index;
  QRELIEF_TRY(drawSample(*still_, *sum_, camera, sample));
  statistics_.width = still_->width;
  statistics_.height = still_->height;
  const bool finished = statistics_.samples >= quality_.stillSamples;
  if (finished || statistics_.samples >= kShownEvery) picture_ = {&*sum_, &*still_, jitterOf(sample, *still_)};
  plainIsCurrent_ = false;
  if (always || finished || statistics_.samples % kShownEvery == 0) present(camera, target);
  return !finished;
}

Result<bool> Viewer::draw(const CameraView& camera, double nowMs, const gl::Framebuffer* target, bool always) {
  if (changed_ || lightChanged_ || camera != lastCamera_) {
    const bool isLightOnly = !changed_ && camera == lastCamera_;
    changed_ = lightChanged_ = false;
    lastCamera_ = camera;
    lastChangeMs_ = nowMs;
    return drawMoving(camera, nowMs, target, isLightOnly);
  }
  lastMovingMs_.reset();
  if (printsChanged_) lastChangeMs_ = nowMs;  // so that refinement does not slow down moving a code
  const bool settled = nowMs - lastChangeMs_ >= quality_.settleMs;
  const bool finished = statistics_.samples >= quality_.stillSamples;
  if (settled && isCoarse_) {  // the first refined picture takes a while
    present(camera, target);
    return true;
  }
  if (settled && !finished) return drawStill(camera, target, always);
  if (printsChanged_) {
    QRELIEF_TRY(presentPrints(camera, target));
  } else if (always) {
    present(camera, target);
  }
  return !finished;
}

}  // namespace qrelief
