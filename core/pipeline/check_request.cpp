// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/check_request.h"

#include <cmath>
#include <fmt/format.h>

namespace qrelief {

Status checkRequest(const EngraveRequest& request) {
  const auto bad = [](std::string message, std::string hint) {
    return fail(ErrorKind::BadUsage, std::move(message), std::move(hint));
  };
  if (const double contrast = request.contrastAsked(); !(contrast > 0 && contrast < 1))
    return bad(fmt::format("The contrast is {:g}", contrast), "Choose a value between 0 and 1, such as 0.3");
  if (request.lights.size() > kMaxLights)
    return bad(fmt::format("There are {} lights", request.lights.size()), fmt::format("Give at most {}", kMaxLights));
  for (const DirectionalLight& light : request.lights) {
    if (!(light.elevationDeg > 0 && light.elevationDeg <= 90))
      return bad(fmt::format("A light's elevation is {:g}°", light.elevationDeg),
                 "Choose more than 0 and at most 90 degrees over the code");
    if (!(light.strength >= 0 && light.strength <= 1000) || !std::isfinite(light.azimuthDeg))
      return bad(fmt::format("A light has azimuth {:g}° and strength {:g}", light.azimuthDeg, light.strength),
                 "Choose a strength from 0 to 1000 times the sky's, such as 1");
  }
  if (!(request.layerMm >= 0.01 && request.layerMm <= 1))
    return bad(fmt::format("The layer height is {:g} mm", request.layerMm),
               "Choose between 0.01 and 1 mm, such as 0.1");
  if (!(request.nozzleMm >= 0.01 && request.nozzleMm <= 10))
    return bad(fmt::format("The nozzle is {:g} mm wide", request.nozzleMm),
               "Choose between 0.01 and 10 mm, such as 0.4");
  if (!(request.minWallMm >= 0)) return bad("The minimum wall is negative", "Choose 0 or more, such as 0.8");
  if (request.maxDepthMm && !(*request.maxDepthMm >= 0.1))
    return bad(fmt::format("The greatest depth is {:g} mm", *request.maxDepthMm), "Choose at least 0.1 mm, one layer");
  const PlacementRequest& place = request.placement;
  if (!(place.eyeDistanceMm >= 20 && place.eyeDistanceMm <= 1e5))
    return bad(fmt::format("The eye distance is {:g} mm", place.eyeDistanceMm),
               "Choose between 20 mm and 100 m; 250 mm is a phone's");
  if (place.sizeMode == SizeMode::Fixed && !(place.sizeMm > 0 && place.sizeMm <= 1e4))
    return bad(fmt::format("The size is {:g} mm", place.sizeMm), "Choose the symbol's edge in mm, such as 35");
  if (!(place.maxSizeMm > 0 && place.maxSizeMm <= 1e4))
    return bad(fmt::format("The greatest size is {:g} mm", place.maxSizeMm), "Choose an edge in mm, such as 60");
  if (place.direction && !(glm::length(*place.direction) > 0))
    return bad("The direction has no length", "give a vector such as 0,0,1");
  return {};
}

}  // namespace qrelief
