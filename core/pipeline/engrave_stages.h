// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "pipeline/engrave.h"

namespace qrelief {

// The parts of CarveJob's stages (engrave.h) that only compute. The job keeps their results.

/// Submodules that a depth search may carve.
struct CarvableSubmodules {
  EngraveRequest request;  ///< with its open patterns, contrast and maximum depth filled in
  SubmoduleMask mask;
  std::vector<double> limitMm;  ///< greatest depth of each submodule, see depthLimits()
};

/// Chooses the patterns that a request leaves open, by the walls at its place.
/// @param thicknessMm  PlacementMeasurement::thicknessMm()
CarvableSubmodules carvableSubmodules(const EngraveRequest& request, const Symbol& symbol, const Mesh& mesh,
                                      const Placement& placement, std::span<const double> thicknessMm);

/// Checks a carved file, and refuses defects that carving has added. Crossings are counted in the whole file if the
/// model had some, and then refuse nothing: facets that crossed before may have been cut.
/// @param origins       one for each triangle, in the order of EmbedResult: kept facets first
/// @param newTriangles  indices of the facets that carving has made, see EmbedResult
Result<SolidityReport> checkCarved(const Mesh& mesh, std::span<const FacetOrigin> origins,
                                   std::span<const std::uint32_t> newTriangles, const PreparedModel& before);

/// The code as a phone sees it.
struct ReaderPicture {
  ReaderView view;
  ReaderViewOptions options;
  std::optional<Grid<double>> luminance;  ///< of every submodule of symbol and quiet zone, for a code in colour
};

/// @param model  before carving
ReaderPicture readerPicture(const Mesh& model, const EngraveResult& result);

}  // namespace qrelief
