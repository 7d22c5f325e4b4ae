// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace qrelief {

/// A patch border on the way from a receiver to its horizon, the same for all patches.
struct HorizonStep {
  std::int32_t patch = 0;            ///< index of the patch behind the border, from the receiver's own
  std::int32_t column = 0, row = 0;  ///< that patch's offset in columns to the right and in rows up
  float rightMm = 0, upMm = 0;       ///< from that patch's middle to the border
  float perMm = 0;                   ///< 1 / distance from the receiving point
  float fromBefore = 0.5f;  ///< position of the border between the middles of the patch before and this patch, 0 … 1
};

/// A direction in the map in which a point looks for its horizon.
struct HorizonDirection {
  float cosine = 1, sine = 0;
  std::vector<HorizonStep> steps;  ///< outwards
  int farSector = 0;               ///< next direction of the far horizon clockwise
  float farFraction = 0;           ///< position between that direction and the one after it, 0 … 1
};

/// A lamp as seen from a stretch of a row.
struct LampStretch {
  float x = 0, y = 0, z = 1;  ///< unit vector to the lamp in the frame's axes
  float strength = 1;
  HorizonDirection direction;        ///< from the middle of the stretch
  std::vector<float> perShadowEdge;  ///< 1 / width of the edge of each step's shadow, 1/mm
};

/// A flat piece of the surface in each patch of a row, with heights and slopes as in HeightMap.
struct PieceRow {
  const float *height = nullptr, *slopeX = nullptr, *slopeY = nullptr;  ///< from the row's first patch on
};

/// Receiving points in a row of patches.
///
/// In the plane through the eye and a line of the map, a slope of heights along the line corresponds to a cotangent of
/// the angle from the line of sight. With the point's position s on the line (0 next to the eye) and the distance L of
/// the eye from the line, cot = (A·slope − s)/L, where A = (s² + L²)/(height + eyeDistance).
struct LightRow {
  PieceRow patches;       ///< what hides light
  PieceRow receivers;     ///< hold the points: the patches, or one quarter of each
  int row = 0, size = 0;  ///< number of the row; number of rows and columns of the map
  float patchMm = 0, eyeDistance = 250;
  float rightMm = 0, upMm = 0;  ///< from the middle of a receiver to its point
  float firstX = 0, y = 0;      ///< position of the first patch's point on the QR plane
  float highest = 0;            ///< greatest height of the map
  bool isContinuous = false;    ///< true if the surface is the same on both sides of every border
  std::span<const HorizonDirection> directions;
  const float* farCotangents = nullptr;    ///< far horizon of this row of places; null: none
  std::size_t farPlaces = 0;               ///< number of values from one direction to the next
  const std::int32_t* farPlace = nullptr;  ///< place of each patch
};

/// Greatest number of patches computed together; so many values must be readable before and after each row.
inline constexpr int kMostLanes = 16;
inline constexpr int kMostDirections = 64;

/// Adds the light of the sky at the points of patches [begin, end), and the part of it that near surface alone leaves;
/// `end` may be rounded up to a multiple of kMostLanes.
void addSky(const LightRow& row, int begin, int end, float* sky, float* pastWalls);

/// Adds the mean luminance of the occluders, times the cosine-weighted fraction of the sky that they hide. Occluders
/// are the parts of the surface that climb along a line.
/// @param climbing  luminance of each patch; used where the surface climbs on the patch itself
/// @param walls     half the luminance of a wall at each patch's border; the patch on the other side adds its half.
///                  Null: the surface has no walls
void addHidden(const LightRow& row, const float* climbing, const float* walls, int begin, int end, float* hidden);

/// Adds a lamp's light at the same points, with carving and without.
/// @param lamp  for these patches
void addLamp(const LightRow& row, const LampStretch& lamp, int begin, int end, float* carved, float* uncarved);

}  // namespace qrelief
