// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "io/rewrite_3mf.h"
#include "mesh/prepare.h"
#include "pipeline/engrave.h"

namespace qrelief {

/// Returns the new meshes of a 3MF file's runs after carving: the carved run's mesh, or the meshes of all runs if
/// repairs changed the model.
///
/// Kept facets keep their attributes. Carving does not record where its new facets come from, so each is matched with
/// the cut facet that it lies on. Cost: O(T + n log n) for n new facets.
/// @param before   model before carving, with its 3MF source
/// @returns NoSolution if facets of several runs were cut
Result<std::vector<ChangedRun>> carvedRuns(const PreparedModel& before, const EngraveResult& result, bool withInlay);

}  // namespace qrelief
