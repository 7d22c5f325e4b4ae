// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "carving/depth_solver.h"
#include "settings/engrave_request.h"

namespace qrelief {

/// The search for depths that a request asks for by its objective, its floor and its solver.
/// @param request           checked (checkSettings)
/// @param contrastOfModule  what the print asks of each module (contrast_for_print.h), for ContrastSolver::Fast; empty:
///                          the request's contrast of all; then a request for the print gets a search that ends where
///                          it is good enough to find that out
/// @param before            the search that the print was of
std::unique_ptr<DepthSolver> makeDepthSolver(const EngraveRequest& request, CarvingTarget target,
                                             std::vector<double> contrastOfModule = {},
                                             const DepthSolver* before = nullptr);

}  // namespace qrelief
