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

/// A model that is ready for engraving: checked, and in GPU memory.
struct EngravableModel {
  PreparedModel prepared;
  GpuMesh gpu;
  std::shared_ptr<const SurfaceRaster> raster;  ///< of prepared.mesh

  /// @param prepared  may have blocking findings; EngraveJob refuses them
  static std::shared_ptr<const EngravableModel> upload(PreparedModel prepared);
};

/// Returns the parameters of an engraving's placement search.
/// @param modules  along the symbol's edge
PlacementRequest searchedPlacement(const EngraveRequest& request, int modules);

/// Checks a request as far as possible without the geometry under the code.
/// @returns BadUsage or BadInput if the request is impossible or the model has blocking findings
Status checkEngraving(const EngravableModel& model, const EngraveRequest& request, const Symbol& symbol);

}  // namespace qrelief
