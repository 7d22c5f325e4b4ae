// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/engrave.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "base/clock.h"
#include "carving/embed.h"
#include "io/read_model.h"
#include "io/write_stl.h"
#include "math/tolerance.h"
#include "mesh/weld.h"
#include "pipeline/add_inlay.h"
#include "pipeline/carved_parts.h"
#include "pipeline/cell_layout.h"
#include "pipeline/contrast_for_print.h"
#include "pipeline/default_patterns.h"
#include "pipeline/depth_limits.h"
#include "pipeline/printed_view.h"
#include "pipeline/verify.h"
#include "settings/settings.h"
#include "verification/mesh_luminance.h"
#include "verification/reading_sweep.h"

namespace qrelief {
namespace {

constexpr double kViewReachPerDepth = 4;  // at four times its height away a wall hides 1.5 % of the sky
/// Size of the picture for the decoder, in pixels: at most along its edge, for large symbols, and at least along a
/// module's edge.
constexpr int kMostPixels = 1200, kLeastPixelsPerModule = 5;

/// Refuses defects that carving has added. Crossings count only if the model had none, because facets that crossed
/// before may have been cut.
Status checkNewDefects(SolidityReport solidity, const PreparedModel& before) {
  if (before.crossesItself) solidity.selfIntersections = 0;
  if (solidity.solid()) return {};
  return fail(ErrorKind::NoSolution, message("carved-not-solid", with::cause<"problem">(solidity.problems().front())));
}

}  // namespace

DepthSummary summarise(const DepthField& depths) {
  std::vector<double> carved;
  for (const double depth : depths.depthMm)
    if (depth > 0) carved.push_back(depth);
  if (carved.empty()) return {};
  std::sort(carved.begin(), carved.end());
  DepthSummary summary;
  for (const double depth : carved) summary.meanMm += depth / static_cast<double>(carved.size());
  summary.maxMm = carved.back();
  summary.p95Mm = carved[static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(carved.size()))) - 1];
  return summary;
}

CarvedFeatures featuresOf(const EngraveResult& result) {
  std::vector<std::uint8_t> carved;
  for (const double depth : result.depths.depthMm) carved.push_back(depth > 0);
  return measureFeatures(result.symbol, carved, result.depths.depthMm, result.placement.moduleMm);
}

/// The job's state. Stages are listed in order; each advance() does one step of the current stage.
struct EngraveJob::State {
  enum class Stage { Placing, Mapping, Searching, Embedding, Printing, Writing, Checking, Viewing, Done };

  std::shared_ptr<const EngravableModel> model;
  EngraveRequest request;
  EngraveRequest asked;  // before open patterns are filled in
  std::shared_ptr<const GeometryPass> pass;
  std::shared_ptr<const LuminancePrograms> programs;
  Stage stage = Stage::Placing;
  double fraction = 0;

  Symbol symbol;
  SubmoduleMask mask;
  CellLayout layout;
  std::optional<PlacementSearch> placing;
  std::shared_ptr<MeasuredPlace> measured;  // before its stage: an earlier measurement, perhaps of this place
  bool isMeasured = false;
  LightBy lightBy = LightBy::Renderer;
  CarvingTarget target;
  MakeSearch makeOwnSearch;  // empty: the request decides
  std::unique_ptr<PlaceSearch> search;
  EmbedResult embedded;
  std::unique_ptr<PrintedViewJob> printing;
  bool isPrinted = false;  // true once the print has been taken into account
  EngraveResult result;

  Status place();
  void take(const PlacementSearch& found);
  void decidePatterns(bool areWallsThin);
  std::vector<double> limitsOfMask() const;
  Status map();
  Status searchOnce();
  Status embed();
  Status print();
  Status write();
  Status check();
  void view();
  void startRecord(std::span<const double> limitMm);
  Progress progress();
};

