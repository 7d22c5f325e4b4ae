// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "base/result.h"
#include "mesh/prepare.h"
#include "projection/placement_request.h"
#include "qr/symbol.h"
#include "render/gpu_surface.h"
#include "render/surface_raster.h"

namespace qrelief {

struct EngraveRequest;

/// Device that draws maps of a model and computes the light on it.
enum class Device : std::uint8_t {
  Faster,  ///< the GPU if there is a real one, else the processor
  Gpu,     ///< shaders on any renderer, software included; without a GL context, the processor
  Processor
};

/// A model that is ready for engraving: checked, and in GPU memory if there is a GL context.
struct EngravableModel {
  PreparedModel prepared;
  Box3 box;                                         ///< of prepared.mesh
  std::shared_ptr<const SurfaceRaster> raster;      ///< of prepared.mesh
  std::shared_ptr<const GpuSurface> gpu;            ///< the same surface; null without a GL context
  std::shared_ptr<const SurfaceRenderer> renderer;  ///< `raster` or `gpu`: draws the maps for searches

  /// @param prepared  may have blocking findings; CarveJob refuses them
  /// @param pass      geometry pass of the current GL context, or null without a context
  static std::shared_ptr<const EngravableModel> create(PreparedModel prepared, std::shared_ptr<const GeometryPass> pass,
                                                       Device device = Device::Faster);
  /// Creates a model with a geometry pass of its own. Needs a current GL context.
  static std::shared_ptr<const EngravableModel> upload(PreparedModel prepared);

  /// Returns true if shaders compute the light on the model for this device.
  bool usesShaders(Device device) const {
    return gpu && (device == Device::Gpu || (device == Device::Faster && renderer == gpu));
  }
};

/// Returns the parameters of an engraving's placement search.
/// @param modules  along the symbol's edge
PlacementRequest searchedPlacement(const EngraveRequest& request, int modules);

/// Checks a request as far as possible without the geometry under the code.
/// @returns BadUsage or BadInput if the request is impossible or the model has blocking findings; NoSolution if the
/// model
///          is too small for the code, or the size too small for the label or text
Status checkEngraving(const EngravableModel& model, const EngraveRequest& request, const Symbol& symbol);

}  // namespace qrelief
