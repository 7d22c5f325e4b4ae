// SPDX-License-Identifier: GPL-3.0-or-later
// Implements the last stages of CarveJob (engrave.h): file, checks and picture of the result.
#include <algorithm>
#include <span>

#include "base/clock.h"
#include "mesh/topology.h"
#include "mesh/weld.h"
#include "message_codes/place.h"
#include "pipeline/add_inlay.h"
#include "pipeline/engrave_state.h"
#include "pipeline/spot_concerns.h"
#include "pipeline/verify.h"
#include "verification/ink.h"
#include "verification/mesh_luminance.h"
#include "verification/reading_sweep.h"

namespace qrelief {
namespace {

/// Size of the picture for the decoder, in pixels: at most along its edge, for large symbols, and at least along a
/// module's edge.
constexpr int kMostPixels = 1200, kLeastPixelsPerModule = 5;
constexpr double kViewReachPerDepth = 4;  // at four times its height away a wall hides 1.5 % of the sky
constexpr double kFlatReliefMm = 0.1;     // where nothing is lowered; shaders divide by it

/// Refuses defects that carving has added. Crossings count only if the model had none, because facets that crossed
/// before may have been cut.
Status checkNewDefects(SolidityReport solidity, const PreparedModel& before) {
  if (before.crossesItself) solidity.selfIntersections = 0;
  if (solidity.solid()) return {};
  return fail(ErrorKind::NoSolution, message<"carved-not-solid">(with::cause<"problem">(solidity.problems().front())));
}

/// Returns the facets whose crossings are counted: those that carving has made and those of the model that crossed
/// others. Empty, meaning all facets, if the model's crossings are not all known.
std::vector<std::uint32_t> suspectsOf(const EmbedResult& embedded, std::span<const FacetOrigin> origins,
                                      const PreparedModel& before) {
  if (!before.crossesItself) return embedded.newTriangles;
  if (!before.crossings) return {};
  std::vector<std::uint32_t> suspects = embedded.newTriangles;
  const auto kept = origins.first(embedded.keptTriangles);  // ascending by their facet
  for (const TrianglePair& pair : *before.crossings)
    for (const std::uint32_t facet : pair) {
      const auto at = std::lower_bound(kept.begin(), kept.end(), facet,
                                       [](const FacetOrigin& origin, std::uint32_t f) { return origin.facet < f; });
      if (at != kept.end() && at->facet == facet) suspects.push_back(static_cast<std::uint32_t>(at - kept.begin()));
    }
  std::sort(suspects.begin(), suspects.end());
  suspects.erase(std::unique(suspects.begin(), suspects.end()), suspects.end());
  return suspects;
}

}  // namespace

/// Makes the result: the mesh as a slicer reads its file, which holds positions bit for bit.
Result<StageStep> CarveJob::State::weld() {
  const auto start = Clock::now();
  result.mesh = weldedByPiece(embedded.mesh);
  result.origins = std::move(embedded.origins);
  result.bodies = model->prepared.bodies;
  result.carvedBody = model->prepared.mesh.body(result.placement.seed);
  result.coversColours = coversColours(model->prepared, result.placement,
                                       result.placement.symbolMm * roomFactor(symbol.size, request.placement));
  result.symbol = symbol;
  result.request = request;
  result.painted = std::move(embedded.painted);
  result.timingsMs.verify += millisecondsSince(start);
  return kStageDone;
}

Result<StageStep> CarveJob::State::check() {
  const auto start = Clock::now();
  const auto solidity = checkSolidity(result.mesh, suspectsOf(embedded, result.origins, model->prepared));
  QRELIEF_TRY(solidity);
  result.solidity = *solidity;
  QRELIEF_TRY(checkNewDefects(result.solidity, model->prepared));
  if (model->prepared.crossesItself) result.inheritedSelfIntersections = result.solidity.selfIntersections;
  if (request.marking.mark == Mark::Inlay) QRELIEF_TRY(setInlay(embedded.inlay, result));
  result.timingsMs.verify += millisecondsSince(start);
  embedded = {};
  return kStageDone;
}

Result<StageStep> CarveJob::State::view() {
  const auto start = Clock::now();
  const Placement& placement = result.placement;
  ReaderViewOptions options;
  const int modulesAcross = symbol.size + 2 * kPictureMarginModules;
  const int pixels = std::clamp(kMostPixels / modulesAcross, kLeastPixelsPerModule, kBakedPixels);
  options.extentMm = placement.moduleMm * modulesAcross;
  options.texels = pixels * modulesAcross;
  options.reliefMm = static_cast<float>(request.marking.isInColour() ? kFlatReliefMm : summarise(result.depths).maxMm);
  options.radiusMm = static_cast<float>(kViewReachPerDepth) * options.reliefMm;
  options.albedo = request.surfaceAlbedo();
  options.lights = request.lamps();
  // A body with its inlay has the surface of the model.
  BottomUp<float> luminance =
      meshLuminance(request.marking.mark == Mark::Inlay ? model->prepared.mesh : result.mesh, placement.frame,
                    {.pixels = options.texels,
                     .pixelMm = placement.moduleMm / pixels,
                     .nearMm = kPictureMarginModules * placement.moduleMm,
                     .albedo = static_cast<double>(options.albedo),
                     .lamps = options.lights,
                     .lampRadiusDeg = kLampRadiusDeg});
  if (request.marking.isInColour()) {
    InkMap(markedSymbol(result), placement.symbolMm, request.marking.ink).apply(luminance, placement.moduleMm / pixels);
    result.luminance = submoduleMeans(luminance, symbol.size, pixels);
  }
  result.readerView = photographed(std::move(luminance), options);
  result.readerOptions = options;
  result.readerView.pixelsPerModule = pixels;
  result.timingsMs.verify += millisecondsSince(start);
  return kStageDone;
}

}  // namespace qrelief