Progress EngraveJob::State::progress() {
  auto [doing, share] = [&]() -> std::pair<Message, double> {
    switch (stage) {
      case Stage::Placing:
        return {message("finding-direction-and-size"), 0.05};
      case Stage::Mapping:
        return {message("measuring-surface"), 0.15};
      case Stage::Searching: {
        const double done = search->doneFraction();
        if (!request.isForPrint()) return {message("finding-depth"), 0.25 + 0.45 * done};
        return {message("finding-depth"), isPrinted ? 0.55 + 0.15 * done : 0.25 + 0.15 * done};
      }
      case Stage::Printing:
        return {message("printing"), 0.45};
      case Stage::Embedding:
        return {message("carving-mesh"), request.isForPrint() && !isPrinted ? 0.4 : 0.7};
      case Stage::Writing:
      case Stage::Checking:
        return {message("checking-solid"), 0.8};
      case Stage::Viewing:
      case Stage::Done:
        break;
    }
    return {message("looking-at-result"), stage == Stage::Done ? 1 : 0.9};
  }();
  fraction = std::max(fraction, share);
  return {std::move(doing), fraction, stage == Stage::Done};
}

Status EngraveJob::State::place() {
  const Result<bool> placed = placing->step();
  if (!placed) return tl::unexpected(placed.error());
  if (*placed) take(*placing);
  return {};
}

void EngraveJob::State::take(const PlacementSearch& found) {
  result.placement = found.placement();
  result.timingsMs.direction = found.directionMs();
  result.timingsMs.size = found.sizeMs();
  asked = std::move(request);
  decidePatterns(false);
  stage = Stage::Mapping;
}

void EngraveJob::State::decidePatterns(bool areWallsThin) {
  request = withDefaultPatterns(asked, result.placement.moduleMm, areWallsThin);
  mask = submodulesToCarve(symbol, *request.modulePattern, *request.finderPattern);
}

std::vector<double> EngraveJob::State::limitsOfMask() const {
  return depthLimits(model->prepared.mesh, result.placement, mask, measured->thicknessMm(),
                     {*request.maxDepthMm, request.minWallMm});
}

Status EngraveJob::State::map() {
  const auto start = Clock::now();
  const Placement& placement = result.placement;
  const MeasuredPlace::Request wanted{placement.frame, placement.moduleMm, layout,
                                      request.albedo,  request.lamps(),    lightBy};
  if (measured && measured->request() == wanted) {
    measured->light().uncarve();
  } else {
    auto made = MeasuredPlace::create(model, pass, programs, wanted);
    if (!made) return tl::unexpected(made.error());
    measured = std::move(*made);
  }
  isMeasured = true;

  std::vector<double> limits = limitsOfMask();
  if (!asked.finderPattern && request.finderPattern == FinderPattern::None &&
      wallsAreThinForWholeFinders(symbol, limits, placement.moduleMm)) {
    decidePatterns(true);
    limits = limitsOfMask();
  }
  if (request.recordSearch) startRecord(limits);
  target = {&symbol, &mask, placement.symbolMm, std::move(limits)};
  auto started = PlaceSearch::create(request, target, {layout, placement.moduleMm, &measured->light()}, makeOwnSearch);
  if (!started) return tl::unexpected(started.error());
  search = std::move(*started);
  result.timingsMs.surface = millisecondsSince(start);
  stage = Stage::Searching;
  return {};
}

void EngraveJob::State::startRecord(std::span<const double> limitMm) {
  for (std::size_t i = 0; i < mask.carved.size(); ++i) {
    if (!mask.carved[i]) continue;
    result.search.carved.push_back(static_cast<std::uint32_t>(i));
    result.search.limitMm.push_back(static_cast<float>(limitMm[i]));
  }
}

Status EngraveJob::State::searchOnce() {
  const auto start = Clock::now();
  search->step(request.recordSearch ? &result.search : nullptr);
  result.timingsMs.depthSearch += millisecondsSince(start);
  if (!search->finished()) return {};
  result.depths = search->depths();
  result.searchIterations += search->iterations();
  result.limitedSubmodules = search->limitedCount();
  result.luminance = search->luminance();
  result.received = search->received();
  if (summarise(result.depths).maxMm == 0)
    return fail(ErrorKind::NoSolution, message("nothing-can-be-carved", with::lengthMm<"wall">(request.minWallMm)));
  stage = Stage::Embedding;
  return {};
}

Status EngraveJob::State::embed() {
  const auto start = Clock::now();
  auto made = embedDepthField(model->prepared.mesh, result.placement.frame, result.placement.patch.triangles,
                              result.depths, {.surface = request.surface});
  if (!made) return tl::unexpected(made.error());
  embedded = std::move(*made);
  result.keptTriangles = embedded.keptTriangles;
  result.timingsMs.embed += millisecondsSince(start);
  stage = request.isForPrint() && !isPrinted ? Stage::Printing : Stage::Writing;
  return {};
}

