// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "support/engrave_case.h"

namespace qrelief {

/// How a case ended, and whether it may end so.
struct OracleVerdict {
  std::string kind;   ///< "solid", or what was refused: "does not fit", "hidden", ...
  std::string fault;  ///< what is wrong about it, in words; empty if it is as it must be
};

/// Judges the outcome of a case by means of its own. A solid must be
///   - closed, manifold, oriented, without triangles that have no area or that cross others, once read back from the
///     very bytes of the STL file; and the job must say so, too;
///   - the model's facets bit for bit, except for those that come within a submodule of the code;
///   - at every point looked at, as much deeper than the model as the depth field says, and so smaller by the sum of
///     the pockets' volumes (surface mode "preserved");
///   - at least `minWallMm` thick behind and beside the floors looked at;
///   - of a code that is seen as a whole: no ray through its square misses the model or steps to another part of it.
/// A refusal must be typed and its reason true: a code that does not fit is crossed by the silhouette, as rays tell, or
/// needs a facet that lies partly behind another that is seen, or before it; a hidden centre has something before it; a
/// wall is too thin where its distance is measured; a model that is not closed has an open edge; a text that is too
/// long has more bytes than the standard's table allows.
OracleVerdict judge(const EngraveCase& made, const EngravableModel& model, const Result<EngraveResult>& result);

/// Prepares, engraves and judges. Needs a GL context.
OracleVerdict runEngraveCase(const EngraveCase& made);

/// The same without rendering, many times as fast: the direction is the one asked for or the facet's normal, and the
/// depths are made up, as deep and as uneven as the walls allow.
OracleVerdict runCarvingCase(const EngraveCase& made, Choices& choices);

}  // namespace qrelief
