// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_model.h"

#include "io/read_3mf.h"
#include "io/read_obj.h"
#include "io/read_off.h"
#include "io/read_ply.h"
#include "io/read_stl.h"
#include "io/sniff_format.h"

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
      return badInput(message("format-unreadable", with::term<"format">(nameOf(format))));
    case ModelFormat::Unknown:
      break;
  }
  return badInput(message("format-unknown"));
}

}  // namespace

Result<PolygonSoup> readModel(std::span<const std::uint8_t> bytes, std::string_view fileName,
                              const ReadLimits& limits) {
  if (bytes.empty()) return badInput(message("file-empty"));
  if (bytes.size() > limits.maxBytes)
    return badInput(
        message("file-too-large", with::count<"bytes">(bytes.size()), with::count<"limit">(limits.maxBytes)));
  const ModelFormat named = formatOfName(fileName);
  const ModelFormat format = formatOfContent(bytes);
  if (format == ModelFormat::Unknown)
    if (const std::string_view encoding = wideEncodingOf(bytes); !encoding.empty())
      return badInput(message("text-encoding", with::term<"encoding">(encoding)));
  if (format == ModelFormat::Unknown || format == named) return readAs(named, bytes, limits);
  Result<PolygonSoup> soup = readAs(format, bytes, limits);
  if (soup && named != ModelFormat::Unknown)
    soup->warnings.insert(soup->warnings.begin(), message("format-misnamed", with::term<"named">(nameOf(named)),
                                                          with::term<"found">(nameOf(format))));
  return soup;
}

}  // namespace qrelief