/// Simulates the print, a piece at a time, and starts a second search if the print lacks contrast.
Status EngraveJob::State::print() {
  const auto start = Clock::now();
  if (!printing) {
    VerifyRequest printed = verifyRequestOf(request, result);
    printed.symbol = symbol;
    auto wanted = printedViewOf(printed);
    if (!wanted) return tl::unexpected(wanted.error());
    (*wanted)->isRough = true;
    auto job = PrintedViewJob::create(embedded.mesh, **wanted);
    if (!job) return tl::unexpected(job.error());
    printing = std::move(*job);
  }
  const auto progress = printing->advance();
  if (!progress) return tl::unexpected(progress.error());
  if (progress->done) {
    search->restart(
        contrastForPrint(symbol, result.luminance, printing->takeResult().submodules, request.contrastAsked()));
    printing.reset();
    embedded = {};
    isPrinted = true;
    stage = Stage::Searching;
  }
  result.timingsMs.forPrint += millisecondsSince(start);
  return {};
}

/// Writes the file and reads it back: the result is exactly what a slicer will read.
Status EngraveJob::State::write() {
  const auto start = Clock::now();
  result.stl = writeStl(embedded.mesh);
  const auto read = readModel(result.stl, "carved.stl");
  if (!read) return tl::unexpected(read.error());
  result.mesh = welded(std::vector<Vec3f>(read->positions.begin(), read->positions.end()), read->triangles);
  result.symbol = symbol;
  result.request = request;
  result.timingsMs.verify += millisecondsSince(start);
  stage = Stage::Checking;
  return {};
}

Status EngraveJob::State::check() {
  const auto start = Clock::now();
  const auto solidity = checkSolidity(result.mesh, embedded.newTriangles);
  if (!solidity) return tl::unexpected(solidity.error());
  result.solidity = *solidity;
  if (const Status sound = checkNewDefects(result.solidity, model->prepared); !sound) return sound;
  if (model->prepared.crossesItself) {  // count crossings of the whole file; carving has added none
    const auto whole = checkSolidity(result.mesh);
    if (!whole) return tl::unexpected(whole.error());
    result.solidity = *whole;
    result.inheritedSelfIntersections = whole->selfIntersections;
  }
  const std::vector<std::uint32_t>& partOf = model->prepared.partOfTriangle;
  result.carvedPart = partOf.empty() ? 0 : partOf[result.placement.seed];
  result.partOfTriangle =
      partsAfterCarving(model->prepared.mesh, partOf, result.mesh, result.keptTriangles, result.carvedPart);
  if (request.inlay)
    if (const Status made = addInlay(*model, request.surface, result); !made) return made;
  result.timingsMs.verify += millisecondsSince(start);
  embedded = {};
  stage = Stage::Viewing;
  return {};
}

void EngraveJob::State::view() {
  const auto start = Clock::now();
  ReaderViewOptions options;
  const int modulesAcross = symbol.size + 2 * kPictureMarginModules;
  const int pixels = std::clamp(kMostPixels / modulesAcross, kLeastPixelsPerModule, kBakedPixels);
  options.extentMm = result.placement.moduleMm * modulesAcross;
  options.texels = pixels * modulesAcross;
  options.reliefMm = static_cast<float>(summarise(result.depths).maxMm);
  options.radiusMm = static_cast<float>(kViewReachPerDepth) * options.reliefMm;
  options.albedo = request.albedo;
  options.lights = request.lamps();
  result.readerView = photographed(meshLuminance(result.mesh, result.placement.frame,
                                                 {.pixels = options.texels,
                                                  .pixelMm = result.placement.moduleMm / pixels,
                                                  .nearMm = kPictureMarginModules * result.placement.moduleMm,
                                                  .albedo = static_cast<double>(request.albedo),
                                                  .lamps = options.lights,
                                                  .lampRadiusDeg = kOneLightRadiusDeg}),
                                   options);
  result.readerOptions = options;
  result.readerView.pixelsPerModule = pixels;
  result.timingsMs.verify += millisecondsSince(start);
  stage = Stage::Done;
}

EngraveJob::EngraveJob(std::unique_ptr<State> state) : state_(std::move(state)) {}
EngraveJob::~EngraveJob() = default;

