// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/printed_view.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "math/angle.h"
#include "printing/printed_rays.h"
#include "verification/baked_light.h"
#include "verification/reading_sweep.h"

namespace qrelief {
namespace {

constexpr int kPaths = 8;
constexpr int kRoughPaths = 2;  // more change little: a module has a hundred texels
constexpr double kRoughness = 1.5;
/// Beyond a symbol what stands there is printed, too, but lit only as far as modules are compared with it
/// (LightNeighbours): two modules, and the texels that these are smoothed with.
constexpr int kRoughBorder = kBakedPixels * (kPictureMarginModules - 2) - 1;

}  // namespace

Result<std::optional<PrintedViewRequest>> printedViewOf(const VerifyRequest& request) {
  if (!request.process) return std::nullopt;
  const auto process = processOf(request.printer);
  if (!process) return tl::unexpected(process.error());
  return PrintedViewRequest{.process = *process,
                            .frame = request.frame,
                            .symbol = request.symbol,
                            .symbolMm = request.symbolMm,
                            .buildUp = request.buildUp,
                            .albedo = request.albedo,
                            .oneLight = request.oneLight};
}

/// The stages in their order; each `advance` does one step of the current one.
struct PrintedViewJob::State {
  enum class Stage { Printing, Light, Done };

  const Mesh* model;
  PrintedViewRequest request;
  Stage stage = Stage::Printing;
  std::optional<PrintedRays> printed;
  std::optional<BakedLight> light;
  int bakedRows = 0;
  PrintedView result;

  int edgeModules() const { return request.symbol.size + 2 * kPictureMarginModules; }
  Status print();
  void prepare();
  void bake();
  void look();
  void photographSeen();
};

Status PrintedViewJob::State::print() {
  auto surface = printSurface(*model, {.process = request.process,
                                       .frame = request.frame,
                                       .extentMm = request.symbolMm / request.symbol.size * edgeModules(),
                                       .buildUp = request.buildUp,
                                       .roughness = request.isRough ? kRoughness : 1});
  if (!surface) return tl::unexpected(surface.error());
  printed.emplace(*surface);
  prepare();
  return {};
}

void PrintedViewJob::State::prepare() {
  light.emplace(
      *printed, request.frame,
      BakeOptions{.texelMm = request.symbolMm / request.symbol.size / kBakedPixels,
                  .texels = kBakedPixels * edgeModules(),
                  .border = request.isRough ? kRoughBorder : 0,
                  .paths = request.isRough ? kRoughPaths : kPaths,
                  .albedo = request.albedo,
                  .lamp = request.oneLight ? lampOf(*request.oneLight, request.frame, kOneLightRadiusDeg) : kNoLamp});
  stage = Stage::Light;
}

void PrintedViewJob::State::bake() {
  bakedRows += kRowsAStep;
  if (light->bakeRows(kRowsAStep)) look();
}

void PrintedViewJob::State::look() {
  light->smooth();
  if (!request.isRough) photographSeen();
  result.submodules = submoduleLight(*light, request.symbol.size, request.oneLight.has_value());
  result.misread = misreadModules(measureModules(request.symbol, result.submodules));
  const double cosine = glm::dot(request.frame.normal, glm::normalize(request.buildUp));
  result.facingDeg = toDegrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
  stage = Stage::Done;
}

void PrintedViewJob::State::photographSeen() {
  ReaderView& seen = result.seen;
  for (const SurfaceLight& texel : light->light())
    seen.luminance.push_back(texel.sky < 0 ? kBackground
                                           : static_cast<float>((texel.sky + texel.lamp) / light->openLight()));
  seen.pixelsPerModule = kBakedPixels;
  seen.clean = photograph(seen.luminance, light->options().texels);
}

PrintedViewJob::PrintedViewJob(std::unique_ptr<State> state) : state_(std::move(state)) {}
PrintedViewJob::~PrintedViewJob() = default;

Result<std::unique_ptr<PrintedViewJob>> PrintedViewJob::create(const Mesh& mesh, const PrintedViewRequest& request) {
  const double length = glm::length(request.buildUp);
  if (!(std::isfinite(length) && length > 0)) return fail(ErrorKind::BadUsage, message("no-build-direction"));
  auto state = std::make_unique<State>();
  state->model = &mesh;
  state->request = request;
  return std::unique_ptr<PrintedViewJob>(new PrintedViewJob(std::move(state)));
}

Result<Progress> PrintedViewJob::advance() {
  using Stage = State::Stage;
  State& s = *state_;
  Message doing = message("tracing-light-on-print");
  double fraction = 1;
  switch (s.stage) {
    case Stage::Printing:
      doing = message("printing");
      if (const Status printed = s.print(); !printed) return tl::unexpected(printed.error());
      fraction = 0.4;
      break;
    case Stage::Light:
      s.bake();
      fraction = 0.4 + 0.6 * std::min(1.0, static_cast<double>(s.bakedRows) / s.light->options().texels);
      break;
    case Stage::Done:
      assert(false && "advance() after done");
      break;
  }
  return Progress{std::move(doing), fraction, s.stage == Stage::Done};
}

PrintedView PrintedViewJob::takeResult() {
  assert(state_->stage == State::Stage::Done);
  return std::move(state_->result);
}

}  // namespace qrelief
