// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/engravable_model.h"

#include <algorithm>

#include "depth/one_light_search.h"
#include "pipeline/default_patterns.h"
#include "pipeline/label_pockets.h"
#include "pipeline/mark_depth.h"
#include "pipeline/module_walls.h"
#include "projection/size_bound.h"
#include "settings/engrave_request.h"
#include "settings/settings.h"

namespace qrelief {

/// The patch must also cover the walls next to the largest possible code (see wallLimits).
PlacementRequest searchedPlacement(const EngraveRequest& request, int modules) {
  PlacementRequest place = request.placement;
  place.labelMarginModules = labelMarginModules(request.code.lettering(), modules);
  place.isText = request.code.isText();
  if (place.isText) place.quietZone = false;
  if (request.marking.mark == Mark::Paint) return place;  // needs no wall
  if (request.marking.mark == Mark::Inlay) {
    const double depth = request.marking.markDepthMm.value_or(deepestInlayMm(request.print.printer));
    place.beyondMm = request.depth.minWallMm + depth;
    place.pockets = {request.depth.minWallMm, 0, depth};
    return place;
  }
  if (place.isText) {
    const double depth = kLabelLayers * request.print.printer.layerMm;
    place.beyondMm = request.depth.minWallMm + depth;
    place.pockets = {request.depth.minWallMm, 0, depth};
    return place;
  }
  const double largest = place.sizeMode == SizeMode::Fixed ? place.sizeMm : place.maxSizeMm;
  place.beyondMm = request.depth.minWallMm + request.depth.maxDepthMm.value_or(kMaxDepthModules * largest / modules);
  const double contrast = request.depth.contrastAsked();
  if (contrast <= 0 || contrast >= 1) return place;  // later refused
  const double depth = request.isForOneLight() ? shadowDepth(contrast, request.lamps().front()) : pitDepth(contrast);
  place.pockets = {request.depth.minWallMm, depth};
  return place;
}

Status checkEngraving(const EngravableModel& model, const EngraveRequest& request, const Symbol& symbol) {
  QRELIEF_TRY(checkSettings(request));
  QRELIEF_TRY(model.prepared.engravable());
  const LabelOptions label = request.code.lettering();
  const auto layout = layOutLabel(label, symbol.size);
  QRELIEF_TRY(layout);
  const PlacementRequest& place = request.placement;
  const SizeBound room{symbol.size, roomFactor(symbol.size, searchedPlacement(request, symbol.size))};
  QRELIEF_TRY(checkSizeBound(model.prepared, room, place.eyeDistanceMm));
  const double askedMm = place.sizeMode == SizeMode::Fixed ? place.sizeMm : place.maxSizeMm;
  const double mostMm = squareBoundMm(model.box, place.eyeDistanceMm) / room.outer;
  return checkStrokes(label, *layout, symbol.size, std::min(askedMm, mostMm));
}

std::shared_ptr<const EngravableModel> EngravableModel::create(PreparedModel prepared,
                                                               std::shared_ptr<const GeometryPass> pass,
                                                               Device device) {
  auto model = std::make_shared<EngravableModel>();
  model->prepared = std::move(prepared);
  const Mesh& mesh = model->prepared.mesh;
  model->box = boundingBox(mesh);
  model->raster = std::make_shared<const SurfaceRaster>(mesh, model->prepared.clusters);
  model->renderer = model->raster;
  if (!pass) return model;
  model->gpu = std::make_shared<const GpuSurface>(std::move(pass), GpuMesh(mesh, model->prepared.normals));
  if (device == Device::Gpu || (device == Device::Faster && !gl::isSoftware(gl::rendererName())))
    model->renderer = model->gpu;
  return model;
}

std::shared_ptr<const EngravableModel> EngravableModel::upload(PreparedModel prepared) {
  auto pass = GeometryPass::create();
  return create(std::move(prepared), pass ? std::make_shared<const GeometryPass>(std::move(*pass)) : nullptr);
}

}  // namespace qrelief
