// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "mesh/mesh.h"

namespace qrelief {

struct EngravableModel;
struct EngraveResult;

/// Makes the body that fills the pockets of a carved model (carving/inlay.h), for printing in two colours, and checks
/// it after an STL round trip. Sets EngraveResult::inlay and EngraveResult::inlaySolidity.
///
/// Cost: carving the mesh and checking the solid, for the pockets alone.
/// @param model   model before carving
/// @returns the errors of embedDepthField(); Internal if the round trip fails
Status addInlay(const EngravableModel& model, EngraveResult& result);

/// Sets and checks an inlay that was made with the mesh. @returns Internal if the round trip fails
Status setInlay(const Mesh& inlay, EngraveResult& result);

}  // namespace qrelief
