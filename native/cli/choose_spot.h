// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <memory>

#include "base/result.h"
#include "math/vec.h"

namespace qrelief {

struct EngravableModel;
struct EngraveRequest;

/// Prints the position of a spot in the file's units.
void printSpot(Vec3 centreMm, double scaleToMm, std::FILE* to);

/// Completes a request without a centre: sets the best spot for the requested size, or the spot with the largest size,
/// and prints its position.
/// @param scaleToMm  of the file; the position is printed in the file's units
/// @param to         stream to print to
Status chooseSpot(std::shared_ptr<const EngravableModel> model, EngraveRequest& request, double scaleToMm, bool quiet,
                  std::FILE* to);

}  // namespace qrelief
