// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "depth/depth_solver.h"
#include "depth/fast_search.h"

namespace qrelief {

struct EngraveRequest;

/// Makes the depth search for a request's objective and solver, on the CPU.
/// @param request  checked (checkSettings)
std::unique_ptr<DepthSolver> makeDepthSolver(const EngraveRequest& request, CarvingTarget target);

/// Returns true if FastSearch (on a GPU, ShaderSearch) serves the request's objective and solver.
bool usesFastSearch(const EngraveRequest& request);

/// Returns the search options for such a request. If the request is carved for its print (EngraveRequest::isForPrint),
/// this is the first of two searches: it stops after a few passes, because the rough print needs only approximate
/// depths.
FastSearchOptions fastSearchOptions(const EngraveRequest& request);

/// Returns the options of the second search, which begins with the first search's result.
/// @param contrastOfModule  target contrasts from the print (contrast_for_print.h)
FastSearchOptions fastSearchOptionsAfterPrint(const EngraveRequest& request, std::vector<double> contrastOfModule);

}  // namespace qrelief
