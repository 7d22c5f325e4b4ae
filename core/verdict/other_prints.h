// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "pipeline/verify.h"
#include "settings/settings.h"

namespace qrelief {

/// Returns other ways of printing to try if a code does not read as printed, cheapest first: other orientations of the
/// model, then other processes with finer layers, the coarsest of them first. Powder is left out, because it needs
/// another workshop.
/// @param printed  the way that was tried
std::vector<SettingChange> otherPrints(const VerifyRequest& printed);

/// Returns the request for one of these ways.
/// @param other  one of otherPrints()
VerifyRequest printedOtherwise(VerifyRequest request, const SettingChange& other);

}  // namespace qrelief
