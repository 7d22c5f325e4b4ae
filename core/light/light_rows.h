// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace qrelief {

/// A border that a horizon passes on its way outwards, the same for all patches.
struct HorizonStep {
  std::int32_t patch = 0;            ///< index of the patch behind the border, from the receiver's own
  std::int32_t column = 0, row = 0;  ///< how many columns to the right and rows up it lies
  float rightMm = 0, upMm = 0;       ///< from its middle to the border
  float perMm = 0;                   ///< 1 / distance from the receiving point
  float fromBefore = 0.5f;           ///< where it lies between the middles of the patch before and this one, 0 … 1
};

/// A direction in the map in which a point looks for its horizon.
struct HorizonDirection {
  float cosine = 1, sine = 0;
  std::vector<HorizonStep> steps;  ///< outwards
  int farSector = 0;               ///< direction of the far horizon clockwise from it
  float farFraction = 0;           ///< how near it is to the next one, 0 … 1
};

/// A lamp for a stretch of a row.
struct LampStretch {
  float x = 0, y = 0, z = 1;  ///< unit vector to it in the frame's axes
  float strength = 1;
  HorizonDirection direction;        ///< from the middle of the stretch
  std::vector<float> perShadowEdge;  ///< 1 / width of the edge of the shadow that each step casts, 1/mm
};

/// Points of a row of patches that receive light. Heights are those of HeightMap.
///
/// In the plane through the eye and a line of the map, a slope of heights along the line is a cotangent of the angle
/// from the line of sight: with the point's place s on the line (0 next to the eye) and the distance L of the eye from
/// the line, cot = (A·slope − s)/L, where A = (s² + L²)/(height + eyeDistance).
struct LightRow {
  const float *height = nullptr, *slopeX = nullptr, *slopeY = nullptr;  ///< of the row's first patch
  int row = 0, size = 0;                                                ///< its number; rows and columns of the map
  float patchMm = 0, eyeDistance = 250;
  float rightMm = 0, upMm = 0;  ///< from a patch's middle to the point
  float firstX = 0, y = 0;      ///< of the first patch's point on the QR plane
  float highest = 0;            ///< of the map
  bool isContinuous = false;    ///< whether the surface is the same on both sides of every border
  std::span<const HorizonDirection> directions;
  const float* farCotangents = nullptr;    ///< of this row of places; null: none
  std::size_t farPlaces = 0;               ///< from a direction of them to the next
  const std::int32_t* farPlace = nullptr;  ///< of each patch
};

/// Patches that are computed together at most: so many must be readable before and after each row.
inline constexpr int kMostLanes = 16;
inline constexpr int kMostDirections = 64;

/// Adds what the sky brings to the points of patches [begin, end), and what near surface alone leaves of it; `end` may
/// be rounded up to a multiple of kMostLanes.
void addSky(const LightRow& row, int begin, int end, float* sky, float* pastWalls);

/// Adds the mean luminance of the occluders, times the cosine-weighted fraction of the sky that they hide. Occluders
/// are the parts of the surface that climb along a line.
/// @param climbing  luminance of each patch; counts where the surface climbs on the patch itself
/// @param walls     half the luminance of a wall at each patch's border; the patch on the other side adds its half.
///                  Null: the surface has no walls
void addHidden(const LightRow& row, const float* climbing, const float* walls, int begin, int end, float* hidden);

/// Adds what a lamp brings to the same points, and what it brought before anything was carved.
/// @param lamp  for these patches
void addLamp(const LightRow& row, const LampStretch& lamp, int begin, int end, float* carved, float* uncarved);

}  // namespace qrelief
