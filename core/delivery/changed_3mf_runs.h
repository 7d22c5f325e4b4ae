// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "io/three_mf/rewrite_3mf.h"
#include "mesh/prepare.h"

namespace qrelief {

struct EngraveResult;

/// Returns the new meshes of a 3MF file's runs, which are the model's bodies: those of the carved body and of
/// bodies that repairs changed. Facets and their pieces keep their attributes, except under the code.
/// Cost: O(T).
/// @param before   model before carving, with its 3MF source
std::vector<ChangedRun> changed3mfRuns(const PreparedModel& before, const EngraveResult& result, bool withInlay);

}  // namespace qrelief
