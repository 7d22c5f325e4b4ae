// SPDX-License-Identifier: GPL-3.0-or-later
#include "delivery/carved_file.h"

#include "delivery/carved_objects.h"
#include "delivery/changed_3mf_runs.h"
#include "io/three_mf/rewrite_3mf.h"
#include "io/write_checked.h"
#include "message_codes/files.h"
#include "pipeline/engrave.h"

namespace qrelief {
namespace {

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
  const bool withInlay = result.request.marking.hasInlay();
  if (format == ModelFormat::Stl && !options.ascii && !(withInlay && result.inlay) && result.painted.empty())
    return CarvedFiles{{{fileName, result.stl}}, {}};
  if (format == ModelFormat::ThreeMf) {
    auto written = writeCarved3mf(before, result, partNames, withInlay, options);
    QRELIEF_TRY(written);
    return CarvedFiles{{{fileName, std::move(written->bytes)}}, std::move(written->notKept)};
  }
  auto files =
      writeCheckedFiles(carvedObjects(result, partNames, withInlay, format == ModelFormat::Obj), fileName, options);
  QRELIEF_TRY(files);
  return CarvedFiles{std::move(*files), {}};
}

}  // namespace qrelief
