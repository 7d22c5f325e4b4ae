// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <numbers>
#include <vector>

#include "math/frame.h"
#include "mesh/mesh.h"

namespace qrelief {

/// Triangles that lie near one another, the box around them, and the cone of their normals [Shirman, Abi-Ezzi 1993].
struct TriangleCluster {
  Box3 box;
  std::uint32_t begin = 0, end = 0;  ///< range among the reordered triangles
  Vec3 axis{0, 0, 1};                ///< unit; of the cone
  double spread = std::numbers::pi;  ///< greatest angle between axis and a normal, rounded up; at most π

  /// Return true only if all triangles face away from the eye, or if all face it.
  bool facesAwayFrom(Vec3 eye) const { return turnsTo(eye, axis); }
  bool faces(Vec3 eye) const { return turnsTo(eye, -axis); }

 private:
  bool turnsTo(Vec3 eye, Vec3 awayFromEye) const;
};

/// A mesh's triangles, ordered so that neighbours in space are neighbours in memory.
struct ClusteredTriangles {
  std::vector<Triangle> triangles;        ///< the mesh's triangles; in their old order within a cluster
  std::vector<std::uint32_t> origins;     ///< index of each in the mesh
  std::vector<TriangleCluster> clusters;  ///< contiguous, none empty
};

/// Clusters triangles by a uniform grid over the mesh's box, a few hundred triangles per cell. Cost: O(T).
ClusteredTriangles clusterTriangles(const Mesh& mesh);

/// Returns all triangles as one cluster, for a mesh that is drawn only once or twice: clustering would cost more.
ClusteredTriangles oneCluster(const Mesh& mesh);

/// The part of space that the eye sees through a square on the QR plane, bounded by four planes through the eye.
class ViewPyramid {
 public:
  /// @param extentMm  edge of the square, sides along the frame's axes, > 0
  ViewPyramid(const ProjectionFrame& frame, double extentMm);

  /// Returns false only if no point of the box lies in the pyramid. Near the pyramid's edges it may return true for a
  /// box outside.
  bool mayMeet(const Box3& box) const;

 private:
  Vec3 eye_;
  std::array<Vec3, 4> inwards_;
};

}  // namespace qrelief
