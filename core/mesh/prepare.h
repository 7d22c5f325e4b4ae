// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/result.h"
#include "mesh/polygon_soup.h"
#include "mesh/repair.h"
#include "mesh/topology.h"
#include "mesh/unit_suggestions.h"

namespace qrelief {

/// One thing found out about a model. The message's code is stable: "open-edges", "duplicate-triangles". Among its
/// values are `count`, where there may be several, and `at`, one example's place in file units.
struct Finding {
  enum class Severity {
    Note,     ///< nothing is wrong
    Warning,  ///< harmless, or mended: the finding says how
    Blocking  ///< the model is no closed, oriented solid: it can be shown, not engraved
  };
  Severity severity = Severity::Note;
  Message message;
};

/// "note", "warning", "blocking": names that scripts rely on.
const char* severityName(Finding::Severity severity);

struct PrepareOptions {
  double scaleToMm = 1;  ///< file units → mm, > 0, finite
  RepairOptions repair = {};
};

/// A model that is welded, cleaned and searchable; engravable if no finding is blocking.
struct PreparedModel {
  Mesh mesh;             ///< mm
  double scaleToMm = 1;  ///< file units → mm
  Adjacency adjacency;
  std::vector<Vec3f> normals;  ///< smooth unit vertex normals
  std::vector<Finding> findings;
  std::size_t shells = 0;
  bool crossesItself = false;                   ///< triangles cross each other, and were not parted
  std::vector<std::uint32_t> partOfTriangle;    ///< index into the soup's parts; empty: one part only
  std::vector<UnitSuggestion> unitSuggestions;  ///< if the model is tiny; may be empty

  /// The first blocking finding as an error, if there is one.
  Status engravable() const;
};

/// Scales to mm, rounds to 32-bit floats, welds by equal position (across parts, too: after a round trip through STL
/// equal positions are one vertex, so parts that touch along an edge are no solid), drops unreferenced vertices, makes
/// the repairs of mesh/repair.h, and says what it found, where, and what it did.
///
/// Cost: O(T log T), most of it the search for crossing triangles.
/// @returns the model, blocking findings included; an error only for what cannot be represented: no triangle left,
///          coordinates that are not finite or whose size is implausible as mm (> 10 km across), too many triangles.
Result<PreparedModel> prepareModel(const PolygonSoup& soup, const PrepareOptions& options);

}  // namespace qrelief
