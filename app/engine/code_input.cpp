// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/code_input.h"

#include <utility>

#include "pipeline/engravable_model.h"
#include "pipeline/requested_symbol.h"

namespace qrelief {

CodeInput::CodeInput() : symbol_(requestedSymbol(settings_.code)) {}

void CodeInput::configure(EngraveRequest settings) {
  settings_ = std::move(settings);
  symbol_ = requestedSymbol(settings_.code);
}

void CodeInput::choose(std::optional<Vec3> centreMm, std::optional<Vec3> direction) {
  centreMm_ = centreMm;
  direction_ = direction;
}

EngraveRequest CodeInput::request(Vec3 upHint) const {
  EngraveRequest request = requestAt(*centreMm_, upHint);
  if (direction_) request.placement.direction = direction_;
  return request;
}

EngraveRequest CodeInput::requestAt(Vec3 centreMm, Vec3 upHint) const {
  EngraveRequest request = settings_;
  request.placement.centreMm = centreMm;
  request.placement.upHint = upHint;
  request.print.buildUp = buildDirection(upHint);
  return request;
}

BuildDirection CodeInput::buildDirection(Vec3 upHint) const {
  BuildDirection build = settings_.print.buildUp;
  const bool isFilesUp = upHint == Vec3(0, 0, 1);
  if (!build.up && build.pose == BuildPose::AsModelled && !isFilesUp) build.up = upHint;
  return build;
}

PlacementRequest CodeInput::placementAt(Vec3 centreMm, Vec3 upHint) const {
  return searchedPlacement(requestAt(centreMm, upHint), symbol_->size);
}

}  // namespace qrelief
