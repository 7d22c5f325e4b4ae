// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/loaded_model.h"

#include <algorithm>

#include "base/clock.h"
#include "io/read_model.h"
#include "mesh/ray.h"
#include "projection/first_spots.h"
#include "projection/silhouette.h"
#include "projection/size.h"
#include "projection/surface_raster.h"
#include "viewer/display_mesh.h"

namespace qrelief {
namespace {

constexpr double kProposedMm = 50;         // edge of the square to find on a new model, with quiet zone,
constexpr double kProposedFraction = 0.3;  // and its limit as a part of the model's diagonal
constexpr std::size_t kSpotsTried = 6;
constexpr double kGoodFit = 0.7;  // part of the square that makes a spot good enough

}  // namespace

Result<LoadedModel> loadedModel(std::vector<std::uint8_t> bytes, const std::string& fileName, double scaleToMm) {
  const auto start = Clock::now();
  auto soup = readModel(bytes, fileName);
  if (!soup) return tl::unexpected(soup.error());
  bytes = {};  // frees the file: file and model need not be in memory at once
  LoadedModel model;
  model.fileName = fileName;
  model.format = soup->format;
  model.scaleToMm = scaleToMm > 0 ? scaleToMm : soup->unitMm.value_or(1);
  model.warnings = soup->warnings;
  for (ModelPart& part : soup->parts) model.partNames.push_back(std::move(part.name));
  model.loadMs = millisecondsSince(start);

  const auto preparing = Clock::now();
  auto prepared = prepareModel(*soup, {.scaleToMm = model.scaleToMm});
  if (!prepared) return tl::unexpected(prepared.error());
  *soup = {};
  {
    const DisplayMesh display = splitAtCreases(prepared->mesh);
    model.display = std::make_shared<const GpuMesh>(display.mesh, display.normals);
  }
  model.engravable = EngravableModel::upload(std::move(*prepared));
  model.look = [raster = model.engravable->raster](const ProjectionFrame& frame,
                                                   const MapWindow& window) -> Result<std::vector<float>> {
    return raster->draw(frame, window);
  };
  model.prepareMs = millisecondsSince(preparing);
  return model;
}

std::optional<Vec3> proposedCentre(const LoadedModel& model, const GeometryPass& pass, const CameraView& camera,
                                   double eyeDistanceMm) {
  const Mesh& mesh = model.mesh();
  const double wanted = std::min(kProposedMm, kProposedFraction * boundingBox(mesh).diagonal());
  std::optional<Vec3> centre;
  double largest = 0;
  const auto spots =
      firstSpots(pass, model.engravable->gpu, camera.frame(), camera.widthAtTargetMm(), wanted, kSpotsTried);
  for (const FirstSpot& spot : spots ? *spots : std::vector<FirstSpot>{}) {
    const auto surface = closestPoint(mesh, spot.position);
    if (!surface) continue;
    const ProjectionFrame frame = makeFrame(surface->position, spot.normal, camera.skyward, eyeDistanceMm);
    const auto patch = findSilhouette(mesh, model.engravable->prepared.adjacency, frame, surface->triangle, wanted);
    const double fits = patch ? std::min(wanted, freeSize(patch->silhouette)) : 0;
    if (centre && fits <= largest) continue;
    centre = surface->position;
    largest = fits;
    if (fits >= kGoodFit * wanted) break;
  }
  if (centre) return centre;
  const auto towardsCamera = closestPoint(mesh, camera.eye());
  return towardsCamera ? std::optional(towardsCamera->position) : std::nullopt;
}

}  // namespace qrelief