Result<std::unique_ptr<EngraveJob>> EngraveJob::create(std::shared_ptr<const EngravableModel> model,
                                                       EngraveRequest request) {
  return create(std::move(model), std::move(request), {});
}

Result<std::unique_ptr<EngraveJob>> EngraveJob::create(std::shared_ptr<const EngravableModel> model,
                                                       EngraveRequest request, const Known& known) {
  if (const Status checked = checkSettings(request); !checked) return tl::unexpected(checked.error());
  auto symbol = known.symbol ? Result<Symbol>(*known.symbol) : encodeSymbol(request.text, request.symbol);
  if (!symbol) return tl::unexpected(symbol.error());
  if (const Status good = checkEngraving(*model, request, *symbol); !good) return tl::unexpected(good.error());
  std::shared_ptr<const GeometryPass> pass = known.pass;
  if (!pass) {
    auto made = GeometryPass::create();
    if (!made) return tl::unexpected(made.error());
    pass = std::make_shared<const GeometryPass>(std::move(*made));
  }
  std::shared_ptr<const LuminancePrograms> programs = known.programs;
  if (!programs) {
    auto compiled = LuminancePrograms::create();
    if (!compiled) return tl::unexpected(compiled.error());
    programs = std::move(*compiled);
  }

  auto state = std::make_unique<State>();
  state->model = std::move(model);
  state->request = std::move(request);
  state->pass = std::move(pass);
  state->programs = std::move(programs);
  state->symbol = std::move(*symbol);
  state->layout = {state->symbol.size};
  state->measured = known.measured;
  state->lightBy = known.lightBy;
  state->makeOwnSearch = known.makeSearch;
  assert(!state->makeOwnSearch || !state->request.isForPrint());
  if (known.placed)
    state->take(*known.placed);
  else
    state->placing.emplace(state->model->prepared, state->model->gpu, *state->pass, state->symbol.size,
                           searchedPlacement(state->request, state->symbol.size));
  return std::unique_ptr<EngraveJob>(new EngraveJob(std::move(state)));
}

Progress EngraveJob::progress() const { return state_->progress(); }

Result<Progress> EngraveJob::advance() {
  using Stage = State::Stage;
  State& s = *state_;
  Status done;
  switch (s.stage) {
    case Stage::Placing:
      done = s.place();
      break;
    case Stage::Mapping:
      done = s.map();
      break;
    case Stage::Searching:
      done = s.searchOnce();
      break;
    case Stage::Embedding:
      done = s.embed();
      break;
    case Stage::Printing:
      done = s.print();
      break;
    case Stage::Writing:
      done = s.write();
      break;
    case Stage::Checking:
      done = s.check();
      break;
    case Stage::Viewing:
      s.view();
      break;
    case Stage::Done:
      assert(false && "advance() after done");
      break;
  }
  if (!done) return tl::unexpected(done.error());
  return s.progress();
}

EngraveResult EngraveJob::takeResult() {
  assert(state_->stage == State::Stage::Done);
  return std::move(state_->result);
}

const EngraveResult* EngraveJob::writtenResult() const {
  using Stage = State::Stage;
  const bool isWritten = state_->stage == Stage::Checking || state_->stage == Stage::Viewing;
  return isWritten ? &state_->result : nullptr;
}

InspectorMaps EngraveJob::inspectorMaps() const {
  InspectorMaps maps;
  if (!state_->isMeasured) return maps;
  const MeasuredPlace& measured = *state_->measured;
  maps.luminance = &measured.light().luminanceTexture();
  maps.depths = &measured.light().depthTexture();
  maps.symbol = &state_->symbol;
  maps.search = &state_->result.search;
  return maps;
}

const SurfaceMaps* EngraveJob::surfaceMaps() const { return state_->isMeasured ? state_->measured->maps() : nullptr; }

std::shared_ptr<MeasuredPlace> EngraveJob::measuredPlace() const {
  return state_->isMeasured ? state_->measured : nullptr;
}

Result<EngraveResult> engrave(std::shared_ptr<const EngravableModel> model, const EngraveRequest& request) {
  auto job = EngraveJob::create(std::move(model), request);
  if (!job) return tl::unexpected(job.error());
  return runToEnd(**job);
}

}  // namespace qrelief
