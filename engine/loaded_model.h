// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/engrave.h"
#include "projection/direction.h"
#include "viewer/orbit_camera.h"

namespace qrelief {

/// A model that a code can be engraved in, and how it is shown.
struct LoadedModel {
  std::string fileName, format;
  double scaleToMm = 1, loadMs = 0, prepareMs = 0;
  std::vector<Message> warnings;
  std::vector<std::string> partNames;
  std::shared_ptr<const EngravableModel> engravable;
  SurfaceLook look;  ///< by the processor: what follows the pointer does not wait for pictures
  std::shared_ptr<const GpuMesh> display;

  const Mesh& mesh() const { return engravable->prepared.mesh; }
};

/// Reads, repairs and uploads a file.
/// @param bytes      freed as soon as it is read
/// @param scaleToMm  file units → mm; 0: as the file says (3MF), else 1
Result<LoadedModel> loadedModel(std::vector<std::uint8_t> bytes, const std::string& fileName, double scaleToMm);

/// A point of what the camera sees where a code probably does well; else the surface point nearest to the camera.
std::optional<Vec3> proposedCentre(const LoadedModel& model, const GeometryPass& pass, const CameraView& camera,
                                   double eyeDistanceMm);

}  // namespace qrelief
