// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/lamp_reading.h"

#include "native/zxing_decoder.h"
#include "study/carved_surface.h"
#include "verdict/verdict.h"

namespace qrelief::study {
namespace {

constexpr int kPixelsPerModule = 8, kMarginModules = 6;

}  // namespace

Result<int> readsUnder(const StudyPlacement& spot, const CarvedCode& code,
                       const std::vector<DirectionalLight>& lights) {
  const auto surface = CarvedSurface::make(spot, code.depths);
  QRELIEF_TRY(surface);
  const GpuMesh carved(surface->mesh(), vertexNormals(surface->mesh()));
  const int across = code.symbol.size + 2 * kMarginModules;
  ReaderViewOptions options;
  options.extentMm = spot.placement.moduleMm * across;
  options.texels = kPixelsPerModule * across;
  options.reliefMm = static_cast<float>(summarise(code.depths).maxMm);
  options.radiusMm = 8 * options.reliefMm;
  options.lights = lights;
  auto view = renderReaderView(*spot.pass, carved, spot.placement.frame, options);
  QRELIEF_TRY(view);
  view->pixelsPerModule = kPixelsPerModule;
  return evidenceOf(readFrontal(*view), spot.request.code.text).count.reads;
}

}  // namespace qrelief::study
