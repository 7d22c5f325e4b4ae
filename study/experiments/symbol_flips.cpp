// SPDX-License-Identifier: GPL-3.0-or-later
// Dark areas broken up within the error correction: not at all, as in Peng 2019, and as in our method, for the search
// of 2019 and for ours. Whole modules, level H, version 3.
#include <algorithm>

#include "study/experiments/experiments.h"
#include "study/methods/break_up.h"
#include "study/methods/by_engine.h"
#include "study/methods/methods.h"
#include "study/methods/self_shadow_2019.h"
#include "study/methods/symbol_flips_2019.h"

namespace qrelief::study {
namespace {

Result<CarvedCode> carve(const StudyPlacement& spot, const std::string& flips, const std::string& search) {
  EngraveRequest request = spot.request;
  request.code.symbol.errorCorrection = ErrorCorrection::H;
  auto symbol = encodeSymbol(request.code.text, request.code.symbol);
  QRELIEF_TRY(symbol);
  if (flips == "peng-2019") flipModules2019(*symbol);
  if (flips == "ours") breakUpDarkAreas(*symbol);
  const SubmoduleMask mask = submodulesToCarve(*symbol, ModulePattern::None, FinderPattern::None);
  if (search == "self-shadow-2019") return carveSelfShadow2019(spot, *symbol, mask, {});
  request.code.modulePattern = ModulePattern::None;
  request.code.finderPattern = FinderPattern::None;
  return carveByEngine(spot, request, &*symbol);
}

Result<Row> measure(const Row& key, StudyContext& context) {
  const auto spot = context.usualSpot(key[0]);
  QRELIEF_TRY(spot);
  const auto code = carve(**spot, key[2], key[1]);
  QRELIEF_TRY(code);
  const auto judged = context.judge(**spot, *code);
  QRELIEF_TRY(judged);
  Row row = {std::to_string(std::count(code->symbol.flipped.begin(), code->symbol.flipped.end(), 1))};
  for (std::string& value : readingRow(*judged)) row.push_back(std::move(value));
  return row;
}

}  // namespace

Experiment symbolFlips() {
  Row measures = readingColumns();
  measures.insert(measures.begin(), "flipped_modules");
  Experiment experiment{
      "symbol_flips", {"model", "search", "flips"},
      measures,       {},
      measure,        dependingOn({kSearch, findMethod("self-shadow-2019")->search, kLight, kPrint, kDecoding})};
  for (const char* model : {"plate", "cylinder", "bumpy-sphere"})
    for (const char* search : {"self-shadow-2019", "ours"})
      for (const char* flips : {"none", "peng-2019", "ours"}) experiment.cases.push_back({model, search, flips});
  return experiment;
}

}  // namespace qrelief::study
