// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "base/result.h"
#include "qr/symbol.h"
#include "settings/engrave_request.h"

namespace qrelief {

/// The requested code: its settings, its symbol, and its centre.
class CodeInput {
 public:
  CodeInput();

  /// @param hasUp  the settings say where the symbol's top points; otherwise it points up in the scene
  void configure(EngraveRequest settings, bool hasUp);
  const EngraveRequest& settings() const { return settings_; }
  const Result<Symbol>& symbol() const { return symbol_; }

  /// Sets the centre. @param direction  the viewing direction to use there, instead of finding one
  void choose(std::optional<Vec3> centreMm, std::optional<Vec3> direction = {});
  const std::optional<Vec3>& centreMm() const { return centreMm_; }
  const std::optional<Vec3>& direction() const { return direction_; }  ///< to use at the centre, if set

  /// Returns the direction in which the symbol's top points. @param sceneUp  the axis that is up in the scene
  Vec3 upHint(Vec3 sceneUp) const { return hasUp_ ? settings_.placement.upHint : sceneUp; }
  /// Returns the request for an engraving at the centre, which must be chosen.
  EngraveRequest request(Vec3 sceneUp) const;
  /// Returns the request for an engraving at another centre.
  EngraveRequest requestAt(Vec3 centreMm, Vec3 sceneUp) const;
  /// Returns the pose on the printer. A model as in its file stands as the scene shows it.
  BuildDirection buildDirection(Vec3 sceneUp) const;
  /// Returns the request for a placement at another centre, with room for label and pockets. The symbol must exist.
  PlacementRequest placementAt(Vec3 centreMm, Vec3 sceneUp) const;

 private:
  EngraveRequest settings_;
  bool hasUp_ = false;
  Result<Symbol> symbol_;
  std::optional<Vec3> centreMm_, direction_;
};

}  // namespace qrelief
