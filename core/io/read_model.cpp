// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_model.h"

#include <fmt/format.h>

#include "io/read_3mf.h"
#include "io/read_obj.h"
#include "io/read_off.h"
#include "io/read_ply.h"
#include "io/read_stl.h"
#include "io/sniff_format.h"

namespace qrelief {
namespace {

constexpr std::string_view kSupported = "STL, OBJ, PLY, OFF and 3MF files can be read";

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
      return fail(ErrorKind::BadInput, fmt::format("{} files cannot be read yet", nameOf(format)),
                  fmt::format("{}; export the model as one of these", kSupported));
    case ModelFormat::Unknown:
      break;
  }
  return fail(ErrorKind::BadInput, "The file's format is not known, neither by its name nor by its content",
              std::string(kSupported));
}

}  // namespace

Result<PolygonSoup> readModel(std::span<const std::uint8_t> bytes, std::string_view fileName,
                              const ReadLimits& limits) {
  if (bytes.empty()) return fail(ErrorKind::BadInput, "The file is empty (0 bytes)", "Copy or export it again");
  if (bytes.size() > limits.maxBytes)
    return fail(ErrorKind::BadInput,
                fmt::format("The file has {} bytes; at most {} are accepted", bytes.size(), limits.maxBytes),
                "Reduce (decimate) the model first, or save it in a binary format");
  const ModelFormat named = formatOfName(fileName);
  const ModelFormat found = formatOfContent(bytes);
  if (found == ModelFormat::Unknown || found == named) return readAs(named, bytes, limits);
  Result<PolygonSoup> soup = readAs(found, bytes, limits);
  if (soup && named != ModelFormat::Unknown)
    soup->warnings.insert(soup->warnings.begin(),
                          fmt::format("The file is named as {}, but its content is {}; it was read "
                                      "as {}",
                                      nameOf(named), nameOf(found), nameOf(found)));
  return soup;
}

}  // namespace qrelief
