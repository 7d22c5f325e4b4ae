// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "mesh/topology.h"

namespace qrelief {

/// The parts of a mesh that hang together across edges of exactly two triangles.
struct Shells {
  std::vector<std::uint32_t> of;  ///< for each triangle, its shell, numbered by the lowest triangle
  std::size_t count = 0;
};

/// What makeConsistent() found and did.
struct Consistency {
  Shells shells;
  std::vector<char> wasMixed;  ///< for each shell: some of its triangles faced the other way than the rest
  std::size_t turned = 0;      ///< triangles turned round
  std::optional<std::uint32_t> turnedExample;
  std::optional<std::uint32_t> oneSided;  ///< a triangle where the surface comes back to itself turned round (Möbius)
};

/// Turns triangles so that neighbours agree; of each shell the smaller part is turned, in a tie not the part of its
/// first triangle. Cost: O(T).
/// @param adjacency  of the triangles; kept true
Consistency makeConsistent(std::vector<Triangle>& triangles, Adjacency& adjacency);

/// What orientOutwards() found and did, in shells.
struct Outwardness {
  std::size_t insideOut = 0;     ///< turned round
  std::size_t cavities = 0;      ///< closed shells inside others that face inwards
  std::size_t nestedSolids = 0;  ///< closed shells inside others that face outwards as those do; left as they are
  bool nestingKnown = true;      ///< false: there was too much to look at, every shell counts as in no other
  std::optional<std::uint32_t> insideOutExample, cavityExample, nestedExample;  ///< a triangle of each
};

/// Turns closed shells so that a shell in no other faces outwards. A shell inside others is turned if those were inside
/// out or if it was of mixed orientation; by how many it is enclosed then tells whether it bounds a cavity. A
/// consistent one is left as the file has it. Open shells are left alone.
///
/// Cost: O(T), and of enclosingShells() where there are several shells.
Outwardness orientOutwards(Mesh& mesh, Adjacency& adjacency, const Consistency& consistency);

}  // namespace qrelief
