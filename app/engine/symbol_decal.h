// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "math/frame.h"
#include "qr/symbol.h"
#include "viewer/viewer.h"

namespace qrelief {

struct EngraveRequest;
struct SearchRecord;

/// Power of the light in a pocket, as the view shows it (shaders/view_lighting.frag).
inline constexpr double kShadowPower = 2.5;

/// Returns the code as the viewer shows it on the surface before carving: the symbol with ink where the patterns carve,
/// its quiet zone, and frame and text around it. A code in colour has whole modules in the colours of its materials. A
/// label that cannot be laid out is left out, but has its room.
///
/// Cost: milliseconds with a label.
/// @param symbolMm  edge without quiet zone
/// @param request   its patterns, mark, ink and label count
Decal symbolDecal(const Symbol& symbol, const ProjectionFrame& frame, double symbolMm, const EngraveRequest& request);

/// Shows a code's decal as it will be carved: each submodule as dark as the search has made it, on the surface itself.
/// @param decal   of symbolDecal(), for the symbol
/// @param search  not empty
void showSearch(Decal& decal, const Symbol& symbol, double symbolMm, const SearchRecord& search);

}  // namespace qrelief
