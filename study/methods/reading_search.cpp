// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/methods/reading_search.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace qrelief::study {
namespace {

constexpr int kN = kSubmodulesPerModule;
constexpr double kFirstDepthModules = 0.3;

/// Convolves a map with a Gaussian; beyond the edge the map continues with its edge values.
Grid<double> blurred(const Grid<double>& map, double sigma) {
  const int edge = map.rows();
  const int reach = static_cast<int>(std::ceil(3 * sigma));
  std::vector<double> kernel;
  double sum = 0;
  for (int i = -reach; i <= reach; ++i) {
    kernel.push_back(std::exp(-0.5 * i * i / (sigma * sigma)));
    sum += kernel.back();
  }
  for (double& weight : kernel) weight /= sum;
  const auto pass = [&](const Grid<double>& from, bool alongRows) {
    Grid<double> to(edge, edge);
    for (int row = 0; row < edge; ++row) {
      for (int column = 0; column < edge; ++column) {
        double value = 0;
        for (int i = -reach; i <= reach; ++i) {
          const int r = alongRows ? row : std::clamp(row + i, 0, edge - 1);
          const int c = alongRows ? std::clamp(column + i, 0, edge - 1) : column;
          value += kernel[i + reach] * from.at(r, c);
        }
        to.at(row, column) = value;
      }
    }
    return to;
  };
  return pass(pass(map, true), false);
}

}  // namespace

ReadingSearch::ReadingSearch(CarvingTarget target, const ReadingOptions& options)
    : target_(std::move(target)), options_(options), neighbours_(*target_.symbol) {
  const Symbol& symbol = *target_.symbol;
  depths_ = {target_.mask->rows(), target_.symbolMm, std::vector<double>(target_.mask->size(), 0)};
  contrast_.assign(symbol.dark.size(), 0);
  const double moduleMm = target_.symbolMm / symbol.size;
  for (int row = 0; row < symbol.size; ++row) {
    for (int column = 0; column < symbol.size; ++column) {
      if (!symbol.isDark(row, column)) continue;
      Pocket pocket;
      pocket.module = static_cast<std::size_t>(row * symbol.size + column);
      pocket.wanted = symbol.role(row, column) == ModuleRole::Finder ? options_.finderContrast : options_.dataContrast;
      for (int k = 0; k < kN * kN; ++k) {
        const auto i = static_cast<std::size_t>((row * kN + k / kN) * depths_.size + column * kN + k % kN);
        if ((*target_.mask)[i]) pocket.limitMm = std::max(pocket.limitMm, target_.limitMm[i]);
      }
      pocket.limitMm = quantisedDepth(pocket.limitMm, pocket.limitMm);
      pocket.depthMm = quantisedDepth(kFirstDepthModules * moduleMm, pocket.limitMm);
      carve(pocket);
      pockets_.push_back(pocket);
    }
  }
}

void ReadingSearch::carve(const Pocket& pocket) {
  const int m = target_.symbol->size;
  const int row = static_cast<int>(pocket.module) / m, column = static_cast<int>(pocket.module) % m;
  for (int k = 0; k < kN * kN; ++k) {
    const auto i = static_cast<std::size_t>((row * kN + k / kN) * depths_.size + column * kN + k % kN);
    if ((*target_.mask)[i]) depths_.depthMm[i] = quantisedDepth(pocket.depthMm, target_.limitMm[i]);
  }
}

