// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/engravable_model.h"
#include "projection/direction.h"
#include "render/gpu_mesh.h"
#include "viewer/orbit_camera.h"

namespace qrelief {

/// A model to engrave, and its display mesh.
struct LoadedModel {
  std::string fileName, format;
  double scaleToMm = 1, loadMs = 0, prepareMs = 0;
  std::vector<Message> warnings;
  std::vector<std::string> partNames;
  std::shared_ptr<const EngravableModel> engravable;
  std::shared_ptr<const GpuMesh> display;  ///< null without a GL context

  const Mesh& mesh() const { return engravable->prepared.mesh; }
};

/// Reads, repairs and uploads a file.
/// @param pass       of the GL context; null: there is none
/// @param bytes      freed as soon as it is read
/// @param scaleToMm  file units → mm; 0: as the file says (3MF), else 1
Result<LoadedModel> loadedModel(const std::shared_ptr<const GeometryPass>& pass, std::vector<std::uint8_t> bytes,
                                const std::string& fileName, double scaleToMm);

/// Proposes a point in the camera's view where a code probably fits well; else the surface point nearest to the camera.
std::optional<Vec3> proposedCentre(const LoadedModel& model, const OrbitCamera& camera, double eyeDistanceMm);

}  // namespace qrelief
