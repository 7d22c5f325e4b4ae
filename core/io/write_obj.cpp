// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_obj.h"

#include <algorithm>
#include <fmt/compile.h>
#include <fmt/format.h>
#include <iterator>

#include "io/write_model.h"

namespace qrelief {

namespace {

/// Writes `usemtl` lines where the colour changes.
class Materials {
 public:
  /// @param isWritten  false: there is no file with materials
  Materials(std::span<const ModelObject> objects, bool isWritten)
      : colours_(isWritten ? coloursOf(objects) : std::vector<Colour>()) {}

  void use(const ModelBody& body, std::uint32_t triangle, std::vector<std::uint8_t>& bytes) {
    if (colours_.empty()) return;
    const bool isPainted =
        body.paint && std::binary_search(body.paint->triangles.begin(), body.paint->triangles.end(), triangle);
    const Colour colour = isPainted ? body.paint->colour : body.colour.value_or(colours_.front());
    if (colour == used_) return;
    used_ = colour;
    const auto number = std::find(colours_.begin(), colours_.end(), colour) - colours_.begin() + 1;
    fmt::format_to(std::back_inserter(bytes), FMT_COMPILE("usemtl colour-{}\n"), number);
  }

 private:
  std::vector<Colour> colours_;
  std::optional<Colour> used_;
};

}  // namespace

std::vector<std::uint8_t> writeObj(std::span<const ModelObject> objects, const WriteOptions& options) {
  std::vector<std::uint8_t> bytes;
  const auto out = std::back_inserter(bytes);
  fmt::format_to(out, FMT_COMPILE("# {}; millimetres\n"), oneLine(options.title));
  if (!options.materialFile.empty()) fmt::format_to(out, FMT_COMPILE("mtllib {}\n"), oneLine(options.materialFile));
  Materials materials(objects, !options.materialFile.empty());
  std::size_t first = 1;  // OBJ counts from 1, through the whole file
  for (const ModelObject& object : objects)
    for (const ModelBody& body : object.bodies) {
      const std::string name = oneLine(body.name.empty() ? object.name : body.name);
      if (!name.empty()) fmt::format_to(out, FMT_COMPILE("o {}\n"), name);
      for (const Vec3f& p : body.mesh.positions) fmt::format_to(out, FMT_COMPILE("v {} {} {}\n"), p.x, p.y, p.z);
      for (std::uint32_t t = 0; t < body.mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = body.mesh.triangles[t];
        materials.use(body, t, bytes);
        fmt::format_to(out, FMT_COMPILE("f {} {} {}\n"), first + a, first + b, first + c);
      }
      first += body.mesh.positions.size();
    }
  return bytes;
}

std::vector<std::uint8_t> writeMaterials(std::span<const ModelObject> objects) {
  std::vector<std::uint8_t> bytes;
  int number = 0;
  for (const auto& [red, green, blue] : coloursOf(objects))
    fmt::format_to(std::back_inserter(bytes), FMT_COMPILE("newmtl colour-{}\nKd {:.4f} {:.4f} {:.4f}\n"), ++number,
                   red / 255.0, green / 255.0, blue / 255.0);
  return bytes;
}

}  // namespace qrelief
