// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "math/frame.h"
#include "mesh/mesh.h"

namespace qrelief {

/// First facets that rays from a frame's eye meet, from either side, the facets sorted into bins of the QR plane.
class PlaneCaster {
 public:
  struct Hit {
    std::uint32_t triangle = 0;
    double distance = 0;  ///< from the eye, mm
    bool front = true;    ///< met from the facet's front
  };

  /// @param mesh    outlives this object
  /// @param halfMm  rays go through points of the plane's square |u|, |v| ≤ halfMm
  PlaneCaster(const Mesh& mesh, const ProjectionFrame& frame, double halfMm);

  std::optional<Hit> hit(Vec2 p) const;

  /// Distance of the first facet; infinite where there is none.
  double distance(Vec2 p) const;

  /// Whether one can walk on the surface from what is seen at `p` to what is seen at `q`: the halves of the way between
  /// lie on facets that share an edge, down to a way so short that only a step from one part to another is left.
  bool connected(Vec2 p, const Hit& atP, Vec2 q, const Hit& atQ) const;

 private:
  int bin(double x) const;

  const Mesh& mesh_;
  ProjectionFrame frame_;
  double half_;
  std::vector<std::vector<std::uint32_t>> bins_;
};

}  // namespace qrelief
