// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "depth/depth_solver.h"
#include "settings/engrave_request.h"

namespace qrelief {

/// Makes the depth search for a request's objective, floor and solver.
/// @param request           checked (checkSettings)
/// @param contrastOfModule  target contrasts from the print (contrast_for_print.h), for ContrastSolver::Fast; empty:
///                          the request's contrast everywhere. If empty in a request that optimises for the print, the
///                          search stops after a few passes, which are good enough for the rough print
/// @param before            the search whose depths were printed
std::unique_ptr<DepthSolver> makeDepthSolver(const EngraveRequest& request, CarvingTarget target,
                                             std::vector<double> contrastOfModule = {},
                                             const DepthSolver* before = nullptr);

}  // namespace qrelief
