// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/spot_concerns.h"

#include <algorithm>
#include <cmath>

#include "math/angle.h"
#include "message_codes/pipeline.h"
#include "message_codes/printing.h"
#include "message_codes/verdict.h"
#include "pipeline/module_walls.h"
#include "pipeline/shell_below.h"
#include "pipeline/spot_light.h"
#include "settings/setting_text.h"

namespace qrelief {
namespace {

Message lightInWords(const SpotConcerns& concerns, const SpotSearchRequest& request) {
  if (request.lamps.empty()) return message<"spot-lit-unevenly">();
  if (!concerns.evenLamp) return message<"spot-lit-unevenly-by-lamps">(with::count<"count">(request.lamps.size()));
  return message<"spot-wants-another-lamp">(with::setting<"light">("light"),
                                            with::term<"lamp">(valueText(std::vector{*concerns.evenLamp})));
}

std::vector<Message> inWords(const SpotConcerns& concerns, const SpotSearchRequest& request) {
  std::vector<Message> reasons;
  if (!concerns.prints && request.placement.isText)
    reasons.push_back(
        message<"text-too-small-to-print">(with::lengthMm<"needed">(std::ceil(10 * request.leastPrintableMm) / 10)));
  else if (!concerns.prints)
    reasons.push_back(
        message<"spot-too-small-to-print">(with::lengthMm<"nozzle">(request.nozzleMm),
                                           with::lengthMm<"needed">(std::ceil(10 * request.leastPrintableMm) / 10)));
  const auto wall = with::lengthMm<"wall">(request.minWallMm);
  if (concerns.shellBelowMm)
    reasons.push_back(
        message<"nothing-can-be-carved-over-shell">(wall, with::lengthMm<"below">(*concerns.shellBelowMm)));
  else if (!concerns.takesPockets)
    reasons.push_back(message<"nothing-can-be-carved">(wall));
  if (concerns.coversColours) reasons.push_back(message<"spot-in-several-colours">());
  if (concerns.facesDown) reasons.push_back(message<"faces-down">());
  if (concerns.unevenLight > kMostUnevenLight) reasons.push_back(lightInWords(concerns, request));
  return reasons;
}

int litRing(const SpotSearchRequest& request) {
  return std::min(kLitRingModules, static_cast<int>((request.outerFactor() - 1) * request.modules / 2));
}

}  // namespace

bool coversColours(const PreparedModel& model, const Placement& placement, double edgeMm) {
  if (model.colours.empty()) return false;
  const auto isInside = [&](Vec3 point) {
    const Vec2 p = placement.frame.project(point);
    return std::max(std::abs(p.x), std::abs(p.y)) <= edgeMm / 2;
  };
  const std::optional<Colour> colour = model.colours[placement.seed];
  return std::any_of(placement.patch.triangles.begin(), placement.patch.triangles.end(), [&](std::uint32_t t) {
    if (model.colours[t] == colour) return false;
    const Vec3 a = model.mesh.corner(t, 0), b = model.mesh.corner(t, 1), c = model.mesh.corner(t, 2);
    return isInside(a) || isInside(b) || isInside(c) || isInside((a + b + c) / 3.0);
  });
}

bool facesDown(const ProjectionFrame& frame, const SpotSearchRequest& request) {
  if (!request.buildUp) return false;
  const Vec3 up = glm::normalize(request.buildUp->resolve(frame));
  return glm::dot(up, frame.normal) < std::cos(toRadians(kSteepestOverhangDeg));
}

double unevenLightOn(const EngravableModel& model, const ProjectionFrame& frame, double symbolMm,
                     const SpotSearchRequest& request) {
  if (request.placement.isText) return 0;  // people read letters in any light
  return unevenLight(*model.raster, model.box, frame, symbolMm, request.modules, request.lamps, litRing(request));
}

Result<SpotConcerns> concernsAt(const EngravableModel& model, const Placement& placement,
                                const SpotSearchRequest& request) {
  const Mesh& mesh = model.prepared.mesh;
  const auto walls = measureModuleWalls(mesh, *model.renderer, placement.frame, placement.patch,
                                        {placement.symbolMm, request.modules}, request.leastDepthMm, request.minWallMm);
  QRELIEF_TRY(walls);
  std::vector<double> thickness = walls->thicknessMm;
  const double neededMm = request.leastDepthMm + request.minWallMm;
  for (std::size_t i = 0; i < thickness.size(); ++i)  // a side wall or a shell within may be nearer than the far side
    if (walls->limitMm[i] < request.leastDepthMm && thickness[i] >= neededMm)
      thickness[i] = walls->limitMm[i] + request.minWallMm;
  const auto taking = static_cast<std::size_t>(std::count_if(
      walls->limitMm.begin(), walls->limitMm.end(), [&](double limit) { return limit >= request.leastDepthMm; }));
  const auto thin = static_cast<std::size_t>((1 - kTakenFraction) * static_cast<double>(thickness.size()));
  std::nth_element(thickness.begin(), thickness.begin() + static_cast<std::ptrdiff_t>(thin), thickness.end());

  SpotConcerns concerns;
  concerns.prints = placement.symbolMm >= request.leastPrintableMm;
  concerns.takesPockets = taking + thin >= thickness.size();
  if (!concerns.takesPockets && model.prepared.shells > 1)
    concerns.shellBelowMm = shellBelowMm(mesh, placement, neededMm);
  concerns.coversColours = coversColours(model.prepared, placement, placement.symbolMm * request.outerFactor());
  concerns.facesDown = facesDown(placement.frame, request);
  concerns.unevenLight = unevenLightOn(model, placement.frame, placement.symbolMm, request);
  if (concerns.unevenLight > kMostUnevenLight && request.lamps.size() == 1)
    concerns.evenLamp = evenLamp(*model.raster, model.box, placement.frame, placement.symbolMm, request.modules,
                                 request.lamps.front(), litRing(request));
  concerns.wallMm = thickness[thin];
  concerns.reasons = inWords(concerns, request);
  return concerns;
}

}  // namespace qrelief
