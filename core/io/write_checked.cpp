// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_checked.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "io/read_model.h"
#include "io/three_mf/write_3mf.h"
#include "message_codes/files.h"

namespace qrelief {
namespace {

/// Compares a corner of an object that is moved. The last digit may differ: the file has the fewest digits that give
/// the number again, and their sum with the move may be rounded the other way.
bool isEqual(Vec3 read, Vec3f written, const Affine& pose) {
  constexpr double kLastDigit = std::numeric_limits<float>::epsilon();
  const Vec3 sizes = glm::abs(pose.x * static_cast<double>(written.x)) +
                     glm::abs(pose.y * static_cast<double>(written.y)) +
                     glm::abs(pose.z * static_cast<double>(written.z)) + glm::abs(pose.origin);
  const Vec3 apart = glm::abs(read - pose(Vec3(written)));
  for (int axis = 0; axis < 3; ++axis)
    if (!(apart[axis] <= kLastDigit * std::max(sizes[axis], 1e-30))) return false;
  return true;
}

/// Counts the leading triangles of the soup that equal those of the bodies, in order; all of them if the file is right.
/// Compares bit for bit, except in objects that are moved.
/// @param poses  of the objects
std::size_t countEqual(const PolygonSoup& soup, std::span<const ModelObject> objects, std::span<const Affine> poses) {
  std::size_t equal = 0;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const bool isMoved = poses[i] != Affine();
    for (const ModelBody& body : objects[i].bodies)
      for (const Triangle& triangle : body.mesh.triangles) {
        if (equal == soup.triangles.size()) return equal;
        for (std::size_t k = 0; k < 3; ++k) {
          const Vec3 read = soup.positions[soup.triangles[equal][k]];
          const Vec3f written = body.mesh.positions[triangle[k]];
          if (isMoved ? !isEqual(read, written, poses[i]) : Vec3f(read) != written) return equal;
        }
        ++equal;
      }
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
  const std::vector<Affine> poses =
      format == ModelFormat::ThreeMf ? posesOnPlate(objects, options.slicer) : std::vector<Affine>(objects.size());
  const std::size_t expected = countTriangles(objects), equal = countEqual(*soup, objects, poses);
  if (equal != expected || soup->triangles.size() != expected || soup->unitMm.value_or(1) != 1)
    return fail(ErrorKind::Internal,
                message<"write-read-differently">(with::count<"triangles">(expected), with::term<"format">(name),
                                                  with::count<"count">(equal)));
  return bytes;
}

}  // namespace qrelief
