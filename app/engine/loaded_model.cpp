// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/loaded_model.h"

#include <algorithm>
#include <utility>

#include "base/clock.h"
#include "engine/first_spots.h"
#include "engine/model_file.h"
#include "mesh/ray.h"
#include "projection/silhouette.h"
#include "projection/size.h"
#include "viewer/coloured_mesh.h"

namespace qrelief {
namespace {

constexpr double kProposedMm = 50;         // edge of the square to find on a new model, with quiet zone,
constexpr double kProposedFraction = 0.3;  // and its limit as a part of the model's diagonal
constexpr std::size_t kSpotsTried = 6;
constexpr double kGoodFit = 0.7;  // part of the square that makes a spot good enough

}  // namespace

Result<LoadedModel> loadedModel(const std::shared_ptr<const GeometryPass>& pass, std::vector<std::uint8_t> bytes,
                                const std::string& fileName, double scaleToMm) {
  auto file = readModelFile(std::move(bytes), fileName, scaleToMm);
  QRELIEF_TRY(file);
  LoadedModel model;
  model.fileName = fileName;
  model.format = std::move(file->format);
  model.scaleToMm = file->scaleToMm;
  model.loadMs = file->loadMs;
  model.warnings = std::move(file->warnings);
  model.partNames = std::move(file->partNames);

  const auto start = Clock::now();
  if (pass) {
    model.display =
        std::make_shared<const GpuMesh>(colouredMesh(splitAtCreases(file->prepared.mesh), file->prepared.colours));
  }
  model.engravable = EngravableModel::create(std::move(file->prepared), pass);
  model.prepareMs = file->prepareMs + millisecondsSince(start);
  return model;
}

std::optional<Vec3> proposedCentre(const LoadedModel& model, const OrbitCamera& camera, double eyeDistanceMm) {
  const Mesh& mesh = model.mesh();
  const double proposedMm = std::min(kProposedMm, kProposedFraction * boundingBox(mesh).diagonal());
  std::optional<Vec3> centre;
  double largest = 0;
  const CameraView view = camera.view();
  const auto spots =
      firstSpots(*model.engravable->renderer, view.frame(), view.widthAtTargetMm(), proposedMm, kSpotsTried);
  for (const OrientedPoint& spot : spots ? *spots : std::vector<OrientedPoint>{}) {
    const auto surface = closestPoint(mesh, spot.position);
    if (!surface) continue;
    const ProjectionFrame frame = makeFrame(surface->position, spot.normal, camera.modelUp(), eyeDistanceMm);
    const auto patch = findSilhouette(mesh, model.engravable->prepared.adjacency, frame, surface->triangle, proposedMm);
    const double fits = patch ? std::min(proposedMm, freeSize(patch->silhouette)) : 0;
    if (centre && fits <= largest) continue;
    centre = surface->position;
    largest = fits;
    if (fits >= kGoodFit * proposedMm) break;
  }
  if (centre) return centre;
  const auto towardsCamera = closestPoint(mesh, view.eye());
  return towardsCamera ? std::optional(towardsCamera->position) : std::nullopt;
}

}  // namespace qrelief
