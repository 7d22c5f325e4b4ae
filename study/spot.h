// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pipeline/engrave.h"

namespace qrelief::study {

/// Greatest depth of the methods of others, in modules: none of their sources names one, and walls limit pockets
/// before. `limited` of CarvedCode counts the submodules that stop at it or at a wall.
inline constexpr double kPublishedMaxDepthModules = 10;

/// Width of the study's modules, unless a table says otherwise.
inline constexpr double kUsualModuleMm = 1;

/// Where a symbol is to be carved, with all that is known before any depth: what every method begins with.
struct Spot {
  std::string name;  ///< of the model
  std::shared_ptr<const EngravableModel> model;
  EngraveRequest request;  ///< text, size, direction, material; a method may take more of it
  Placement placement;
  Symbol symbol;
  std::shared_ptr<const GeometryPass> pass;
  std::shared_ptr<const PlacementSearch> search;  ///< that found the place

  /// Measured by the last carving of carveByEngine(), for the next one.
  mutable std::shared_ptr<MeasuredPlace> measured = {};

  double submoduleMm() const { return placement.moduleMm / kSubmodulesPerModule; }

  /// Greatest depths that leave the walls asked for, mm, see wallLimits().
  /// @param maxDepthMm  no submodule is carved deeper, ≥ 0
  std::vector<double> limitsMm(const SubmoduleMask& mask, double maxDepthMm) const;
};

/// Finds the request's place. Needs a GL context.
Result<Spot> findSpot(std::string name, std::shared_ptr<const EngravableModel> model, const EngraveRequest& request);

}  // namespace qrelief::study
