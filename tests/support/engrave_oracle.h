// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "support/engrave_case.h"

namespace qrelief {

/// Outcome of a case, and the oracle's verdict on it.
struct OracleVerdict {
  std::string kind;   ///< "solid", or the reason for a refusal: "does not fit", "hidden", ...
  std::string fault;  ///< description of the fault; empty if the outcome is correct
};

/// Judges the outcome of a case without using the code under test. A solid must
///   - be closed, manifold and oriented, without triangles that have no area or cross others, once read back from the
///     bytes of the STL file; the job must agree;
///   - keep the model's facets bit for bit, except those within a submodule of the code;
///   - be deeper than the model by the depth field's value at every sampled point, and smaller by the sum of the
///     pockets' volumes (surface mode "preserved");
///   - keep at least `minWallMm` of material behind and beside each sampled floor point;
///   - show the code as a whole: no ray through its square misses the model or steps to another part of it.
/// A refusal must be typed and its reason true. If a code does not fit, rays find the silhouette crossing it, or it
/// needs a facet that lies partly behind or in front of another visible facet. If a centre is hidden, something lies in
/// front of it. If a wall is too thin, so is its measured distance. If a model is not closed, it has an open edge. If a
/// text is too long, it has more bytes than the standard's table allows.
OracleVerdict judge(const EngraveCase& engraveCase, const EngravableModel& model, const Result<EngraveResult>& result);

/// Prepares, engraves and judges. Needs a GL context.
OracleVerdict runEngraveCase(const EngraveCase& engraveCase);

/// Does the same without rendering, many times faster. The direction is the requested one or the facet's normal; the
/// depths are made up, as deep and as uneven as the walls allow.
OracleVerdict runCarvingCase(const EngraveCase& engraveCase, Choices& choices);

}  // namespace qrelief
