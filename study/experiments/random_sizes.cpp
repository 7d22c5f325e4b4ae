// SPDX-License-Identifier: GPL-3.0-or-later
// Largest code that fits at every rotation, at random places of the six curved models, with the direction by normals
// alone and by depth, too [Papp 2022, figure 13]. Edge of a symbol of version 3 without the quiet zone, which must fit,
// too.
#include <algorithm>

#include "base/random.h"
#include "study/experiments/experiments.h"

namespace qrelief::study {
namespace {

constexpr int kPlaces = 20;
constexpr double kLargestMm = 100;

/// Returns a point of the surface, all of its area being equally likely.
Vec3 randomPoint(const Mesh& mesh, std::uint64_t seed) {
  std::vector<double> areaUpTo;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 a = mesh.corner(t, 0), b = mesh.corner(t, 1), c = mesh.corner(t, 2);
    areaUpTo.push_back((areaUpTo.empty() ? 0 : areaUpTo.back()) + glm::length(glm::cross(b - a, c - a)) / 2);
  }
  Random random(seed);
  const auto found = std::upper_bound(areaUpTo.begin(), areaUpTo.end(), random.uniform() * areaUpTo.back());
  const auto t = static_cast<std::size_t>(std::min(found, areaUpTo.end() - 1) - areaUpTo.begin());
  double u = random.uniform(), v = random.uniform();
  if (u + v > 1) u = 1 - u, v = 1 - v;
  const Vec3 a = mesh.corner(t, 0);
  return a + u * (mesh.corner(t, 1) - a) + v * (mesh.corner(t, 2) - a);
}

Result<Row> measure(const Row& key, StudyContext& context) {
  const auto model = context.model(key[0]);
  QRELIEF_TRY(model);
  auto request = context.usualRequest(key[0]);
  QRELIEF_TRY(request);
  PlacementRequest& place = request->placement;
  place.centreMm = randomPoint((*model)->prepared.mesh, std::stoull(key[1]));
  place.sizeMode = SizeMode::Free;
  place.maxSizeMm = kLargestMm;
  place.directionMethod = byName<DirectionMethod>(key[2], directionMethodName);
  const auto spot = findSpot(key[0], *model, *request);
  QRELIEF_TRY(spot);
  return Row{shown(spot->placement.symbolMm, 2)};
}

}  // namespace

Experiment randomSizes() {
  Experiment experiment{"random_sizes", {"model", "place", "direction"}, {"guaranteed_mm"}, {},
                        measure,        dependingOn({kPlacement})};
  for (const char* model : {"cylinder", "saddle", "star", "vase", "bumpy-sphere", "bunny"})
    for (int place = 1; place <= kPlaces; ++place)
      for (const DirectionMethod direction : {DirectionMethod::MeanNormal, DirectionMethod::DepthBalanced})
        experiment.cases.push_back({model, std::to_string(place), directionMethodName(direction)});
  return experiment;
}

}  // namespace qrelief::study
