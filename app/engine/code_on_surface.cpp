// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/code_on_surface.h"

#include <algorithm>
#include <cmath>

#include "engine/nearby_centre.h"
#include "engine/symbol_decal.h"
#include "math/angle.h"
#include "pipeline/default_patterns.h"
#include "pipeline/spot_concerns.h"
#include "projection/flatness.h"

namespace qrelief {
namespace {

constexpr int kReachTexels = 192;
constexpr double kReachEdges = 3;  // edge of the map around a placed code, in code edges: the code can be turned and
                                   // enlarged

Result<VisibilityMap> reachAround(const LoadedModel& model, const Decal& decal) {
  return lookAround(*model.engravable->raster, decal.frame, {kReachEdges * decal.edgeMm, kReachTexels});
}

std::shared_ptr<const VisibilityMap> trusted(VisibilityMap reach) {
  reach.trust();
  return std::make_shared<const VisibilityMap>(std::move(reach));
}

/// The surface on which codes are estimated. Following the pointer does not wait for the GPU.
EstimatedSurface estimatedSurface(const LoadedModel& model) {
  return {model.mesh(), *model.engravable->raster, model.engravable->box.diagonal()};
}

/// People read a text at any angle.
bool isForgiving(double bendMm, double moduleMm, const EngraveRequest& request) {
  return request.code.isText() || aimToleranceDeg(bendMm, moduleMm) >= kForgivingTiltDeg;
}

}  // namespace

bool CodeOnSurface::covers(const Mesh& mesh, const SurfacePoint& at) const {
  const Vec2 onPlane = glm::abs(decal.frame.project(at.position));
  const bool isTowards = glm::dot(triangleNormal(mesh, at.triangle), decal.frame.eye() - at.position) > 0;
  return isTowards && std::max(onPlane.x, onPlane.y) < decal.edgeMm / 2;
}

void CodeOnSurface::adjust(double toRotationDeg, double toSymbolMm, double outer) {
  decal.frame = turned(decal.frame, toRadians(toRotationDeg - rotationDeg));
  const Vec3 right = decal.frame.right;
  const double turn = std::atan2(glm::dot(right, reach->frame.up), glm::dot(right, reach->frame.right));
  const double limitMm = (reach->alignedMm(turn) - reach->window.texelMm()) / outer;
  if (limitMm > 0) toSymbolMm = std::min(toSymbolMm, limitMm);
  decal.edgeMm *= toSymbolMm / symbolMm;
  decal.reach = reach;
  rotationDeg = toRotationDeg;
  symbolMm = toSymbolMm;
  isExact = false;
  missingFraction = reach->missingFraction(symbolMm * outer, turn);
}

SurfacePoint centreNear(const LoadedModel& model, const CodeInput& input, Vec3 sceneUp, const SurfacePoint& picked) {
  const Symbol& symbol = *input.symbol();
  const double leastMm = symbol.size * leastPrintableModuleMm(symbol, input.settings());
  const auto found =
      nearbyCentre(estimatedSurface(model), picked, symbol.size, input.placementAt(picked.position, sceneUp), leastMm);
  return found ? found->centre : picked;
}

Result<CodeOnSurface> estimatedCode(const LoadedModel& model, const CodeInput& input, Vec3 sceneUp,
                                    const SurfacePoint& at, std::optional<double> expectedMm) {
  const Symbol& symbol = *input.symbol();
  auto estimate =
      estimateCode(estimatedSurface(model), at, symbol.size, input.placementAt(at.position, sceneUp), expectedMm);
  QRELIEF_TRY(estimate);
  CodeOnSurface code;
  code.symbolMm = estimate->symbolMm;
  code.modules = symbol.size;
  code.rotationDeg = estimate->rotationDeg;
  code.missingFraction = estimate->missingFraction;
  code.isForgiving = isForgiving(estimate->bendMm, code.moduleMm(), input.settings());
  code.reach = estimate->reach;
  code.decal = symbolDecal(symbol, estimate->frame, estimate->symbolMm, input.settings());
  code.decal.reach = estimate->reach;
  return code;
}

Result<CodeOnSurface> exactCode(const LoadedModel& model, const Symbol& symbol, const EngraveRequest& request,
                                const Placement& placement) {
  CodeOnSurface code;
  code.decal = symbolDecal(symbol, placement.frame, placement.symbolMm, request);
  code.symbolMm = placement.symbolMm;
  code.modules = symbol.size;
  code.rotationDeg = placement.rotationDeg;
  code.isForgiving = isForgiving(placement.bendMm, placement.moduleMm, request);
  code.isExact = true;
  auto reach = reachAround(model, code.decal);
  QRELIEF_TRY(reach);
  code.decal.reach = trusted(*reach);
  code.reach = std::make_shared<const VisibilityMap>(std::move(*reach));
  return code;
}

Status findConcerns(CodeOnSurface& code, const LoadedModel& model, const Symbol& symbol, const EngraveRequest& request,
                    const Placement& placement) {
  if (code.concerns) return {};
  auto found = concernsAt(*model.engravable, placement, spotSearchFor(request, symbol));
  QRELIEF_TRY(found);
  code.concerns = std::move(found->reasons);
  return {};
}

Result<Decal> visibleDecal(const LoadedModel& model, const Symbol& symbol, const ProjectionFrame& frame,
                           double symbolMm, const EngraveRequest& request) {
  return onVisibleSurface(model, symbolDecal(symbol, frame, symbolMm, request));
}

Result<Decal> onVisibleSurface(const LoadedModel& model, Decal decal) {
  auto reach = reachAround(model, decal);
  QRELIEF_TRY(reach);
  decal.reach = trusted(std::move(*reach));
  return decal;
}

}  // namespace qrelief
