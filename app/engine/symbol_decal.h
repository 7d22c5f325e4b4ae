// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/engrave.h"
#include "viewer/viewer.h"

namespace qrelief {

/// Returns the symbol with its quiet zone as the viewer shows it on the surface before carving: ink where the patterns
/// carve. A code in colour has whole modules in the colours of its materials.
///
/// @param symbolMm  edge without quiet zone
/// @param request   its patterns, mark and ink count
Decal symbolDecal(const Symbol& symbol, const ProjectionFrame& frame, double symbolMm, const EngraveRequest& request);

}  // namespace qrelief
