// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace qrelief {

/// Mean light that a patch of a surface receives; 1 = light of the whole sky on an unoccluded surface.
struct Received {
  float sky = 1, pastWalls = 1;        ///< fraction of a uniform sky, cosine-weighted; the same past near surface alone
  float lamps = 0, lampsUncarved = 0;  ///< from the lamps alone, without reflected light; the same before carving

  bool operator==(const Received&) const = default;
};

/// Returns the irradiance that matte material reflects into the part hidden from the sky, 1 = the open sky. Same
/// formula as in shaders/interreflection.glsl, which explains how it was fitted.
float interreflection(float visibility, float pastWalls, float albedo);

/// Returns the luminance under sky and lamps with reflected light, 1 = an unoccluded surface in the QR plane.
/// @param openIrradiance  of sky and lamps in the QR plane (light/directional_light.h)
float luminanceOf(const Received& received, float albedo, float openIrradiance);

}  // namespace qrelief
