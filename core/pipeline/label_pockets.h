// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "carving/outlined_pockets.h"
#include "label/label_layout.h"
#include "mesh/mesh.h"
#include "pipeline/placement.h"

namespace qrelief {

struct EngraveRequest;
struct EngraveResult;

/// Depth of a label, or of a text alone, in layers. One layer could vanish in the first layer's seams; more would need
/// thicker walls.
inline constexpr int kLabelLayers = 2;

/// Least width of a stroke that anything available prints: a pixel of the finest resin printers, see kMinModuleMm.
inline constexpr double kMinStrokeMm = 0.05;

/// Checks that a label, or a text alone, is large enough to make.
/// @param layout   of `label`
/// @param modules  along the symbol's edge
/// @param sizeMm   the symbol's edge
/// @returns NoSolution if strokes are thinner than kMinStrokeMm
Status checkStrokes(const LabelOptions& label, const LabelLayout& layout, int modules, double sizeMm);

/// Lays out a request's label, or its text alone, at a placement and finds its depth: kLabelLayers layers, or for an
/// inlaid code the depth of its modules; less where the wall is thin. A painted label has no depth.
///
/// Cost: O(T log T), and a ray for each corner of the label; nothing without a label.
/// @param mesh     the model before carving
/// @param modules  along the symbol's edge
/// @param inlayMm  depth of the modules of Mark::Inlay, > 0; ignored for other marks
/// @returns empty without either; the errors of layOutLabel() and checkStrokes(); NoSolution if the wall under a
///          corner leaves less than one layer of depth
Result<OutlinedPockets> labelPockets(const EngraveRequest& request, const Mesh& mesh, const Placement& placement,
                                     int modules, double inlayMm);

/// Returns the height of a label's capitals, mm; none without text.
std::optional<double> labelCapitalMm(const LabelOptions& label, int modules, double moduleMm);

/// Returns the height of a carving's capitals, of its label or its text alone, mm; none without text.
std::optional<double> capitalMmOf(const EngraveResult& result);

}  // namespace qrelief
