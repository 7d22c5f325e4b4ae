// SPDX-License-Identifier: GPL-3.0-or-later
#include "delivery/carved_file.h"

#include <algorithm>
#include <cmath>

#include "delivery/carved_objects.h"
#include "io/three_mf/rewrite_3mf.h"
#include "io/write_checked.h"
#include "io/write_stl.h"
#include "message_codes/files.h"
#include "pipeline/engrave.h"

namespace qrelief {
namespace {

bool isUnderCode(const Placement& place, Vec3 point) {
  if (place.frame.distanceAlongAxis(point) <= 0) return false;
  const Vec2 p = place.frame.project(point);
  return std::max(std::abs(p.x), std::abs(p.y)) <= place.symbolMm / 2;
}

/// Returns the attributes that each facet keeps: none under the code.
std::vector<KeptAttributes> keptAttributes(const PreparedModel& before, const EngraveResult& result) {
  using What = KeptAttributes::What;
  using Kind = FacetOrigin::Kind;
  std::vector<char> isSeen(before.mesh.triangles.size(), 0);
  for (const std::uint32_t t : result.placement.patch.triangles) isSeen[t] = 1;
  std::vector<KeptAttributes> attributes(result.mesh.triangles.size());
  for (std::size_t t = 0; t < attributes.size(); ++t) {
    const FacetOrigin& origin = result.origins[t];
    if (origin.kind != Kind::Kept && origin.kind != Kind::Piece) continue;
    if (origin.facet == FacetOrigin::kNoFacet) continue;
    const Vec3 middle = (result.mesh.corner(t, 0) + result.mesh.corner(t, 1) + result.mesh.corner(t, 2)) / 3.0;
    if (isSeen[origin.facet] && isUnderCode(result.placement, middle)) continue;
    attributes[t] = {origin.kind == Kind::Kept ? What::All : What::WholePaint, before.originOfTriangle[origin.facet]};
  }
  return attributes;
}

/// Returns the runs of a 3MF file whose meshes have changed: the carved body, and bodies that repairs changed. Facets
/// and their pieces keep their attributes, except under the code.
/// Cost: O(T).
/// @param before   model before carving, with its 3MF source
std::vector<ChangedRun> changed3mfRuns(const PreparedModel& before, const EngraveResult& result, bool withInlay) {
  const ThreeMfSource& source = *before.source;
  const std::vector<KeptAttributes> attributes = keptAttributes(before, result);
  std::vector<std::uint32_t> runs;
  for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) runs.push_back(result.mesh.body(t));
  std::vector<ChangedRun> changes;
  for (std::uint32_t r = 0; r < source.runs.size(); ++r) {
    if (r != result.carvedBody && !before.wasRepaired[r]) continue;
    ChangedRun change;
    change.run = r;
    const std::vector<std::uint32_t> triangles = trianglesOf(runs, r);
    change.mesh = submesh(result.mesh, triangles);
    for (const std::uint32_t t : triangles) change.kept.push_back(attributes[t]);
    change.painted = placesIn(triangles, result.painted);
    if (r == result.carvedBody && withInlay && result.inlay) change.inlay = codeBody(*result.inlay);
    changes.push_back(std::move(change));
  }
  return changes;
}

Result<std::vector<std::uint8_t>> writeAgain(const PreparedModel& before, const EngraveResult& result, bool withInlay,
                                             const WriteOptions& options) {
  const ThreeMfSource& source = *before.source;
  if (before.scaleToMm != source.unitMm) return fail(ErrorKind::NoSolution, message<"rewrite-scaled">());
  if (options.palette) return fail(ErrorKind::NoSolution, message<"rewrite-palette">());
  return rewrite3mf(source, changed3mfRuns(before, result, withInlay), options.slicer, filamentMaterials(),
                    result.request.print.buildUp.resolve(result.placement.frame));
}

}  // namespace

Result<Carved3mf> writeCarved3mf(const PreparedModel& before, const EngraveResult& result,
                                 std::span<const std::string> partNames, bool withInlay, const WriteOptions& options) {
  std::optional<Message> notKept;
  if (before.source) {
    auto bytes = writeAgain(before, result, withInlay, options);
    if (bytes) return Carved3mf{std::move(*bytes), {}};
    if (bytes.error().kind != ErrorKind::NoSolution) return tl::unexpected(bytes.error());
    notKept = std::move(bytes.error().message);
  }
  auto bytes = writeChecked(carvedObjects(result, partNames, withInlay, true), ModelFormat::ThreeMf, options);
  QRELIEF_TRY(bytes);
  return Carved3mf{std::move(*bytes), std::move(notKept)};
}

Result<CarvedFiles> encodeCarved(const PreparedModel& before, const EngraveResult& result, const std::string& fileName,
                                 std::span<const std::string> partNames, const WriteOptions& options) {
  const ModelFormat format = formatOfName(fileName);
  const bool withInlay = result.request.marking.mark == Mark::Inlay;
  CarvedFiles carved;  // an initializer list would copy the bytes once more
  if (format == ModelFormat::Stl && !options.ascii && !(withInlay && result.inlay) && result.painted.empty()) {
    carved.files.push_back({fileName, writeStl(result.mesh)});
    return carved;
  }
  if (format == ModelFormat::ThreeMf) {
    auto written = writeCarved3mf(before, result, partNames, withInlay, options);
    QRELIEF_TRY(written);
    carved.files.push_back({fileName, std::move(written->bytes)});
    carved.notKept = std::move(written->notKept);
    return carved;
  }
  auto files =
      writeCheckedFiles(carvedObjects(result, partNames, withInlay, format == ModelFormat::Obj), fileName, options);
  QRELIEF_TRY(files);
  carved.files = std::move(*files);
  return carved;
}

}  // namespace qrelief
