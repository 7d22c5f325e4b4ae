// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "mesh/polygon_soup.h"
#include "mesh/repair.h"
#include "mesh/topology.h"
#include "mesh/triangle_clusters.h"
#include "mesh/unit_suggestions.h"

namespace qrelief {

/// A finding about a model. The message's code is stable: "open-edges", "duplicate-triangles". Its values include
/// `count`, if there can be several, and `at`, the place of one example in file units.
struct Finding {
  enum class Severity {
    Note,     ///< nothing is wrong
    Warning,  ///< harmless, or repaired as the finding says
    Blocking  ///< the model is not a closed, oriented solid; it can be shown but not engraved
  };
  Severity severity = Severity::Note;
  Message message;
};

/// Returns "note", "warning" or "blocking"; scripts rely on these names.
const char* severityName(Finding::Severity severity);

struct PrepareOptions {
  double scaleToMm = 1;  ///< file units → mm, > 0, finite
  RepairOptions repair = {};
};

/// A model that is welded, cleaned and searchable; engravable if no finding is blocking.
struct PreparedModel {
  Mesh mesh;  ///< mm; with the body of each triangle
  std::vector<Body>
      bodies;  ///< those that the file names; otherwise its closed shells, each with its cavities. At least one
  double scaleToMm = 1;  ///< file units → mm
  Adjacency adjacency;
  std::vector<Vec3f> normals;                          ///< smooth unit vertex normals
  std::shared_ptr<const ClusteredTriangles> clusters;  ///< of `mesh`, for searches that look at a part of it
  std::vector<Finding> findings;
  std::size_t shells = 0;
  bool crossesItself = false;  ///< some triangles of one shell cross and were not separated
  bool hasCrossings = false;   ///< the same, or shells touch or overlap
  /// Pairs of findCrossings(), ascending; absent if they were not all found.
  std::optional<std::vector<TrianglePair>> crossings;
  std::vector<UnitSuggestion> unitSuggestions;  ///< for tiny and huge models; may be empty
  std::shared_ptr<const ThreeMfSource> source;  ///< the soup's, if there is one
  /// The soup's triangle that each triangle comes from or adjoins; empty: there is no source.
  std::vector<std::uint32_t> originOfTriangle;
  std::vector<std::optional<Colour>> colours;  ///< of the triangles; empty unless the file has at least two colours
  std::vector<char> wasRepaired;  ///< body → a repair changed triangles that the source has; empty: there is no source

  /// Returns the number of triangles of each body.
  std::vector<std::size_t> bodySizes() const;
  /// Returns the first blocking finding as an error, if there is one.
  Status engravable() const;
};

/// Prepares a model for engraving: scales it to mm, rounds to 32-bit floats, welds equal positions within each body,
/// drops unreferenced vertices, makes the repairs of mesh/repair.h body by body, and reports what it found and
/// repaired, and where. Closed shells that touch stay apart (mesh/touching_shells.h).
///
/// Cost: O(T log T), most of it the search for crossing triangles.
/// @returns the model, with any blocking findings; an error only for a model that cannot be represented: no triangle
///          left, coordinates that are not finite or implausibly large in mm (> 10 km across), too many triangles.
Result<PreparedModel> prepareModel(const PolygonSoup& soup, const PrepareOptions& options);

}  // namespace qrelief
