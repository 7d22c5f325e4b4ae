// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/placement_request.h"

#include <array>

namespace qrelief {
namespace {

constexpr std::array<const char*, 4> kSizeModeNames = {"free", "oriented", "best", "fixed"};

}  // namespace

const char* sizeModeName(SizeMode mode) { return kSizeModeNames[static_cast<std::size_t>(mode)]; }

}  // namespace qrelief
