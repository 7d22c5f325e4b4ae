// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/symbol_print.h"

#include "pipeline/default_patterns.h"

namespace qrelief {

SurfacePrint symbolPrint(const Symbol& symbol, const ProjectionFrame& frame, double symbolMm,
                         const EngraveRequest& request) {
  const EngraveRequest carved = withDefaultPatterns(request, symbolMm / symbol.size);
  const SubmoduleMask mask = submodulesToCarve(symbol, *carved.modulePattern, *carved.finderPattern);
  const int border = kSubmodulesPerModule * kQuietZoneModules;
  SurfacePrint print;
  print.frame = frame;
  print.size = mask.size + 2 * border;
  print.edgeMm = symbolMm * print.size / mask.size;
  print.ink.assign(static_cast<std::size_t>(print.size) * static_cast<std::size_t>(print.size), 0);
  for (int row = 0; row < mask.size; ++row)
    for (int column = 0; column < mask.size; ++column)
      if (mask.isCarved(row, column))
        print.ink[static_cast<std::size_t>((row + border) * print.size + column + border)] = 255;
  return print;
}

}  // namespace qrelief
