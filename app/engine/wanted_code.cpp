// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/wanted_code.h"

#include <utility>

namespace qrelief {

WantedCode::WantedCode() : symbol_(encodeSymbol(settings_.text, settings_.symbol)) {}

void WantedCode::configure(EngraveRequest settings) {
  settings_ = std::move(settings);
  symbol_ = encodeSymbol(settings_.text, settings_.symbol);
}

void WantedCode::choose(std::optional<Vec3> centreMm, std::optional<Vec3> direction) {
  centreMm_ = centreMm;
  direction_ = direction;
}

EngraveRequest WantedCode::request(Vec3 upHint) const {
  EngraveRequest request = settings_;
  request.placement = placementAt(*centreMm_, upHint);
  if (direction_) request.placement.direction = direction_;
  BuildDirection& build = request.buildUp;
  const bool isFilesUp = upHint == Vec3(0, 0, 1);
  if (!build.up && build.pose == BuildPose::AsModelled && !isFilesUp) build.up = upHint;  // as the user sees it
  return request;
}

PlacementRequest WantedCode::placementAt(Vec3 centreMm, Vec3 upHint) const {
  PlacementRequest request = settings_.placement;
  request.centreMm = centreMm;
  request.upHint = upHint;
  return request;
}

}  // namespace qrelief
