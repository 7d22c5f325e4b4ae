// SPDX-License-Identifier: GPL-3.0-or-later
// What the engine tells the inspector of the last engraving.
#include "engine/engine.h"

namespace qrelief {
namespace {

constexpr double kHiddenByMm = 0.01;  // what lies nearer to the reader by more hides a point

}  // namespace

const SearchRecord* Engine::search() const {
  const SearchRecord* record = result_ ? &result_->search : job_ ? job_->inspectorMaps().search : nullptr;
  return record && !record->passes.empty() ? record : nullptr;
}

const Symbol* Engine::engravedSymbol() const {
  return result_ ? &result_->symbol : job_ ? job_->inspectorMaps().symbol : nullptr;
}

double Engine::codeEdgeMm() const {
  return result_ ? result_->placement.moduleMm * (result_->symbol.size + 2 * kQuietZoneModules) : 0;
}

Result<BackDistanceMap> Engine::backDistances() const {
  const SurfaceMaps* maps = job_ ? job_->inspectorMaps().surface : nullptr;
  if (!result_ || !maps) return fail(ErrorKind::BadUsage, "nothing has been engraved yet", "press Engrave first");
  return pass_->renderBack(model_->engravable->gpu, result_->placement.frame, maps->window);
}

std::optional<Vec2> Engine::codePlaceAt(double x, double y) const {
  if (!result_) return {};
  const Mesh& mesh = showCarved_ ? result_->mesh : model_->engravable->prepared.mesh;
  const Ray ray = camera_.ray(x, y);
  const auto hit = firstHit(mesh, ray.origin, ray.direction);
  if (!hit) return {};
  const ProjectionFrame& frame = result_->placement.frame;
  if (frame.distanceAlongAxis(hit->position) <= 0) return {};
  const Vec3 fromEye = hit->position - frame.eye();
  const auto seen = firstHit(mesh, frame.eye(), fromEye);
  if (!seen || seen->distance < glm::length(fromEye) - kHiddenByMm) return {};
  const Vec2 onPlane = frame.project(hit->position) / codeEdgeMm();
  const Vec2 place(0.5 + onPlane.x, 0.5 - onPlane.y);
  if (place.x < 0 || place.y < 0 || place.x >= 1 || place.y >= 1) return {};
  return place;
}

}  // namespace qrelief
