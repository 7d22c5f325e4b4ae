// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/engrave.h"

namespace qrelief {

/// Makes the body that fills the pockets (embedding/inlay.h) of what was carved before, for printing in two colours,
/// and checks it as an STL round trip gives it back: EngraveResult::inlay and ::inlaySolidity.
///
/// Cost: as carving the mesh and checking the solid, for the pockets alone.
/// @param model   that was carved
/// @param surface as it was carved
/// @returns what embedDepthField() does; Internal if the round trip fails
Status addInlay(const EngravableModel& model, SurfaceMode surface, EngraveResult& result);

}  // namespace qrelief
