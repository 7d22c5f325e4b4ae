// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "io/rewrite_3mf.h"
#include "mesh/prepare.h"
#include "pipeline/engrave.h"

namespace qrelief {

/// Returns the new meshes of a 3MF file's runs after carving: the carved run's, and if repairs changed the model, those
/// of all runs.
///
/// Kept facets keep their attributes. Carving says nothing about where its new facets come from, so the facet that each
/// lies on is looked up among those that were cut. Cost: O(T + n log n) in n new facets.
/// @param before   has a source
/// @returns NoSolution if facets of several runs were cut
Result<std::vector<ChangedRun>> carvedRuns(const PreparedModel& before, const EngraveResult& result, bool withInlay);

}  // namespace qrelief
