// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pipeline/engrave.h"

namespace qrelief::study {

/// Greatest depth for the methods of others, in modules. None of their sources gives one, and walls limit pockets
/// earlier. `limited` of CarvedCode counts the submodules that stop at it or at a wall.
inline constexpr double kPublishedMaxDepthModules = 10;

/// Width of the study's modules, unless a table says otherwise.
inline constexpr double kUsualModuleMm = 1;

/// A place for a symbol, with everything that is known before any depth: the input of every method.
struct StudyPlacement {
  std::string name;  ///< of the model
  std::shared_ptr<const EngravableModel> model;
  EngraveRequest request;  ///< text, size, direction, material; a method may use more of it
  Placement placement;
  Symbol symbol;
  std::shared_ptr<const GeometryPass> pass;

  /// Measurements from the last carving by carveByEngine(), for the next one.
  mutable std::shared_ptr<PlacementMeasurement> measured = {};

  double submoduleMm() const { return placement.moduleMm / kSubmodulesPerModule; }

  /// Returns the greatest depths that leave the requested walls, mm, see wallLimits().
  /// @param maxDepthMm  limit for every submodule, ≥ 0
  std::vector<double> limitsMm(const SubmoduleMask& mask, double maxDepthMm) const;
};

/// Finds the place for a request. Needs a GL context.
Result<StudyPlacement> findSpot(std::string name, std::shared_ptr<const EngravableModel> model,
                                const EngraveRequest& request);

}  // namespace qrelief::study
