// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/add_inlay.h"

#include "carving/embed.h"
#include "io/read_model.h"
#include "io/write_stl.h"
#include "mesh/weld.h"
#include "pipeline/engrave.h"

namespace qrelief {

Status addInlay(const EngravableModel& model, EngraveResult& result) {
  const Placement& placement = result.placement;
  const auto embedded = embedDepthField(model.prepared.mesh, placement.frame, placement.patch.triangles, result.depths,
                                        {.surface = result.request.surface(), .inlay = true, .label = result.label});
  QRELIEF_TRY(embedded);
  return setInlay(embedded->inlay, result);
}

Status setInlay(const Mesh& body, EngraveResult& result) {
  const auto read = readModel(writeStl(body), "inlay.stl");
  QRELIEF_TRY(read);
  Mesh inlay = welded(std::vector<Vec3f>(read->positions.begin(), read->positions.end()), read->triangles);
  const auto solidity = checkSolidity(inlay);
  QRELIEF_TRY(solidity);
  result.inlay = std::move(inlay);
  result.inlaySolidity = *solidity;
  return {};
}

}  // namespace qrelief
