// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/printed_view.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/job_stages.h"
#include "light/height_light.h"
#include "math/angle.h"
#include "message_codes/printing.h"
#include "message_codes/stages.h"
#include "printing/printed_ink.h"
#include "verification/baked_light.h"
#include "verification/inlaid_surface.h"
#include "verification/reading_sweep.h"
#include "verification/resample.h"

namespace qrelief {
namespace {

constexpr double kRoughness = 1.5;
constexpr double kColourRoughness = 2;  // colours need the shape only for its shades: two texels a layer
constexpr int kDirections = 12;         // with 64, a module's mean luminance differs by 0.0016 on average
/// Margin of a rough print: the reach of LightNeighbours, which compares dark modules with light ones, and one module
/// more. Pixels farther out take the border's value.
constexpr int kRoughMarginModules = 3;
constexpr double kEveryPatch = 20;  // up to this distance a horizon checks every patch

}  // namespace

Result<std::optional<PrintedViewRequest>> printedViewOf(const VerifyRequest& request) {
  if (!request.process || request.isText()) return std::nullopt;  // a text alone has nothing to decode
  const auto process = processOf(request.printer);
  QRELIEF_TRY(process);
  return PrintedViewRequest{.process = *process,
                            .frame = request.frame,
                            .symbol = request.symbol,
                            .symbolMm = request.symbolMm,
                            .buildUp = request.buildUp,
                            .albedo = request.albedo,
                            .lamps = request.lamps,
                            .mark = request.mark,
                            .markDepthMm = request.markDepthMm,
                            .ink = request.ink(),
                            .label = request.label};
}

/// The job's state.
struct PrintedViewJob::State {
  const Mesh* model;
  PrintedViewRequest request;
  JobStages<State> stages = stagesOf(request);
  HeightMap printed;
  Mesh outside;              // of a body with its inlay
  Symbol marked;             // of a code in colour: the modules in the second colour ...
  std::vector<Ring> around;  // ... and the label in it, mm on the QR plane
  double bedMm = 0;          // height of the model's lowest point
  PrintedView result;

  State(const Mesh& mesh, const PrintedViewRequest& viewed) : model(&mesh), request(viewed) {}

  static JobStages<State> stagesOf(const PrintedViewRequest& request);
  int edgeModules() const { return request.symbol.size + 2 * kPictureMarginModules; }
  /// Returns the edge of the printed area, in modules.
  int printedModules() const { return request.isRough ? request.symbol.size + 2 * kRoughMarginModules : edgeModules(); }
  double roughness() const {
    return request.isRough ? kRoughness : request.mark != Mark::Shadow ? kColourRoughness : 1;
  }
  const Mesh& shape();
  Result<StageStep> print();
  Result<StageStep> light();
  void addInk(BottomUp<float>& luminance, const PictureGrid& grid) const;
};

/// Weights are in relation to each other, on the page's samples.
JobStages<PrintedViewJob::State> PrintedViewJob::State::stagesOf(const PrintedViewRequest& request) {
  return {{message<"printing">(), request.mark == Mark::Shadow ? 9.0 : 1.0, &State::print},
          {message<"lighting-print">(), 1, &State::light}};
}

/// Finds the shape to print, and the modules and the label in the second colour.
const Mesh& PrintedViewJob::State::shape() {
  marked = request.symbol;
  bedMm = std::numeric_limits<double>::infinity();
  const Vec3 up = glm::normalize(request.buildUp);
  for (const Vec3f p : model->positions) bedMm = std::min(bedMm, glm::dot(Vec3(p), up));
  if (request.mark == Mark::Shadow) return *model;
  if (auto label = layOutLabel(request.label, request.symbol.size)) around = std::move(label->rings);
  for (Ring& ring : around)
    for (Vec2& corner : ring) corner *= request.symbolMm / request.symbol.size;
  if (request.mark == Mark::Paint) return *model;
  InlaidSurface surface =
      inlaidSurface(*model, request.frame, request.symbol.size, request.symbolMm, request.markDepthMm);
  marked.dark = std::move(surface.inlaid);
  outside = std::move(surface.mesh);
  return outside;
}

Result<StageStep> PrintedViewJob::State::print() {
  auto surface = printSurface(shape(), {.process = request.process,
                                        .frame = request.frame,
                                        .extentMm = request.symbolMm / request.symbol.size * printedModules(),
                                        .buildUp = request.buildUp,
                                        .roughness = roughness()});
  QRELIEF_TRY(surface);
  printed = surface->heightMap();
  return kStageDone;
}

/// Multiplies a picture by the reflectances of the printed materials.
void PrintedViewJob::State::addInk(BottomUp<float>& luminance, const PictureGrid& grid) const {
  if (request.mark == Mark::Shadow) return;
  InkMap(printedInk({.process = request.process,
                     .symbol = marked,
                     .symbolMm = request.symbolMm,
                     .around = around,
                     .frame = request.frame,
                     .buildUp = request.buildUp,
                     .bedMm = bedMm},
                    {grid.pixelMm, grid.pixels}),
         grid.pixelMm, request.ink)
      .apply(luminance, grid.pixelMm);
}

Result<StageStep> PrintedViewJob::State::light() {
  LightOptions options{.sampling = {.points = 1, .directions = kDirections},
                       .reachMm = printed.size * printed.patchMm * std::numbers::sqrt2,
                       .everyPatchMm = kEveryPatch * printed.patchMm,
                       .lamps = request.lamps,
                       .lampRadiusDeg = kLampRadiusDeg};
  const HeightLight surface(printed);
  std::vector<Received> received;
  surface.measure(options, {}, received);
  const std::vector<float> luminance = surface.luminance(options, received, request.albedo);
  const PictureGrid grid{request.symbolMm / request.symbol.size / kBakedPixels, kBakedPixels * edgeModules()};
  if (!request.isRough) {
    ReaderView& seen = result.seen;
    seen.luminance = litPicture(printed, luminance, grid, kBackground);
    addInk(seen.luminance, grid);
    seen.pixelsPerModule = kBakedPixels;
    seen.clean = photograph(seen.luminance);
  }
  BottomUp<float> open = litPicture(printed, luminance, grid, 1);
  addInk(open, grid);
  result.submodules = submoduleMeans(open, request.symbol.size);
  const bool isInverted = request.mark != Mark::Shadow && request.ink.isInverted();
  result.misread = misreadModules(measureModules(
      request.symbol, isInverted ? withoutInversion(result.submodules, request.ink) : result.submodules));
  const double cosine = glm::dot(request.frame.normal, glm::normalize(request.buildUp));
  result.facingDeg = toDegrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
  return kStageDone;
}

PrintedViewJob::PrintedViewJob(std::unique_ptr<State> state) : state_(std::move(state)) {}
PrintedViewJob::~PrintedViewJob() = default;

Result<std::unique_ptr<PrintedViewJob>> PrintedViewJob::create(const Mesh& mesh, const PrintedViewRequest& request) {
  const double length = glm::length(request.buildUp);
  if (!(std::isfinite(length) && length > 0)) return fail(ErrorKind::BadUsage, message<"no-build-direction">());
  return std::unique_ptr<PrintedViewJob>(new PrintedViewJob(std::make_unique<State>(mesh, request)));
}

Progress PrintedViewJob::progress() const { return state_->stages.progress(); }

Result<Progress> PrintedViewJob::advance() { return state_->stages.advance(*state_); }

PrintedView PrintedViewJob::takeResult() {
  assert(state_->stages.done());
  return std::move(state_->result);
}

}  // namespace qrelief
