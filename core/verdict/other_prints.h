// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "pipeline/verify.h"

namespace qrelief {

/// Another way of printing the same carving: what to set one setting of settings/settings.h to.
struct OtherPrint {
  std::string setting, value;

  bool operator==(const OtherPrint&) const = default;
};

/// Ways that are worth a try where a code does not read as printed, what costs least first: the model stood otherwise;
/// then other processes with finer layers, the coarsest of them first. Powder, which wants another workshop, is none.
/// @param printed  the way that was tried
std::vector<OtherPrint> otherPrints(const VerifyRequest& printed);

/// @param other  one of otherPrints()
VerifyRequest printedOtherwise(VerifyRequest request, const OtherPrint& other);

}  // namespace qrelief
