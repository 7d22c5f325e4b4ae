// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspector/search_view.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "depth/light_neighbours.h"

namespace qrelief {
namespace {

constexpr int kN = kSubmodulesPerModule;
constexpr int kQuiet = kQuietZoneSubmodules;

}  // namespace

const char* moduleRoleName(ModuleRole role) {
  constexpr std::array<const char*, 7> kNames = {"data",      "finder", "separator", "timing",
                                                 "alignment", "format", "version"};
  return kNames[static_cast<std::size_t>(role)];
}

SearchView::SearchView(const Symbol& symbol, SearchRecord record, double contrast)
    : symbol_(symbol), record_(std::move(record)), contrast_(contrast), edge_(kN * symbol.size + 2 * kQuiet) {
  assert(!record_.passes.empty());
  const Grid<double> modules = moduleMeans(Grid<double>(record_.luminance));
  const LightNeighbours neighbours(symbol_);
  around_.assign(symbol_.dark.size(), ValueMap::kNothing);
  for (std::size_t module = 0; module < symbol_.dark.size(); ++module)
    if (symbol_.dark[module]) around_[module] = static_cast<float>(neighbours.darkestMean(module, modules));
  const int size = kN * symbol_.size;
  for (const std::uint32_t i : record_.carved) {
    const int row = static_cast<int>(i) / size, column = static_cast<int>(i) % size;
    const float around = around_[row / kN * symbol_.size + column / kN];
    threshold_.push_back(around * static_cast<float>(1 - contrast_));
  }
  for (int row = 0; row < edge_; ++row) {
    for (int column = 0; column < edge_; ++column) {
      const int r = row - kQuiet, c = column - kQuiet;
      const bool inside = r >= 0 && c >= 0 && r < size && c < size;
      if (!inside || !symbol_.isDark(r / kN, c / kN)) lightLuminance_.push_back(record_.luminance.at(row, column));
    }
  }
  summarise();
}

void SearchView::summarise() {
  const SearchRecord::Pass* before = nullptr;
  for (const SearchRecord::Pass& pass : record_.passes) {
    PassSummary summary;
    summary.ms = pass.ms;
    double sum = 0;
    for (std::size_t k = 0; k < pass.depthMm.size(); ++k) {
      sum += pass.depthMm[k];
      summary.maxDepthMm = std::max(summary.maxDepthMm, pass.depthMm[k]);
      summary.changeMm = std::max(summary.changeMm, std::abs(pass.depthMm[k] - (before ? before->depthMm[k] : 0)));
      const float excess = pass.luminance[k] - threshold_[k];
      summary.unmet += excess > 0;
      summary.greatestExcess = std::max(summary.greatestExcess, excess);
    }
    if (!pass.depthMm.empty()) summary.meanDepthMm = static_cast<float>(sum / static_cast<double>(pass.depthMm.size()));
    summaries_.push_back(summary);
    before = &pass;
  }
}

std::size_t SearchView::inMap(std::uint32_t submodule) const {
  const auto size = static_cast<std::uint32_t>(kN * symbol_.size);
  return static_cast<std::size_t>(submodule / size + kQuiet) * static_cast<std::size_t>(edge_) + submodule % size +
         kQuiet;
}

ValueMap SearchView::mapOf(std::span<const float> ofCarved) const {
  ValueMap map{edge_, edge_, std::vector<float>(record_.luminance.size(), ValueMap::kNothing), {}};
  for (std::size_t k = 0; k < record_.carved.size(); ++k) map.values[inMap(record_.carved[k])] = ofCarved[k];
  return map;
}

ValueMap SearchView::depths(int pass) const { return mapOf(passAt(pass).depthMm); }

ValueMap SearchView::limits() const { return mapOf(record_.limitMm); }

ValueMap SearchView::excess(int pass) const {
  std::vector<float> excess = passAt(pass).luminance;
  for (std::size_t k = 0; k < excess.size(); ++k) excess[k] -= threshold_[k];
  return mapOf(excess);
}

ValueMap SearchView::luminance(int pass) const {
  ValueMap map{edge_, edge_, record_.luminance.values(), {}};
  for (std::size_t k = 0; k < record_.carved.size(); ++k)
    map.values[inMap(record_.carved[k])] = passAt(pass).luminance[k];
  return map;
}

std::optional<SubmoduleFacts> SearchView::facts(int pass, SubmodulePlace place) const {
  const int size = kN * symbol_.size, row = place.row + kQuiet, column = place.column + kQuiet;
  if (row < 0 || column < 0 || row >= edge_ || column >= edge_) return {};
  SubmoduleFacts facts;
  facts.place = place;
  facts.luminance = record_.luminance.at(row, column);
  facts.inSymbol = place.row >= 0 && place.column >= 0 && place.row < size && place.column < size;
  if (!facts.inSymbol) return facts;
  const int moduleRow = place.row / kN, moduleColumn = place.column / kN;
  facts.role = symbol_.role(moduleRow, moduleColumn);
  facts.dark = symbol_.isDark(moduleRow, moduleColumn);
  const auto index = static_cast<std::uint32_t>(place.row * size + place.column);
  const auto it = std::lower_bound(record_.carved.begin(), record_.carved.end(), index);
  facts.carved = it != record_.carved.end() && *it == index;
  if (facts.carved) {
    const auto k = static_cast<std::size_t>(it - record_.carved.begin());
    facts.luminance = passAt(pass).luminance[k];
    facts.depthMm = passAt(pass).depthMm[k];
    facts.limitMm = record_.limitMm[k];
  }
  if (facts.dark) {
    facts.around = around_[moduleRow * symbol_.size + moduleColumn];
    facts.excess = facts.luminance - *facts.around * static_cast<float>(1 - contrast_);
  }
  return facts;
}

std::optional<SubmodulePlace> SearchView::placeAt(Vec2 mapPlace) const {
  if (!(mapPlace.x >= 0 && mapPlace.x < 1 && mapPlace.y >= 0 && mapPlace.y < 1)) return {};
  return SubmodulePlace{static_cast<int>(mapPlace.y * edge_) - kQuiet, static_cast<int>(mapPlace.x * edge_) - kQuiet};
}

}  // namespace qrelief
