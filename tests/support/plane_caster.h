// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "math/frame.h"
#include "mesh/mesh.h"

namespace qrelief {

/// Casts rays from a frame's eye and finds the first facet they meet, from either side. The facets are sorted into bins
/// of the QR plane.
class PlaneCaster {
 public:
  struct Hit {
    std::uint32_t triangle = 0;
    double distance = 0;  ///< from the eye, mm
    bool front = true;    ///< the ray met the facet's front
  };

  /// @param mesh    outlives this object
  /// @param halfMm  rays go through points of the plane's square |u|, |v| ≤ halfMm
  PlaneCaster(const Mesh& mesh, const ProjectionFrame& frame, double halfMm);

  std::optional<Hit> hit(Vec2 p) const;

  /// Returns the distance of the first facet; infinite if there is none.
  double distance(Vec2 p) const;

  /// Returns true if the surface connects the point seen at `p` with the point seen at `q`. Halves the path until
  /// neighbouring points lie on facets that share an edge (connected), or until it is so short that it must step from
  /// one part to another (not connected).
  bool connected(Vec2 p, const Hit& atP, Vec2 q, const Hit& atQ) const;

 private:
  int bin(double x) const;

  const Mesh& mesh_;
  ProjectionFrame frame_;
  double half_;
  std::vector<std::vector<std::uint32_t>> bins_;
};

}  // namespace qrelief
