// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "depth/depth_solver.h"
#include "depth/fast_search.h"
#include "settings/engrave_request.h"

namespace qrelief {

/// Makes the depth search for a request's objective and solver.
/// @param request  checked (checkSettings)
std::unique_ptr<DepthSolver> makeDepthSolver(const EngraveRequest& request, CarvingTarget target);

/// Makes the first of two searches for a request that is carved for its print (EngraveRequest::isForPrint). It stops
/// after a few passes. Its depths are good enough for the rough print.
std::unique_ptr<FastSearch> makeSearchBeforePrint(const EngraveRequest& request, CarvingTarget target);

/// Makes the second one.
/// @param contrastOfModule  target contrasts from the print (contrast_for_print.h)
/// @param before            the search whose depths were printed; its result is the start
std::unique_ptr<FastSearch> makeSearchAfterPrint(const EngraveRequest& request, CarvingTarget target,
                                                 std::vector<double> contrastOfModule, const FastSearch& before);

}  // namespace qrelief
