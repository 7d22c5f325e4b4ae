// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/symbol_facts.h"

#include <fmt/format.h>
#include <vector>

#include "engine/answers.h"
#include "label/label_layout.h"
#include "pipeline/default_patterns.h"
#include "pipeline/requested_symbol.h"
#include "qr/codewords.h"
#include "qr/segmentation.h"
#include "settings/engrave_request.h"

namespace qrelief {
namespace {

Json rowsOf(const Symbol& symbol) {
  Json rows = Json::array();
  for (int row = 0; row < symbol.size; ++row) {
    std::string text;
    for (int column = 0; column < symbol.size; ++column) text += symbol.isDark(row, column) ? '1' : '0';
    rows.push_back(text);
  }
  return rows;
}

/// Returns the bits for text in any mode, with its headers.
int dataBits(int version, ErrorCorrection level) {
  const BlockStructure structure = blockStructure(version, level);
  return 8 * (structure.codewords - structure.blocks * structure.checkCodewords);
}

/// Returns the number of bytes that can be added, by bisection: more bytes take more bits.
int roomIn(int version, ErrorCorrection level, bool hasEci, const std::string& text) {
  const int most = dataBits(version, level) - (hasEci ? kEciBits : 0);
  const auto fits = [&](int count) {
    const std::string longer = text + std::string(static_cast<std::size_t>(count), 'a');
    return segmentBits(segmentText(longer, version), version) <= most;
  };
  int room = 0, tooMany = most / 8 + 1;
  while (tooMany - room > 1) {
    const int middle = (room + tooMany) / 2;
    (fits(middle) ? room : tooMany) = middle;
  }
  return room;
}

bool isSize(double mm) { return mm > 0 && mm < 1000; }

/// Returns the outlines as an SVG path, in modules from the top left of the square.
std::string pathOf(const std::vector<Ring>& rings, int modules) {
  std::string path;
  for (const Ring& ring : rings) {
    char command = 'M';
    for (const Vec2 corner : ring) {
      path += fmt::format("{}{:.2f} {:.2f}", command, modules / 2.0 + corner.x, modules / 2.0 - corner.y);
      command = 'L';
    }
    path += 'Z';
  }
  return path;
}

Json describeLetters(const EngraveRequest& request, const Symbol& symbol, bool isPrinter) {
  const auto layout = layOutLabel(request.code.lettering(), symbol.size);
  return {{"size", symbol.size},
          {"path", pathOf(layout->rings, symbol.size)},
          {"capital", layout->capitalModules},
          {"leastMm", isPrinter ? Json(symbol.size * leastPrintableModuleMm(symbol, request)) : Json()}};
}

}  // namespace

std::string describeSymbol(const EngraveRequest& request) {
  const Result<Symbol> symbol = requestedSymbol(request.code);
  if (!symbol) return answer(symbol.error());
  const bool isPrinter = isSize(request.print.printer.nozzleMm) && isSize(request.print.printer.layerMm);
  if (request.code.isText())
    return textOf({{"ok", true}, {"symbol", {{"letters", describeLetters(request, *symbol, isPrinter)}}}});
  return textOf(
      {{"ok", true},
       {"symbol",
        {{"version", symbol->version},
         {"ecc", errorCorrectionName(symbol->errorCorrection)},
         {"mask", symbol->mask},
         {"size", symbol->size},
         {"rows", rowsOf(*symbol)},
         {"bytes", request.code.text.size()},
         {"room", roomIn(symbol->version, request.code.symbol.errorCorrection, symbol->hasEci, request.code.text)},
         {"leastModuleMm", isPrinter ? Json(leastPrintableModuleMm(*symbol, request)) : Json()}}}});
}

}  // namespace qrelief
