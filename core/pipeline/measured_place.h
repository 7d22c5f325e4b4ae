// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "base/result.h"
#include "pipeline/cell_layout.h"
#include "render/geometry_pass.h"
#include "render/luminance_pass.h"

namespace qrelief {

/// What a place looks like before anything is carved there: maps of its surface, how thick the material is, and the
/// light on it. The same for every symbol of a size, so that whoever carves many measures it once.
class MeasuredPlace {
 public:
  struct Request {
    ProjectionFrame frame;
    double moduleMm = 0;  ///< on the QR plane, > 0
    CellLayout layout;    ///< of the symbol
    float albedo = 0.7f;  ///< of the material, 0 … 1
    std::vector<DirectionalLight> lights = {};

    bool operator==(const Request&) const = default;
  };

  /// @returns Internal if the GL implementation cannot make the maps
  static Result<std::shared_ptr<MeasuredPlace>> create(const GpuMesh& model, const GeometryPass& pass,
                                                       std::shared_ptr<const LuminancePrograms> programs,
                                                       const Request& request);

  const Request& request() const { return request_; }
  const SurfaceMaps& maps() const { return maps_; }
  /// Along the rays through each submodule of the symbol, the least, mm; infinite where no ray meets both sides.
  /// Row-major from the symbol's top left.
  const std::vector<double>& thicknessMm() const { return thicknessMm_; }
  /// On the place as something carves it; one at a time.
  LuminancePass& light() { return *light_; }
  const LuminancePass& light() const { return *light_; }
  /// Takes all carving back from light().
  void uncarve();

 private:
  Status measureLight(const SurfaceMaps& around, std::shared_ptr<const LuminancePrograms> programs);
  void measureThickness(const BackDistanceMap& back);

  Request request_;
  SurfaceMaps maps_;
  std::vector<double> thicknessMm_;
  std::optional<LuminancePass> light_;
  std::vector<Received> uncarved_;  // by every cell
};

}  // namespace qrelief
