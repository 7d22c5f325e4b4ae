// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/add_inlay.h"

#include "carving/embed.h"
#include "io/read_model.h"
#include "io/write_stl.h"
#include "mesh/weld.h"
#include "pipeline/engrave.h"

namespace qrelief {

Status addInlay(const EngravableModel& model, SurfaceMode surface, EngraveResult& result) {
  const Placement& placement = result.placement;
  const auto embedded = embedDepthField(model.prepared.mesh, placement.frame, placement.patch.triangles, result.depths,
                                        {.surface = surface, .inlay = true, .label = result.label});
  if (!embedded) return tl::unexpected(embedded.error());
  return setInlay(embedded->inlay, result);
}

Status setInlay(const Mesh& body, EngraveResult& result) {
  const auto read = readModel(writeStl(body), "inlay.stl");
  if (!read) return tl::unexpected(read.error());
  Mesh inlay = welded(std::vector<Vec3f>(read->positions.begin(), read->positions.end()), read->triangles);
  const auto solidity = checkSolidity(inlay);
  if (!solidity) return tl::unexpected(solidity.error());
  result.inlay = std::move(inlay);
  result.inlaySolidity = *solidity;
  return {};
}

}  // namespace qrelief
