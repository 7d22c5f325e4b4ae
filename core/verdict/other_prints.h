// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "pipeline/verify.h"
#include "settings/settings.h"

namespace qrelief {

/// Ways that are worth a try where a code does not read as printed, what costs least first: the model stood otherwise;
/// then other processes with finer layers, the coarsest of them first. Powder, which wants another workshop, is none.
/// @param printed  the way that was tried
std::vector<SettingChange> otherPrints(const VerifyRequest& printed);

/// @param other  one of otherPrints()
VerifyRequest printedOtherwise(VerifyRequest request, const SettingChange& other);

}  // namespace qrelief
