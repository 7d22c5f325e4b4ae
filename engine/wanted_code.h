// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "pipeline/engrave.h"

namespace qrelief {

/// The code that is asked for: the settings, their symbol, and the one place where its centre stands.
class WantedCode {
 public:
  WantedCode();

  void configure(EngraveRequest settings);
  const EngraveRequest& settings() const { return settings_; }
  const Result<Symbol>& symbol() const { return symbol_; }

  /// @param direction  that the centre needs, instead of one found from there
  void choose(std::optional<Vec3> centreMm, std::optional<Vec3> direction = {});
  const std::optional<Vec3>& centreMm() const { return centreMm_; }
  const std::optional<Vec3>& direction() const { return direction_; }  ///< that the centre needs

  /// What is engraved at the centre, which must be chosen.
  /// @param upHint  the axis that is up in the scene
  EngraveRequest request(Vec3 upHint) const;
  /// What is looked for at another one.
  PlacementRequest placementAt(Vec3 centreMm, Vec3 upHint) const;

 private:
  EngraveRequest settings_;
  Result<Symbol> symbol_;
  std::optional<Vec3> centreMm_, direction_;
};

}  // namespace qrelief
