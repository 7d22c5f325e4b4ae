// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/symbol_decal.h"

#include <algorithm>
#include <cmath>

#include "depth/depth_solver.h"
#include "label/ring_coverage.h"
#include "pipeline/default_patterns.h"
#include "settings/engrave_request.h"
#include "viewer/inked_surface.h"

namespace qrelief {
namespace {

constexpr int kTexelsWithLabel = 2;  // along a submodule's edge: letters are finer than submodules
constexpr int kTexelsWithText = 4;   // the same for a text alone
constexpr double kTextMargin = 1;    // round a text alone, in modules

SubmoduleMask maskOf(const Symbol& symbol, double symbolMm, const EngraveRequest& request) {
  if (!request.needsLight()) return submodulesToCarve(symbol, ModulePattern::None, FinderPattern::None);
  const EngraveRequest carved = withDefaultPatterns(request, symbolMm / symbol.size);
  return submodulesToCarve(symbol, carved.code.modules(), *carved.code.finderPattern);
}

}  // namespace

Decal symbolDecal(const Symbol& symbol, const ProjectionFrame& frame, double symbolMm, const EngraveRequest& request) {
  const SubmoduleMask mask = maskOf(symbol, symbolMm, request);
  const LabelOptions label = request.code.lettering();
  const int scale = label.isAlone ? kTexelsWithText : label.empty() ? 1 : kTexelsWithLabel;
  const double margin =
      label.isAlone ? kTextMargin : std::max<double>(kQuietZoneModules, labelMarginModules(label, symbol.size));
  const int border = static_cast<int>(std::ceil(margin * scale * kSubmodulesPerModule));
  Decal decal;
  if (request.marking.isInColour()) decal.colours = coloursOf(request.marking.ink());
  decal.frame = frame;
  decal.size = scale * mask.rows() + 2 * border;
  const double edgeModules = static_cast<double>(decal.size) / (scale * kSubmodulesPerModule);
  decal.edgeMm = symbolMm * edgeModules / symbol.size;
  const auto layout = layOutLabel(label, symbol.size);
  decal.ink = ringCoverage(layout ? layout->rings : std::vector<Ring>(), decal.size, edgeModules);
  for (int row = 0; row < scale * mask.rows(); ++row)
    for (int column = 0; column < scale * mask.rows(); ++column)
      if (mask.at(row / scale, column / scale)) decal.ink[(row + border) * decal.size + column + border] = 255;
  return decal;
}

/// Power of the light on a pocket's whole floor. kShadowPower holds for each of its points, of which those at the walls
/// are the darkest; with 1.9 the mean of carved pockets is the same on samples (e2e/placing.spec.js).
constexpr double kFloorPower = 1.9;

void showSearch(Decal& decal, const Symbol& symbol, double symbolMm, const SearchRecord& search) {
  const int edge = kSubmodulesPerModule * symbol.size;
  const int scale = static_cast<int>(std::lround(decal.size * symbolMm / decal.edgeMm / edge));
  const int border = (decal.size - scale * edge) / 2;
  const std::vector<float>& luminance = search.passes.back().luminance;
  decal.colours = {SurfaceColours{}.body, Vec3f(0)};
  decal.inkUnderLamps = decal.ink;
  for (std::size_t k = 0; k < search.carved.size(); ++k) {
    const double light = std::clamp<double>(luminance[k], 0, 1);
    const auto byteOf = [](double shade) { return static_cast<std::uint8_t>(std::lround(255 * shade)); };
    const int row = static_cast<int>(search.carved[k]) / edge, column = static_cast<int>(search.carved[k]) % edge;
    for (int y = 0; y < scale; ++y)
      for (int x = 0; x < scale; ++x) {
        const auto texel =
            static_cast<std::size_t>((scale * row + y + border) * decal.size + scale * column + x + border);
        decal.ink[texel] = byteOf(1 - std::pow(light, kFloorPower));
        decal.inkUnderLamps[texel] = byteOf(1 - light);
      }
  }
}

}  // namespace qrelief
