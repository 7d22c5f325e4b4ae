// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_model.h"

#include <algorithm>
#include <array>
#include <vector>

#include "io/polygon_list.h"
#include "io/read_obj.h"
#include "io/read_off.h"
#include "io/read_ply.h"
#include "io/read_stl.h"
#include "io/sniff_format.h"
#include "io/three_mf/read_3mf.h"
#include "io/zip_archive.h"
#include "message_codes/files.h"

namespace qrelief {
namespace {

Result<PolygonSoup> readAs(ModelFormat format, std::span<const std::uint8_t> bytes, const ReadLimits& limits) {
  switch (format) {
    case ModelFormat::Stl:
      return readStl(bytes, limits);
    case ModelFormat::Obj:
      return readObj(bytes, limits);
    case ModelFormat::Ply:
      return readPly(bytes, limits);
    case ModelFormat::Off:
      return readOff(bytes, limits);
    case ModelFormat::ThreeMf:
      return read3mf(bytes, limits);
    case ModelFormat::Gltf:
      return badInput(message<"format-unreadable">(with::term<"format">(nameOf(format))));
    case ModelFormat::Unknown:
      break;
  }
  return badInput(message<"format-unknown">());
}

constexpr std::size_t kNamesListed = 5;

/// Returns the names of the first files of an archive, for a message.
std::string listed(const std::vector<const ZipEntry*>& files) {
  std::string names;
  for (std::size_t i = 0; i < std::min(files.size(), kNamesListed); ++i)
    names += (i > 0 ? ", " : "") + excerpt(files[i]->name);
  return names + (files.size() > kNamesListed ? ", ..." : "");
}

/// Returns true for a path with a hidden file or folder. "." and ".." are steps on the way, not hidden.
bool isHidden(std::string_view path) {
  while (!path.empty()) {
    const std::string_view step = path.substr(0, path.find_first_of("/\\"));
    if (step.starts_with('.') && step != "." && step != "..") return true;
    path.remove_prefix(std::min(step.size() + 1, path.size()));
  }
  return false;
}

/// Returns the files of an archive that people put there. macOS adds others, and hidden files.
std::vector<const ZipEntry*> filesIn(const ZipArchive& archive) {
  std::vector<const ZipEntry*> files = archive.files();
  std::erase_if(files,
                [](const ZipEntry* file) { return file->name.starts_with("__MACOSX/") || isHidden(file->name); });
  return files;
}

/// Files that are archives, too, by a file that they hold.
struct ArchiveFormat {
  std::string_view file, format;
  bool isCad;
};
constexpr std::array<ArchiveFormat, 6> kArchiveFormats = {{{"xl/workbook.xml", "Excel", false},
                                                           {"word/document.xml", "Word", false},
                                                           {"ppt/presentation.xml", "PowerPoint", false},
                                                           {"META-INF/manifest.xml", "OpenDocument", false},
                                                           {"Document.xml", "FreeCAD", true},
                                                           {"Manifest.dat", "Fusion", true}}};

/// Reads a 3MF. A slicer writes its G-code into one that has no model any more.
Result<PolygonSoup> readPackage(const ZipArchive& archive, std::span<const std::uint8_t> bytes,
                                const ReadLimits& limits) {
  Result<PolygonSoup> soup = readAs(ModelFormat::ThreeMf, bytes, limits);
  const std::vector<const ZipEntry*> files = archive.files();
  const bool isSliced =
      std::any_of(files.begin(), files.end(), [](const ZipEntry* file) { return file->name.ends_with(".gcode"); });
  if (!soup && isSliced) return badInput(message<"3mf-sliced">());
  return soup;
}

/// Reads a 3MF, or the only model of another ZIP archive.
Result<PolygonSoup> readArchive(const ZipArchive& archive, std::span<const std::uint8_t> bytes,
                                const ReadLimits& limits) {
  for (const auto& [file, format, isCad] : kArchiveFormats)
    if (archive.find(file))
      return badInput(isCad ? message<"format-of-cad">(with::term<"format">(format))
                            : message<"file-is-document">(with::term<"format">(format)));
  const std::vector<const ZipEntry*> files = filesIn(archive);
  if (archive.find("_rels/.rels") || archive.find("3D/3dmodel.model")) return readPackage(archive, bytes, limits);
  std::vector<const ZipEntry*> models = files;
  std::erase_if(models, [](const ZipEntry* file) {
    const ModelFormat format = formatOfName(file->name);
    return format == ModelFormat::Unknown || format == ModelFormat::Gltf;
  });
  if (files.empty()) return badInput(message<"zip-empty">());
  if (models.empty())
    return badInput(message<"zip-no-model">(with::count<"count">(files.size()), with::quoted<"files">(listed(files))));
  if (models.size() > 1)
    return badInput(
        message<"zip-several-models">(with::count<"count">(models.size()), with::quoted<"files">(listed(models))));
  const auto content = unpacked(*models[0], std::min<std::uint64_t>(limits.maxBytes, limits.maxExpandedBytes));
  QRELIEF_TRY(content);
  // A ZIP within a ZIP may be a 3MF only: an archive can contain itself.
  const ModelFormat format = formatOfContent(*content);
  Result<PolygonSoup> soup =
      readAs(format == ModelFormat::Unknown ? formatOfName(models[0]->name) : format, *content, limits);
  if (soup)
    soup->warnings.insert(soup->warnings.begin(), message<"zip-read">(with::quoted<"file">(excerpt(models[0]->name))));
  return soup;
}

Result<PolygonSoup> readZip(std::span<const std::uint8_t> bytes, const ReadLimits& limits) {
  const Result<ZipArchive> archive = ZipArchive::open(bytes);
  QRELIEF_TRY(archive);
  Result<PolygonSoup> soup = readArchive(*archive, bytes, limits);
  if (soup && archive->trailingBytes() > 0)
    soup->warnings.push_back(message<"zip-trailing-bytes">(with::count<"count">(archive->trailingBytes())));
  return soup;
}

}  // namespace

Result<PolygonSoup> readModel(std::span<const std::uint8_t> bytes, std::string_view fileName,
                              const ReadLimits& limits) {
  if (bytes.empty()) return badInput(message<"file-empty">());
  if (bytes.size() > limits.maxBytes)
    return badInput(
        message<"file-too-large">(with::count<"bytes">(bytes.size()), with::count<"limit">(limits.maxBytes)));
  const ModelFormat named = formatOfName(fileName);
  const ModelFormat format = formatOfContent(bytes);
  if (format == ModelFormat::Unknown)
    if (const std::string_view encoding = wideEncodingOf(bytes); !encoding.empty())
      return badInput(message<"text-encoding">(with::term<"encoding">(encoding)));
  if (format == ModelFormat::Unknown)
    if (std::optional<Message> what = identifyFile(bytes)) return badInput(std::move(*what));
  if (format == ModelFormat::Unknown) return readAs(named, bytes, limits);
  const bool isZip = format == ModelFormat::ThreeMf;
  Result<PolygonSoup> soup = isZip ? readZip(bytes, limits) : readAs(format, bytes, limits);
  const bool isOther = format != named && named != ModelFormat::Unknown && !(isZip && soup && !soup->source);
  if (soup && isOther)
    soup->warnings.insert(soup->warnings.begin(), message<"format-misnamed">(with::term<"named">(nameOf(named)),
                                                                             with::term<"found">(nameOf(format))));
  return soup;
}

}  // namespace qrelief
