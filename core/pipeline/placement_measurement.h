// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "pipeline/engravable_model.h"
#include "pipeline/placement.h"
#include "pipeline/placement_light.h"

namespace qrelief {

/// Measurements of the uncarved place: the material's thickness and the light on it. They are the same for every symbol
/// of one size, so a batch measures them once.
class PlacementMeasurement {
 public:
  struct Request {
    ProjectionFrame frame;
    double moduleMm = 0;  ///< on the QR plane, > 0
    CellLayout layout;    ///< layout of the symbol
    float albedo = 0.7f;  ///< of the material, 0 … 1
    std::vector<DirectionalLight> lights = {};
    Device device = Device::Faster;
    bool withLight = true;  ///< false: only the thickness, which the processor draws

    bool operator==(const Request&) const = default;
  };

  /// @param programs  for a model that uses shaders; null: makes its own
  /// @returns Internal if the GL implementation cannot make the maps
  static Result<std::shared_ptr<PlacementMeasurement>> create(std::shared_ptr<const EngravableModel> model,
                                                              std::shared_ptr<const LuminancePrograms> programs,
                                                              const Request& request);

  const Request& request() const { return request_; }
  /// Returns maps of the surface for the inspector, drawn at the first call; null without a GL context, or if the GL
  /// implementation cannot draw them.
  const SurfaceMaps* maps() const;
  /// Returns the least thickness along the rays through each submodule of the symbol, mm; infinite where no ray meets
  /// both sides. Row-major from the symbol's top left.
  const std::vector<double>& thicknessMm() const { return thicknessMm_; }
  /// Returns the light on the place during carving, if Request::withLight is set. Only one job may use it at a time.
  PlacementLight& light() { return *light_; }
  const PlacementLight& light() const { return *light_; }

 private:
  MapWindow window(int texelsPerCell) const;
  PlacementLightOptions lightOptions() const;
  Status measureByShaders(std::shared_ptr<const LuminancePrograms> programs);
  void measureByProcessor();
  /// @param front, back  distances from the eye along the rays of texelsPerCell² texels of every cell; 0: no surface
  void measureThickness(std::span<const float> front, std::span<const float> back, int texelsPerCell);

  Request request_;
  std::shared_ptr<const EngravableModel> model_;
  mutable std::optional<SurfaceMaps> maps_;
  std::vector<double> thicknessMm_;
  std::unique_ptr<PlacementLight> light_;
};

struct DepthLimitOptions {
  double maxDepthMm = 0;  ///< limit for every pocket, > 0
  double minWallMm = 0;   ///< material that must remain behind every floor, ≥ 0
};

/// Returns the greatest depth of every submodule, mm; 0 where nothing can be carved. It is the least of three limits:
/// the requested depth; the distance to the other side of the material in any direction (depth/wall_limit.h); and the
/// thickness along every texel's ray, which catches features too fine for the samples of the second limit.
/// @param thicknessMm  see PlacementMeasurement::thicknessMm()
/// @returns one value for each submodule of the mask, row-major from the symbol's top left
std::vector<double> depthLimits(const Mesh& mesh, const Placement& placement, const SubmoduleMask& mask,
                                std::span<const double> thicknessMm, const DepthLimitOptions& options);

}  // namespace qrelief
