// SPDX-License-Identifier: GPL-3.0-or-later
// Decoding at one depth: the default, and the methods close to it in the frontier, for several texts, as designed and
// as printed lying with the first process. Each method carves as deep on average as the default carves the same model.
// One text alone says little: with another mask, a few more or fewer tries decode.
//
// The level for this depth is found with the first text, by interpolating the logarithm of the depth until it is within
// kAlike of the default's. The other texts use the same level.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "study/experiments/experiments.h"
#include "study/methods/methods.h"

namespace qrelief::study {
namespace {

constexpr std::array kTexts = {kText, "https://example.org/p/2", "https://example.org/q/37",
                               "https://example.org/r/581"};
constexpr const char* kDefault = "ours";
constexpr double kAlike = 0.02;
constexpr int kCorrections = 3;

/// Returns the same place with another text of the same version.
Result<StudyPlacement> spotFor(const StudyPlacement& usual, const std::string& text) {
  StudyPlacement spot = usual;
  spot.request.code.text = text;
  auto symbol = encodeSymbol(text, spot.request.code.symbol);
  QRELIEF_TRY(symbol);
  spot.symbol = std::move(*symbol);
  return spot;
}

/// Returns the mean depth of the carved submodules, mm.
Result<double> depthAt(const Method& method, const StudyPlacement& spot, double level) {
  const auto code = method.carve(spot, level);
  QRELIEF_TRY(code);
  return depthOf(*code).meanMm;
}

Result<double> levelFor(const Method& method, const StudyPlacement& spot, double depthMm) {
  struct Tried {
    double level, logDepth;
  };
  std::array<Tried, 2> tried{};
  const std::array<double, 2> first = {method.levels[1], method.levels[method.levels.size() - 2]};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto depth = depthAt(method, spot, first[i]);
    QRELIEF_TRY(depth);
    tried[i] = {first[i], std::log(*depth)};
  }
  const double logDepth = std::log(depthMm);
  for (int i = 0;; ++i) {
    const auto [a, b] = tried;
    if (a.logDepth == b.logDepth) return b.level;  // walls limit both depths
    const double level =
        std::clamp(a.level + (b.level - a.level) * (logDepth - a.logDepth) / (b.logDepth - a.logDepth), 0.02, 0.9);
    if (i == kCorrections) return level;
    const auto depth = depthAt(method, spot, level);
    QRELIEF_TRY(depth);
    if (std::abs(*depth / depthMm - 1) <= kAlike) return level;
    tried[std::abs(logDepth - a.logDepth) > std::abs(logDepth - b.logDepth) ? 0 : 1] = {level, std::log(*depth)};
  }
}

Result<Row> measure(const Row& key, StudyContext& context) {
  const Method& method = *findMethod(key[1]);
  const Method& usual = *findMethod(kDefault);
  const auto ours = context.usualSpot(key[0], usual.direction);
  QRELIEF_TRY(ours);
  const auto place = context.usualSpot(key[0], method.direction);
  QRELIEF_TRY(place);
  static std::map<std::string, double> levels;  // by model and method
  const auto [known, isNew] = levels.try_emplace(key[0] + " " + key[1], usual.usual);
  if (isNew && &method != &usual) {
    const auto depth = depthAt(usual, **ours, usual.usual);
    QRELIEF_TRY(depth);
    const auto level = levelFor(method, **place, *depth);
    if (!level) {
      levels.erase(known);
      return tl::unexpected(level.error());
    }
    known->second = *level;
  }
  const auto spot = spotFor(**place, kTexts[std::stoul(key[2]) - 1]);
  QRELIEF_TRY(spot);
  const auto code = method.carve(*spot, known->second);
  QRELIEF_TRY(code);
  const auto judged = context.judge(*spot, *code);
  QRELIEF_TRY(judged);
  Row row = readingRow(*judged);
  row.push_back(shown(known->second, 3));
  return row;
}

/// Returns the version, which includes the default's search, because that search sets the depth.
std::string version(const Row& key) { return versionOfMethod(key) + " default " + versionOf({kSearch}); }

}  // namespace

Experiment equalDepth() {
  Row measures = readingColumns();
  measures.emplace_back("level");
  Experiment experiment{"equal_depth", {"model", "method", "text"}, measures, {}, measure, version};
  for (std::size_t text = 1; text <= kTexts.size(); ++text)
    for (const std::string& model : StudyContext::models())
      for (const char* method : {kDefault, "ours-thick-plus", "ours-whole-modules", "ours-for-design", "papp-2022",
                                 "papp-2022-whole-modules", "tilted-2021", "groove-2018"})
        experiment.cases.push_back({model, method, std::to_string(text)});
  return experiment;
}

}  // namespace qrelief::study
