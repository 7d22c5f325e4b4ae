// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "depth/depth_solver.h"
#include "inspector/value_map.h"
#include "qr/symbol.h"

namespace qrelief {

/// Position of a submodule, counted from the symbol's top left; negative in the quiet zone.
struct SubmodulePlace {
  int row = 0, column = 0;
  bool operator==(const SubmodulePlace&) const = default;
};

/// Returns "data", "finder", …
const char* moduleRoleName(ModuleRole role);

/// The search's data on a submodule at one pass, in the paper's terms [Papp 2022, §7].
struct SubmoduleFacts {
  SubmodulePlace place;
  ModuleRole role = ModuleRole::Data;
  bool inSymbol = false;  ///< false: in the quiet zone
  bool dark = false;      ///< true: its module is dark
  bool carved = false;
  float luminance = 0;  ///< LS
  /// For a dark module: AL, the mean of the four darkest light modules around it, and G = AL·(c − 1) + LS, by which it
  /// is too bright.
  std::optional<float> around, excess;
  std::optional<float> depthMm, limitMm;  ///< if it is carved
};

/// One point of the convergence curves.
struct PassSummary {
  float meanDepthMm = 0, maxDepthMm = 0;
  int unmet = 0;             ///< carved submodules with G > 0
  float greatestExcess = 0;  ///< G of the brightest of them; 0 if there is none
  float changeMm = 0;        ///< greatest change of a depth since the pass before; of the first, its greatest depth
  double ms = 0;
};

/// A recorded search, to inspect pass by pass.
class SearchView {
 public:
  /// @param record    has at least one pass; copied
  /// @param contrast  c, 0 … 1: contrast that G refers to; it may differ from the search's own
  SearchView(const Symbol& symbol, SearchRecord record, double contrast);

  int passes() const { return static_cast<int>(record_.passes.size()); }
  int carvedCount() const { return static_cast<int>(record_.carved.size()); }
  const std::vector<PassSummary>& summaries() const { return summaries_; }

  // Maps with one value per submodule of symbol and quiet zone.
  ValueMap depths(int pass) const;
  ValueMap luminance(int pass) const;
  ValueMap excess(int pass) const;  ///< G, of the carved ones
  ValueMap limits() const;

  const std::vector<float>& carvedDepths(int pass) const { return passAt(pass).depthMm; }
  const std::vector<float>& carvedLuminance(int pass) const { return passAt(pass).luminance; }
  /// Returns the luminance of the light modules' submodules, quiet zone included: the same in every pass.
  const std::vector<float>& lightLuminance() const { return lightLuminance_; }

  /// @returns none outside the quiet zone
  std::optional<SubmoduleFacts> facts(int pass, SubmodulePlace place) const;
  /// Returns the submodule at a position in a map, (0, 0) = upper left of the quiet zone, (1, 1) = lower right.
  std::optional<SubmodulePlace> placeAt(Vec2 mapPlace) const;
  /// Returns the number of submodules along the edge of symbol and quiet zone.
  int edge() const { return edge_; }

 private:
  const SearchRecord::Pass& passAt(int pass) const { return record_.passes[static_cast<std::size_t>(pass)]; }
  ValueMap mapOf(std::span<const float> ofCarved) const;
  std::size_t inMap(std::uint32_t submodule) const;
  void summarise();

  Symbol symbol_;
  SearchRecord record_;
  double contrast_;
  int edge_ = 0;
  std::vector<float> around_;     // AL of every dark module, row-major in the symbol
  std::vector<float> threshold_;  // AL·(1 − c) of every carved submodule
  std::vector<float> lightLuminance_;
  std::vector<PassSummary> summaries_;
};

}  // namespace qrelief
