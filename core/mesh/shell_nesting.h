// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/orient.h"

namespace qrelief {

/// Which shells lie in which.
struct ShellNesting {
  std::vector<std::vector<std::uint32_t>> enclosing;  ///< for each shell the shells that enclose it, ascending
  bool known = true;                                  ///< false: there was too much to look at, all lists are empty
};

/// Finds the shells that enclose each shell. Only closed shells enclose and are enclosed.
///
/// By the parity of a vertical ray's crossings, from three points of the inner shell (the majority decides); a ray
/// through an edge counts for exactly one side. Cost: O(S² + T log S) as a rule; where
/// more than 4000 shells are closed or points and triangles make too many pairs, nothing is known.
/// @param closed      for each shell
/// @param maxCrossings  pairs of a point and a triangle that are looked at
ShellNesting enclosingShells(const Mesh& mesh, const Shells& shells, const std::vector<char>& closed,
                             std::size_t maxCrossings = 200'000'000);

}  // namespace qrelief
