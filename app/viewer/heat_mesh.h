// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "projection/size_map.h"
#include "render/gpu_mesh.h"

namespace qrelief {

/// Returns the model in the colours of its size map, for the viewer: sizes as values 0 … 1, smoothed over about one
/// edge of the map's mesh. Where the map has cut long edges of the model, returns the map's mesh, as it has more
/// vertices.
/// @param leastMm  smaller sizes are 0, as if no code fitted there
/// @param topMm    size that is 1, > 0
GpuMesh heatMesh(const Mesh& model, const SizeMap& map, double leastMm, double topMm);

/// Returns the model in two colours: 1 where the map has room for this size, 0 elsewhere. The sizes are smoothed as in
/// heatMesh().
/// @param sizeMm  > 0
GpuMesh fitMesh(const Mesh& model, const SizeMap& map, double sizeMm);

}  // namespace qrelief
