// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <memory>

#include "pipeline/engrave.h"

namespace qrelief {

/// For a request without a centre: sets the best spot for the size asked for, or the one that takes the largest, and
/// says where it is.
/// @param scaleToMm  of the file, in whose units it is said
/// @param to         whom it is said
Status chooseSpot(std::shared_ptr<const EngravableModel> model, EngraveRequest& request, double scaleToMm, bool quiet,
                  std::FILE* to);

}  // namespace qrelief
