// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/engrave.h"
#include "wasm/viewer.h"

namespace qrelief {

/// The symbol with its quiet zone as the viewer shows it on the surface before it is carved: ink where the patterns ask
/// for carving.
///
/// @param request  its patterns count
/// @param mesh     the one that the placement is on
SurfacePrint symbolPrint(const Symbol& symbol, const Placement& placement, const EngraveRequest& request,
                         const Mesh& mesh);

}  // namespace qrelief
