// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mesh/topology.h"

namespace qrelief {

/// The connected parts of a mesh; only edges with exactly two triangles connect.
struct Shells {
  std::vector<std::uint32_t> of;  ///< triangle → shell; shells are numbered in the order of their lowest triangle
  std::size_t count = 0;
};

/// Report of makeConsistent().
struct Consistency {
  Shells shells;
  std::vector<char> wasMixed;  ///< for each shell: true if its triangles did not all face the same side
  std::size_t turned = 0;      ///< triangles reversed
  std::optional<std::uint32_t> turnedExample;
  std::optional<std::uint32_t> oneSided;  ///< a triangle where the surface returns to itself reversed (Möbius)
};

/// Reverses triangles so that neighbours agree. In each shell reverses the smaller part; in a tie, the part without the
/// shell's first triangle. Cost: O(T).
/// @param adjacency  of the triangles; updated
Consistency makeConsistent(std::vector<Triangle>& triangles, Adjacency& adjacency);

/// Report of orientOutwards(); counts are of shells.
struct Outwardness {
  std::size_t insideOut = 0;     ///< reversed
  std::size_t cavities = 0;      ///< enclosed closed shells that face inwards
  std::size_t nestedSolids = 0;  ///< enclosed closed shells that face outwards; left unchanged
  bool nestingKnown = true;      ///< false: nesting was too costly to find, so no shell counts as enclosed
  /// Shell → the shell whose solid it bounds: for a cavity the innermost shell around it, else itself.
  std::vector<std::uint32_t> solidOf;
  std::optional<std::uint32_t> insideOutExample, cavityExample, nestedExample;  ///< a triangle of each
};

/// Reverses closed shells so that every shell enclosed by no other faces outwards. The number of shells around an
/// enclosed shell decides which way it should face: outwards if even, inwards (a cavity) if odd. If it faces the wrong
/// way, it is reversed only if all shells around it were wrong, too, or if its own orientation was mixed; otherwise it
/// stays as in the file. Open shells are left alone, and only shells of the same body enclose each other.
///
/// Cost: O(T), plus enclosingShells() if there are several shells.
/// @param bodyOfTriangle  empty: one body
Outwardness orientOutwards(Mesh& mesh, Adjacency& adjacency, const Consistency& consistency,
                           std::span<const std::uint32_t> bodyOfTriangle = {});

}  // namespace qrelief
