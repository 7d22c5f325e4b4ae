// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "study/carved_code.h"
#include "study/spot.h"

namespace qrelief::study {

/// The grooves of Kikuchi, Yoshikawa, Jayaraman, Zheng, Maekawa, "Embedding QR codes onto B-spline surfaces for 3D
/// printing", CAD 102 (2018), on a mesh: insert knots, move the control points of dark modules down until each groove
/// point is obscure enough, and keep the surface a smooth B-spline.
///
/// Only the abstract and the description in Papp 2022, §2 and §7 were available. Our choices therefore:
///   - knots: one control point a submodule; the carving depth is their uniform bicubic B-spline, as in our embedding,
///     with one depth a submodule. So grooves run out over half a module of their light neighbours, which are carved,
///     too;
///   - obscurance at a submodule's middle [Zhukov, Iones, Kronin 1998]: 1/π ∫ ρ(d) cos ω, d the distance at which a ray
///     meets the surface, ρ(d) = 1 − exp(−d/d₀), 1 where it meets nothing; d₀ = one module. Evaluated for the dark
///     submodules;
///   - wanted: obscurance ≤ (1 − contrast) of the mean over the light submodules;
///   - rays: submodules that are far too light get fewer, down to an eighth (measureUntilClear());
///   - step: a tenth of a module; limits as for the other methods.
/// Its direction of projection, by principal components, is DirectionMethod::Pca.
struct GrooveOptions {
  double contrast = 0.3;
  double falloffModules = 1;  ///< d₀
  double stepModules = 0.1;
  double maxDepthModules = kPublishedMaxDepthModules;
  std::size_t rays = 256;
  int maxPasses = 80;
  std::uint64_t seed = 1;
};

Result<CarvedCode> carveGrooves2018(const StudyPlacement& spot, const Symbol& symbol, const SubmoduleMask& mask,
                                    const GrooveOptions& options);

/// Returns the uniform bicubic B-spline at its control points: weights 1/6, 4/6, 1/6 along both axes; beyond the border
/// 0.
/// @param control  size × size, row-major
std::vector<double> bSplineValues(const std::vector<double>& control, int size);

}  // namespace qrelief::study
