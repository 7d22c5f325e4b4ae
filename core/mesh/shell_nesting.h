// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/orient.h"

namespace qrelief {

/// For each shell the shells that enclose it, ascending. Only closed shells enclose and are enclosed.
///
/// By the parity of a vertical ray's crossings, from three points of the inner shell (the majority decides); a ray
/// through an edge counts for exactly one side. Cost: O(S² + T log S) as a rule.
/// @param closed  for each shell; where more than 4000 are closed, nothing is looked for and all lists are empty
std::vector<std::vector<std::uint32_t>> enclosingShells(const Mesh& mesh, const Shells& shells,
                                                        const std::vector<char>& closed);

}  // namespace qrelief
