// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/engrave_stages.h"

#include <algorithm>

#include "message_codes/place.h"
#include "pipeline/default_patterns.h"
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

/// Returns the facets to test for crossings: the new facets, and the kept facets that already crossed others before
/// carving. Returns none, which means all facets, if some crossings of the model are unknown.
std::vector<std::uint32_t> suspectsOf(std::span<const FacetOrigin> origins, std::span<const std::uint32_t> newTriangles,
                                      const PreparedModel& before) {
  if (!before.crossings) return {};
  std::vector<std::uint32_t> suspects(newTriangles.begin(), newTriangles.end());
  const auto kept = origins.first(origins.size() - newTriangles.size());
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

CarvableSubmodules carvableSubmodules(const EngraveRequest& request, const Symbol& symbol, const Mesh& mesh,
                                      const Placement& placement, std::span<const double> thicknessMm) {
  CarvableSubmodules carvable;
  for (const bool areWallsThin : {false, true}) {
    carvable.request = withDefaultPatterns(request, placement.moduleMm, areWallsThin);
    const CodeRequest& code = carvable.request.code;
    const DepthRequest& depth = carvable.request.depth;
    carvable.mask = submodulesToCarve(symbol, code.modules(), *code.finderPattern);
    carvable.limitMm = depthLimits(mesh, placement, carvable.mask, thicknessMm, {*depth.maxDepthMm, depth.minWallMm});
    const bool hasWholeFinders = !request.code.finderPattern && code.finderPattern == FinderPattern::None;
    if (!hasWholeFinders || !wallsAreThinForWholeFinders(symbol, carvable.limitMm, placement.moduleMm)) break;
  }
  return carvable;
}

Result<SolidityReport> checkCarved(const Mesh& mesh, std::span<const FacetOrigin> origins,
                                   std::span<const std::uint32_t> newTriangles, const PreparedModel& before) {
  const auto solidity = before.crossesItself ? checkSolidity(mesh, suspectsOf(origins, newTriangles, before))
                                             : checkSolidity(mesh, newTriangles);
  QRELIEF_TRY(solidity);
  SolidityReport added = *solidity;
  if (before.crossesItself) added.selfIntersections = 0;
  if (added.solid()) return solidity;
  Message notSolid = message<"carved-not-solid">(with::cause<"problem">(added.problems().front()));
  if (newTriangles.empty()) return fail(ErrorKind::NoSolution, std::move(notSolid));
  return fail(ErrorKind::NoSolution, whyTooFine(mesh.corner(newTriangles.front(), 0), std::move(notSolid)));
}

ReaderPicture readerPicture(const Mesh& model, const EngraveResult& result) {
  const EngraveRequest& request = result.request;
  const Placement& placement = result.placement;
  ReaderPicture picture;
  ReaderViewOptions& options = picture.options;
  const int modulesAcross = result.symbol.size + 2 * kPictureMarginModules;
  const int pixels = std::clamp(kMostPixels / modulesAcross, kLeastPixelsPerModule, kBakedPixels);
  options.extentMm = placement.moduleMm * modulesAcross;
  options.texels = pixels * modulesAcross;
  options.reliefMm = static_cast<float>(request.marking.isInColour() ? kFlatReliefMm : summarise(result.depths).maxMm);
  options.radiusMm = static_cast<float>(kViewReachPerDepth) * options.reliefMm;
  options.albedo = static_cast<float>(request.marking.surfaceAlbedo());
  options.lights = request.lamps();
  // A body with its inlay has the surface of the model.
  BottomUp<float> luminance = meshLuminance(request.marking.mark == Mark::Inlay ? model : result.mesh, placement.frame,
                                            {.pixels = options.texels,
                                             .pixelMm = placement.moduleMm / pixels,
                                             .nearMm = kPictureMarginModules * placement.moduleMm,
                                             .albedo = static_cast<double>(options.albedo),
                                             .lamps = options.lights,
                                             .lampRadiusDeg = kLampRadiusDeg});
  if (request.marking.isInColour()) {
    InkMap(markedSymbol(result), placement.symbolMm, request.marking.ink())
        .apply(luminance, placement.moduleMm / pixels);
    picture.luminance = submoduleMeans(luminance, result.symbol.size, pixels);
  }
  picture.view = photographed(std::move(luminance), options);
  picture.view.pixelsPerModule = pixels;
  return picture;
}

}  // namespace qrelief
