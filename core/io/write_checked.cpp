// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_checked.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "io/read_model.h"
#include "io/write_3mf.h"
#include "message_codes/files.h"

namespace qrelief {
namespace {

/// Compares bit for bit. In an object with an offset the last digit may differ: the file has the fewest digits that
/// give the number again, and their sum with the offset may be rounded the other way.
bool isEqual(Vec3 read, Vec3f written, Vec3 offset) {
  if (offset == Vec3(0)) return Vec3f(read) == written;
  const Vec3 expected = Vec3(written) + offset;
  for (int axis = 0; axis < 3; ++axis) {
    constexpr double kLastDigit = std::numeric_limits<float>::epsilon();
    const double largest = std::max({std::abs(static_cast<double>(written[axis])), std::abs(offset[axis]), 1e-30});
    if (!(std::abs(read[axis] - expected[axis]) <= kLastDigit * largest)) return false;
  }
  return true;
}

/// Counts the leading triangles of the soup that equal those of the bodies, in order; all of them if the file is right.
/// @param move  of all objects
std::size_t countEqual(const PolygonSoup& soup, std::span<const ModelObject> objects, Vec3 move) {
  std::size_t equal = 0;
  for (const ModelObject& object : objects)
    for (const ModelBody& body : object.bodies)
      for (const Triangle& triangle : body.mesh.triangles) {
        if (equal == soup.triangles.size()) return equal;
        for (std::size_t k = 0; k < 3; ++k)
          if (!isEqual(soup.positions[soup.triangles[equal][k]], body.mesh.positions[triangle[k]],
                       object.offsetMm + move))
            return equal;
        ++equal;
      }
  return equal;
}

std::size_t countTriangles(std::span<const ModelObject> objects) {
  std::size_t count = 0;
  for (const ModelObject& object : objects)
    for (const ModelBody& body : object.bodies) count += body.mesh.triangles.size();
  return count;
}

}  // namespace

Result<std::vector<std::uint8_t>> writeChecked(std::span<const ModelObject> objects, ModelFormat format,
                                               const WriteOptions& options) {
  auto bytes = writeModel(objects, format, options);
  if (!bytes) return bytes;
  const std::string_view name = nameOf(format);
  const auto soup = readModel(*bytes, fmt::format("written.{}", name));
  if (!soup)
    return fail(ErrorKind::Internal,
                message<"write-not-read-back">(with::term<"format">(name), with::cause<"cause">(soup.error().message)));
  const Vec3 move = format == ModelFormat::ThreeMf ? plateMove(objects, options.slicer) : Vec3(0);
  const std::size_t expected = countTriangles(objects), equal = countEqual(*soup, objects, move);
  if (equal != expected || soup->triangles.size() != expected || soup->unitMm.value_or(1) != 1)
    return fail(ErrorKind::Internal,
                message<"write-read-differently">(with::count<"triangles">(expected), with::term<"format">(name),
                                                  with::count<"count">(equal)));
  return bytes;
}

}  // namespace qrelief
