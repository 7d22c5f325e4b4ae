// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_obj.h"

#include <fmt/compile.h>
#include <fmt/format.h>
#include <iterator>

#include "io/one_line.h"

namespace qrelief {

std::vector<std::uint8_t> writeObj(std::span<const ModelObject> objects, const WriteOptions& options) {
  std::vector<std::uint8_t> bytes;
  const auto out = std::back_inserter(bytes);
  fmt::format_to(out, FMT_COMPILE("# {}; millimetres\n"), oneLine(options.title));
  std::size_t first = 1;  // OBJ counts from 1, through the whole file
  for (const ModelObject& object : objects)
    for (const ModelBody& body : object.bodies) {
      const std::string name = oneLine(body.name.empty() ? object.name : body.name);
      if (!name.empty()) fmt::format_to(out, FMT_COMPILE("o {}\n"), name);
      for (const Vec3f& p : body.mesh.positions) fmt::format_to(out, FMT_COMPILE("v {} {} {}\n"), p.x, p.y, p.z);
      for (const auto& [a, b, c] : body.mesh.triangles)
        fmt::format_to(out, FMT_COMPILE("f {} {} {}\n"), first + a, first + b, first + c);
      first += body.mesh.positions.size();
    }
  return bytes;
}

}  // namespace qrelief
