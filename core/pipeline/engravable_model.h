// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "base/result.h"
#include "mesh/prepare.h"
#include "projection/placement_request.h"
#include "projection/surface_raster.h"
#include "qr/symbol.h"
#include "render/geometry_pass.h"
#include "settings/engrave_request.h"

namespace qrelief {

/// A model that is ready to be engraved: checked, and in GPU memory.
struct EngravableModel {
  PreparedModel prepared;
  GpuMesh gpu;
  std::shared_ptr<const SurfaceRaster> raster;  ///< of prepared.mesh

  /// @param prepared  blocking findings do not matter here; EngraveJob refuses them
  static std::shared_ptr<const EngravableModel> upload(PreparedModel prepared);
};

/// Parameters of the search for the placement of an engraving.
/// @param modules  of the symbol along its edge
PlacementRequest searchedPlacement(const EngraveRequest& request, int modules);

/// Checks a request as far as possible without the geometry under the code.
/// @returns BadUsage or BadInput for a request that cannot be carried out, and for a model with blocking findings
Status checkEngraving(const EngravableModel& model, const EngraveRequest& request, const Symbol& symbol);

}  // namespace qrelief