void ReadingSearch::deepen(Pocket& pocket, double contrast) {
  const double excess = contrast - pocket.wanted;
  const bool least = pocket.brightMm > 0 && pocket.depthMm - pocket.brightMm < 1.5 * kDepthQuantumMm;
  pocket.done = excess >= 0 && (excess <= options_.tolerance || least);
  pocket.limited = excess < 0 && pocket.depthMm >= pocket.limitMm;
  if (pocket.done || pocket.limited) return;
  // Neighbours move as well, so a depth that was too bright a pass ago may suffice now: the bounds come from the last
  // passes only.
  if (excess < 0) {
    pocket.brightMm = pocket.depthMm;
    if (pocket.darkMm <= pocket.brightMm) pocket.darkMm = 0;
  } else {
    pocket.darkMm = pocket.depthMm;
    if (pocket.brightMm >= pocket.darkMm) pocket.brightMm = 0;
  }
  const double aim = pocket.wanted + options_.tolerance / 2;
  const double slope =
      pocket.depthMm == pocket.lastMm ? 0 : (contrast - pocket.lastContrast) / (pocket.depthMm - pocket.lastMm);
  // Contrast grows with depth, but ever more slowly. The first step follows the chord from the surface.
  const double rise = slope > 0 ? slope : std::max(contrast, 0.02) / std::max(pocket.depthMm, 0.02);
  double next = pocket.depthMm + (aim - contrast) / rise;
  next = std::clamp(next, 0.4 * pocket.depthMm, 2.5 * pocket.depthMm);
  if (pocket.darkMm > 0 && next >= pocket.darkMm) next = (pocket.brightMm + pocket.darkMm) / 2;
  if (next <= pocket.brightMm) next = pocket.darkMm > 0 ? (pocket.brightMm + pocket.darkMm) / 2 : 1.2 * pocket.brightMm;
  pocket.lastMm = pocket.depthMm;
  pocket.lastContrast = contrast;
  pocket.depthMm = quantisedDepth(std::max(next, kDepthQuantumMm), pocket.limitMm);
}

void ReadingSearch::update(const Grid<double>& luminance) {
  const int m = target_.symbol->size;
  const int withQuiet = m + 2 * kQuietZoneModules;
  assert(luminance.rows() == kN * withQuiet);
  const Grid<double> seen = blurred(luminance, options_.blurModules * kN);
  Grid<double> modules(withQuiet, withQuiet);
  for (int row = 0; row < withQuiet; ++row)
    for (int column = 0; column < withQuiet; ++column)
      modules.at(row, column) = seen.at(row * kN + kN / 2, column * kN + kN / 2);

  bool moved = false;
  for (Pocket& pocket : pockets_) {
    const int row = static_cast<int>(pocket.module) / m + kQuietZoneModules;
    const int column = static_cast<int>(pocket.module) % m + kQuietZoneModules;
    const double around = neighbours_.darkestMean(pocket.module, modules);
    const double contrast = 1 - modules.at(row, column) / around;
    contrast_[pocket.module] = contrast;
    const double before = pocket.depthMm;
    deepen(pocket, contrast);
    moved = moved || pocket.depthMm != before;
  }
  ++passes_;
  finished_ = !moved || passes_ >= options_.maxPasses;
  if (!finished_)
    for (const Pocket& pocket : pockets_) carve(pocket);
}

double ReadingSearch::doneFraction() const {
  const auto done =
      std::count_if(pockets_.begin(), pockets_.end(), [](const Pocket& p) { return p.done || p.limited; });
  return pockets_.empty() ? 1 : static_cast<double>(done) / static_cast<double>(pockets_.size());
}

template <class Counts>
std::size_t ReadingSearch::submodulesOf(const Counts& counts) const {
  std::size_t count = 0;
  const int m = target_.symbol->size;
  for (const Pocket& pocket : pockets_) {
    if (!counts(pocket)) continue;
    const int row = static_cast<int>(pocket.module) / m, column = static_cast<int>(pocket.module) % m;
    for (int k = 0; k < kN * kN; ++k) count += target_.mask->at(row * kN + k / kN, column * kN + k % kN);
  }
  return count;
}

std::size_t ReadingSearch::limitedCount() const {
  return submodulesOf([](const Pocket& pocket) { return pocket.limited; }) + unfinishedCount();
}

std::size_t ReadingSearch::unfinishedCount() const {
  if (!finished_) return 0;
  return submodulesOf([&](const Pocket& pocket) {
    return !pocket.done && !pocket.limited && contrast_[pocket.module] < pocket.wanted;
  });
}

}  // namespace qrelief::study
