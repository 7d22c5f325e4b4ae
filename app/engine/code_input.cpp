// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/code_input.h"

#include <utility>

#include "pipeline/engravable_model.h"

namespace qrelief {

CodeInput::CodeInput() : symbol_(encodeSymbol(settings_.code.text, settings_.code.symbol)) {}

void CodeInput::configure(EngraveRequest settings) {
  settings_ = std::move(settings);
  symbol_ = encodeSymbol(settings_.code.text, settings_.code.symbol);
}

void CodeInput::choose(std::optional<Vec3> centreMm, std::optional<Vec3> direction) {
  centreMm_ = centreMm;
  direction_ = direction;
}

EngraveRequest CodeInput::request(Vec3 upHint) const {
  EngraveRequest request = settings_;
  request.placement = movedTo(*centreMm_, upHint);
  if (direction_) request.placement.direction = direction_;
  BuildDirection& build = request.print.buildUp;
  const bool isFilesUp = upHint == Vec3(0, 0, 1);
  if (!build.up && build.pose == BuildPose::AsModelled && !isFilesUp) build.up = upHint;  // as the user sees it
  return request;
}

PlacementRequest CodeInput::movedTo(Vec3 centreMm, Vec3 upHint) const {
  PlacementRequest request = settings_.placement;
  request.centreMm = centreMm;
  request.upHint = upHint;
  return request;
}

PlacementRequest CodeInput::placementAt(Vec3 centreMm, Vec3 upHint) const {
  EngraveRequest request = settings_;
  request.placement = movedTo(centreMm, upHint);
  return searchedPlacement(request, symbol_->size);
}

}  // namespace qrelief
