// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "projection/size_map.h"
#include "render/gpu_mesh.h"

namespace qrelief {

/// The model in the colours of its size map, for the viewer: values 0 … 1 of the sizes, smoothed over about as far
/// as the map is fine. Where the map cut long edges of the model, its mesh is shown, as it has more vertices.
/// @param leastMm  smaller sizes are 0, as if nothing fitted there
/// @param topMm    size that is 1, > 0
GpuMesh heatMesh(const Mesh& model, const SizeMap& map, double leastMm, double topMm);

}  // namespace qrelief
