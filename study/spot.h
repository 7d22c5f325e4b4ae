// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pipeline/engrave.h"

namespace qrelief::study {

/// Where a symbol is to be carved, with all that is known before any depth: what every method begins with.
struct Spot {
  std::string name;  ///< of the model
  std::shared_ptr<const EngravableModel> model;
  EngraveRequest request;  ///< text, size, direction, material; a method may take more of it
  Placement placement;
  Symbol symbol;
  std::shared_ptr<const GeometryPass> pass;
  std::shared_ptr<const PlacementSearch> search;  ///< that found the place

  double submoduleMm() const { return placement.moduleMm / kSubmodulesPerModule; }

  /// Greatest depths that leave the walls asked for, mm, see wallLimits().
  /// @param maxDepthMm  no submodule is carved deeper, ≥ 0
  std::vector<double> limitsMm(const SubmoduleMask& mask, double maxDepthMm) const;
};

/// Finds the request's place. Needs a GL context.
Result<Spot> findSpot(std::string name, std::shared_ptr<const EngravableModel> model, const EngraveRequest& request);

}  // namespace qrelief::study
