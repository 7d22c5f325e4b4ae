// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace qrelief {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Vec3f = glm::vec3;

inline double cross2(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

}  // namespace qrelief
