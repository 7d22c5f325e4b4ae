// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/ink_seen.h"

#include "pipeline/engrave.h"

namespace qrelief {

void addInkSeen(BottomUp<float>& luminance, const ProjectionFrame& camera, double extentMm,
                const SurfaceRaster& surface, const EngraveResult& result) {
  const MapWindow window{extentMm, luminance.rows()};
  const std::vector<float> drawn = surface.draw(camera, window);
  const ProjectionFrame& code = result.placement.frame;
  const InkMap ink(markedSymbol(result), result.placement.symbolMm, result.request.marking.ink());
  const double eye = camera.eyeDistance;
  for (std::size_t i = 0; i < luminance.size(); ++i) {
    if (drawn[4 * i] == 0 && drawn[4 * i + 1] == 0 && drawn[4 * i + 2] == 0) continue;  // off the model
    const auto row = static_cast<int>(i) / window.texels, column = static_cast<int>(i) % window.texels;
    const Vec2 at = window.planePoint(column, row);
    // The plane point and the surface point lie on one ray, at distances as their depths.
    const Vec3 seen =
        camera.eye() + (camera.onPlane(at) - camera.eye()) * ((eye - static_cast<double>(drawn[4 * i + 3])) / eye);
    if (code.distanceAlongAxis(seen) > 0) luminance[i] *= ink.factor(code.project(seen));
  }
}

}  // namespace qrelief
