// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/orient.h"

namespace qrelief {

/// Result of enclosingShells().
struct ShellNesting {
  std::vector<std::vector<std::uint32_t>> enclosing;  ///< shell → shells around it, ascending
  bool known = true;                                  ///< false: nesting was too costly to find; all lists are empty
};

/// Finds the shells that enclose each shell. Only closed shells enclose or are enclosed.
///
/// Counts the crossings of a vertical ray from three points of the inner shell; the majority of odd and even decides. A
/// ray through an edge crosses exactly one side. Gives up (`known` is false) with more than 4000 closed shells or too
/// many pairs of points and triangles. Cost: usually O(S² + T log S).
/// @param closed        shell → true if closed
/// @param maxCrossings  limit of pairs of a point and a triangle to examine
ShellNesting enclosingShells(const Mesh& mesh, const Shells& shells, const std::vector<char>& closed,
                             std::size_t maxCrossings = 200'000'000);

}  // namespace qrelief
