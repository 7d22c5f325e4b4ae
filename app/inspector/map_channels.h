// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "base/grid.h"
#include "inspector/value_map.h"
#include "render/geometry_pass.h"
#include "render/luminance_pass.h"

namespace qrelief {

/// A quantity to show over symbol and quiet zone. The first six come from the viewer's G-buffer; the others have one
/// value per submodule.
enum class MapChannel : std::uint8_t {
  FacetNormal,
  SmoothNormal,
  Height,
  Distance,
  BackDistance,
  Thickness,
  Limit,
  Depth,
  Luminance,
  Excess,
  Sky,
  PastWalls,
  Lamps
};

struct ChannelInfo {
  const char* name;
  const char* what;
  const char* unit;            ///< "" if it has none
  bool changesByPass = false;  ///< during the search
  bool isSigned = false;       ///< shown on a scale with zero in the middle
};

inline constexpr std::array<ChannelInfo, 13> kChannels = {{
    {"Facet normal", "angle between facet and line to the viewer", "°"},
    {"Smooth normal", "the same for the interpolated normals", "°"},
    {"Height", "over the QR plane, towards the viewer", "mm", false, true},
    {"Distance", "from the viewer's eye, along the ray", "mm"},
    {"Back distance", "from the eye to the exit of the ray", "mm"},
    {"Thickness", "of the material along the ray", "mm"},
    {"Wall limit", "greatest depth of a submodule", "mm"},
    {"Depth", "carved, along the ray", "mm", true},
    {"Luminance", "LS, 1 = unoccluded", "", true},
    {"Excess G", "AL·(c - 1) + LS: above 0 is too bright", "", true, true},
    {"Sky", "visible fraction of the sky", ""},
    {"Sky past walls", "the same, hidden only by pocket walls", ""},
    {"Lamps", "direct light of the lamps", ""},
}};

inline const ChannelInfo& infoOf(MapChannel channel) { return kChannels[static_cast<std::size_t>(channel)]; }
inline bool isOfSurface(MapChannel channel) { return channel <= MapChannel::Thickness; }
inline bool isOfLight(MapChannel channel) { return channel >= MapChannel::Sky; }

/// Extracts a channel of the G-buffer.
/// @param edgeMm  of symbol and quiet zone; the maps' margin is left out
/// @param back    for BackDistance and Thickness; may be null for the others
ValueMap surfaceMap(const SurfaceMaps& maps, const BackDistanceMap* back, double edgeMm, MapChannel channel);

/// Extracts a channel of the received light.
/// @param received  of symbol and quiet zone
ValueMap lightMap(const Grid<Received>& received, MapChannel channel);

}  // namespace qrelief
