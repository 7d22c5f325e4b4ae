// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/placement_request.h"

#include <algorithm>
#include <array>

#include "qr/symbol.h"

namespace qrelief {
namespace {

constexpr std::array<const char*, 4> kSizeModeNames = {"best", "oriented", "free", "fixed"};

}  // namespace

const char* sizeModeName(SizeMode mode) { return kSizeModeNames[static_cast<std::size_t>(mode)]; }

double roomFactor(int modules, const PlacementRequest& request) {
  // Carving moves the pockets' outlines off the model's edges by up to an eighth of a submodule, or a hundredth of a
  // millimetre.
  constexpr double kBorderModules = 0.06;
  const double quiet = request.quietZone ? kQuietZoneModules : kBorderModules;
  return (modules + 2 * std::max(quiet, request.labelMarginModules)) / modules;
}

}  // namespace qrelief
