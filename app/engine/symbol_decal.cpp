// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/symbol_decal.h"

#include "pipeline/default_patterns.h"
#include "viewer/inked_surface.h"

namespace qrelief {

Decal symbolDecal(const Symbol& symbol, const ProjectionFrame& frame, double symbolMm, const EngraveRequest& request) {
  const EngraveRequest carved = withDefaultPatterns(request, symbolMm / symbol.size);
  const SubmoduleMask mask = request.marking.isInColour()
                                 ? submodulesToCarve(symbol, ModulePattern::None, FinderPattern::None)
                                 : submodulesToCarve(symbol, *carved.code.modulePattern, *carved.code.finderPattern);
  const int border = kSubmodulesPerModule * kQuietZoneModules;
  Decal decal;
  if (request.marking.isInColour()) decal.colours = coloursOf(request.marking.ink);
  decal.frame = frame;
  decal.size = mask.size + 2 * border;
  decal.edgeMm = symbolMm * decal.size / mask.size;
  decal.ink.assign(static_cast<std::size_t>(decal.size) * static_cast<std::size_t>(decal.size), 0);
  for (int row = 0; row < mask.size; ++row)
    for (int column = 0; column < mask.size; ++column)
      if (mask.isCarved(row, column))
        decal.ink[static_cast<std::size_t>((row + border) * decal.size + column + border)] = 255;
  return decal;
}

}  // namespace qrelief
