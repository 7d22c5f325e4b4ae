// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/code_input.h"

#include <utility>

#include "pipeline/engravable_model.h"
#include "pipeline/requested_symbol.h"

namespace qrelief {

CodeInput::CodeInput() : symbol_(requestedSymbol(settings_.code)) {}

void CodeInput::configure(EngraveRequest settings, bool hasUp) {
  settings_ = std::move(settings);
  hasUp_ = hasUp;
  symbol_ = requestedSymbol(settings_.code);
}

void CodeInput::choose(std::optional<Vec3> centreMm, std::optional<Vec3> direction) {
  centreMm_ = centreMm;
  direction_ = direction;
}

EngraveRequest CodeInput::request(Vec3 sceneUp) const {
  EngraveRequest request = requestAt(*centreMm_, sceneUp);
  if (direction_) request.placement.direction = direction_;
  return request;
}

EngraveRequest CodeInput::requestAt(Vec3 centreMm, Vec3 sceneUp) const {
  EngraveRequest request = settings_;
  request.placement.centreMm = centreMm;
  request.placement.upHint = upHint(sceneUp);
  request.print.buildUp = buildDirection(sceneUp);
  return request;
}

BuildDirection CodeInput::buildDirection(Vec3 sceneUp) const {
  BuildDirection build = settings_.print.buildUp;
  const bool isFilesUp = sceneUp == Vec3(0, 0, 1);
  if (!build.up && build.pose == BuildPose::AsModelled && !isFilesUp) build.up = sceneUp;
  return build;
}

PlacementRequest CodeInput::placementAt(Vec3 centreMm, Vec3 sceneUp) const {
  return searchedPlacement(requestAt(centreMm, sceneUp), symbol_->size);
}

}  // namespace qrelief
