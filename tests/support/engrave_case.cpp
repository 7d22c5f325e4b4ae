// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/engrave_case.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "support/shapes.h"

// Every decision has its own statement: C++ leaves the evaluation order of arguments and operands open, and a seed must
// mean the same with every compiler.
namespace qrelief {
namespace {

Mesh scaledRadially(Mesh mesh, Choices& choices, double share) {
  for (Vec3f& p : mesh.positions) p = Vec3f(Vec3(p) * (1 + choices.between(-share, share)));
  return mesh;
}

Mesh sphere(Choices& choices) {
  const double radius = choices.between(12.0, 60.0);
  return shapes::icosphere(radius, choices.between(2, 4));
}

Mesh bumpy(Choices& choices) {
  const double radius = choices.between(15.0, 60.0);
  const double amplitude = radius * choices.between(0.005, 0.12);
  const int waves = choices.between(1, 6);
  return shapes::bumpySphere(radius, amplitude, waves, choices.between(3, 4));
}

/// Returns a sphere with random radii. It is star-shaped for any numbers, so it never crosses itself.
Mesh noisy(Choices& choices) {
  const int level = choices.between(2, 4);
  const double radius = choices.between(15.0, 60.0), share = choices.between(0.002, 0.24 / (1 << level));
  return scaledRadially(shapes::icosphere(radius, level), choices, share);
}

Mesh lowPoly(Choices& choices) {
  if (choices.oneIn(4)) return shapes::tetrahedron(choices.between(30.0, 120.0));
  const double radius = choices.between(15.0, 60.0), share = choices.between(0.0, 0.3);
  return scaledRadially(shapes::icosphere(radius, choices.between(0, 1)), choices, share);
}

Mesh torus(Choices& choices) {
  const double tube = choices.between(4.0, 25.0), axis = tube + choices.between(2.0, 40.0);
  const int aroundAxis = choices.between(8, 64);
  return shapes::torus(axis, tube, aroundAxis, choices.between(6, 40));
}

Mesh box(Choices& choices) {
  const double x = choices.between(10.0, 90.0), y = choices.between(10.0, 90.0), z = choices.between(2.0, 90.0);
  return shapes::box({x, y, z});
}

Mesh saddle(Choices& choices) {
  const double edge = choices.between(30.0, 100.0);
  const double rise = choices.between(-0.3, 0.3) * edge, fall = choices.between(-0.3, 0.3) * edge;
  const int n = choices.between(2, 40);
  return shapes::plate({edge, edge}, 0.32 * edge, n, n,
                       [=](double x, double y) { return (rise * x * x + fall * y * y) / (edge * edge); });
}

Mesh thinPlate(Choices& choices) {
  const double edge = choices.between(25.0, 90.0), thickness = choices.between(0.3, 4.0);
  const int columns = choices.between(1, 12);
  return shapes::plate({edge, edge}, thickness, columns, choices.between(1, 12));
}

/// Returns steep steps: creases, and parts that lean over the plane of a tilted code.
Mesh terraces(Choices& choices) {
  const double edge = choices.between(40.0, 90.0), step = choices.between(0.2, 8.0);
  const double wide = choices.between(5.0, 30.0), thickness = choices.between(3.0, 20.0);
  const int n = choices.between(6, 24);
  return shapes::plate({edge, edge}, thickness, n, n,
                       [=](double x, double) { return step * std::floor(std::abs(x) / wide); });
}

/// Returns a plate whose grid lines lie in close pairs: needles everywhere.
Mesh slivers(Choices& choices) {
  const double edge = choices.between(30.0, 90.0), gap = std::pow(10.0, choices.between(-5.0, -1.0));
  const double thickness = choices.between(3.0, 20.0);
  const int n = 2 * choices.between(2, 8);
  Mesh mesh = shapes::plate({edge, edge}, thickness, n, 2 * choices.between(1, 6));
  const double cell = edge / n;
  for (Vec3f& p : mesh.positions) {
    const auto line = static_cast<int>(std::lround((static_cast<double>(p.x) + edge / 2) / cell));
    if (line % 2 == 1 && line < n) p.x = static_cast<float>(-edge / 2 + (line - 1) * cell + gap);
  }
  return mesh;
}

Mesh cylinder(Choices& choices) {
  const double radius = choices.between(5.0, 40.0), height = choices.between(5.0, 90.0);
  return shapes::cylinder(radius, height, choices.oneIn(3) ? choices.between(100, 700) : choices.between(3, 60));
}

Mesh thinShell(Choices& choices) {
  const double radius = choices.between(15.0, 50.0), wall = choices.between(0.3, 4.0);
  const int level = choices.between(1, 4);
  return shapes::together(shapes::icosphere(radius, level), shapes::insideOut(shapes::icosphere(radius - wall, level)));
}

Mesh cavities(Choices& choices) {
  const double radius = choices.between(20.0, 50.0);
  Mesh mesh = shapes::icosphere(radius, 4);
  for (int k = choices.between(1, 3); k > 0; --k) {
    const double hole = radius * choices.between(0.05, 0.2), below = radius * choices.between(0.06, 0.3);
    const Vec3 at = Vec3(k == 1, k == 2, k == 3) * (radius - hole - below);
    mesh = shapes::together(mesh, shapes::insideOut(shapes::translated(shapes::icosphere(hole, 2), at)));
  }
  return mesh;
}

/// Returns two bodies next to each other, close or far apart, one perhaps in front of the other.
Mesh severalShells(Choices& choices) {
  const double first = choices.between(20.0, 50.0), second = choices.between(5.0, 50.0);
  const Vec3 offset{(first + second) / 2 + choices.between(0.05, 10.0), choices.between(-10.0, 10.0),
                    choices.between(-20.0, 20.0)};
  const Mesh other = choices.oneIn(2) ? shapes::box(Vec3(second)) : shapes::icosphere(second / 2, 2);
  return shapes::together(shapes::box(Vec3(first)), shapes::translated(other, offset));
}

Mesh overlapping(Choices& choices) {
  const double radius = choices.between(15.0, 40.0);
  const double other = radius * choices.between(0.4, 1.0), away = radius * choices.between(0.7, 1.2);
  return shapes::together(shapes::icosphere(radius, 3), shapes::translated(shapes::icosphere(other, 3), {away, 0, 0}));
}

/// Returns a star-shaped body with deep dents, where it hides parts of itself.
Mesh dented(Choices& choices) {
  Mesh mesh = shapes::icosphere(1, 4);
  const double radius = choices.between(20.0, 50.0), dent = choices.between(0.2, 0.7);
  const double waves = choices.between(1, 3);
  for (Vec3f& p : mesh.positions) {
    const Vec3 d(p);
    p = Vec3f(d * radius * (1 - dent * std::pow(std::sin(waves * std::atan2(d.y, d.x)) * (1 - d.z * d.z), 2)));
  }
  return mesh;
}

Mesh torn(Choices& choices) {
  Mesh mesh = box(choices);
  mesh.triangles.erase(mesh.triangles.begin() + choices.between(0, 11));
  return mesh;
}

struct Shape {
  const char* name;
  Mesh (*make)(Choices&);
  std::uint32_t weight;
};

constexpr std::array kShapes = {Shape{"sphere", sphere, 2},      Shape{"bumpy sphere", bumpy, 2},
                                Shape{"noisy body", noisy, 2},   Shape{"low-poly body", lowPoly, 2},
                                Shape{"torus", torus, 2},        Shape{"box", box, 2},
                                Shape{"saddle", saddle, 2},      Shape{"thin plate", thinPlate, 2},
                                Shape{"terraces", terraces, 2},  Shape{"slivers", slivers, 2},
                                Shape{"cylinder", cylinder, 2},  Shape{"thin shell", thinShell, 2},
                                Shape{"cavities", cavities, 2},  Shape{"several shells", severalShells, 2},
                                Shape{"dented body", dented, 2}, Shape{"overlapping", overlapping, 1},
                                Shape{"torn box", torn, 1}};

const Shape& chosenShape(Choices& choices) {
  std::uint32_t total = 0;
  for (const Shape& shape : kShapes) total += shape.weight;
  std::uint32_t drawn = choices.below(total);
  std::size_t k = 0;
  for (; drawn >= kShapes[k].weight; ++k) drawn -= kShapes[k].weight;
  return kShapes[k];
}

Vec3 unitVector(Choices& choices) {
  const double z = choices.between(-1.0, 1.0), angle = choices.between(0.0, 2 * std::numbers::pi);
  const double across = std::sqrt(std::max(0.0, 1 - z * z));
  return {across * std::cos(angle), across * std::sin(angle), z};
}

/// Turns the mesh about any axis and moves it, sometimes far enough to coarsen the coordinates.
Mesh moved(Mesh mesh, Choices& choices) {
  if (choices.oneIn(2)) return mesh;
  const Vec3 axis = unitVector(choices);
  const double angle = choices.between(0.0, 2 * std::numbers::pi);
  const double away = choices.oneIn(4) ? choices.between(0.0, 2000.0) : 0.0;
  const Vec3 offset = unitVector(choices) * away;
  for (Vec3f& p : mesh.positions) {
    const Vec3 q(p);
    const Vec3 turned = q * std::cos(angle) + glm::cross(axis, q) * std::sin(angle) +
                        axis * (glm::dot(axis, q) * (1 - std::cos(angle)));
    p = Vec3f(turned + offset);
  }
  return mesh;
}

struct Spot {
  Vec3 centre, normal;
};

Spot chosenSpot(const Mesh& mesh, Choices& choices) {
  const std::size_t t = choices.below(static_cast<std::uint32_t>(mesh.triangles.size()));
  const int first = choices.between(0, 2);
  const Vec3 a = mesh.corner(t, first), b = mesh.corner(t, (first + 1) % 3), c = mesh.corner(t, (first + 2) % 3);
  const Vec3 cross = glm::cross(b - a, c - a);
  const Vec3 normal = glm::length(cross) > 0 ? glm::normalize(cross) : Vec3(0, 0, 1);
  switch (choices.below(8)) {
    case 0:
      return {a, normal};
    case 1:
      return {(a + b) * 0.5, normal};
    case 2:
      return {a + (b - a) * choices.between(0.0, 1.0), normal};
    case 3: {
      const double away = choices.between(0.0, 5.0);
      return {(a + b + c) / 3.0 + unitVector(choices) * away, normal};
    }
    default: {
      const double x = choices.between(0.0, 1.0), y = choices.between(0.0, 1.0);
      const Vec3 inside = x + y <= 1 ? a + (b - a) * x + (c - a) * y : b + c - a + (a - b) * x + (a - c) * y;
      return {inside, normal};
    }
  }
}

std::string chosenText(Choices& choices) {
  static constexpr std::array<std::string_view, 4> kAlphabets = {
      "0123456789", "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 $%*+-./:", "abcdefghijklmnopqrstuvwxyz/.:-0123456789",
      "aZ9 !\"'<>&~"};
  const std::string_view alphabet = choices.of(kAlphabets);
  std::string text;
  for (int k = choices.oneIn(8) ? choices.between(1, 60) : choices.between(1, 16); k > 0; --k)
    text += alphabet[choices.below(static_cast<std::uint32_t>(alphabet.size()))];
  if (choices.oneIn(10)) text += "\xc3\xa9\xe2\x82\xac";      // "é€"
  if (text.find_first_not_of(' ') == text.npos) text += '.';  // a text that nobody sees is refused as empty
  return text;
}

constexpr std::array kLevels = {ErrorCorrection::L, ErrorCorrection::M, ErrorCorrection::Q, ErrorCorrection::H};
constexpr std::array kSizeModes = {SizeMode::Fixed, SizeMode::Free, SizeMode::Oriented, SizeMode::Best};
constexpr std::array kMethods = {DirectionMethod::DepthBalanced, DirectionMethod::MeanNormal, DirectionMethod::Pca,
                                 DirectionMethod::Optimal, DirectionMethod::Largest};
constexpr std::array kSurfaceModes = {SurfaceMode::Preserved, SurfaceMode::Resampled};
constexpr std::array kModulePatterns = {ModulePattern::Square, ModulePattern::None, ModulePattern::ThinPlus,
                                        ModulePattern::Diamond, ModulePattern::ThickPlus};
constexpr std::array kFinderPatterns = {FinderPattern::ThickPlus, FinderPattern::None, FinderPattern::AsModules,
                                        FinderPattern::Diamond};

PlacementRequest chosenPlacement(const Mesh& mesh, Choices& choices) {
  const Spot spot = chosenSpot(mesh, choices);
  const Vec3 size = boundingBox(mesh).size();
  PlacementRequest place;
  place.centreMm = spot.centre;
  place.sizeMode = choices.of(kSizeModes);
  place.sizeMm = choices.between(0.08, 0.7) * std::max({size.x, size.y, size.z});
  if (choices.oneIn(4)) place.maxSizeMm = choices.between(4.0, 40.0);
  place.quietZone = !choices.oneIn(3);
  place.rotateDeg = choices.oneIn(2) ? choices.between(-360.0, 360.0) : 0.0;
  if (choices.oneIn(4)) place.upHint = choices.oneIn(3) ? spot.normal : unitVector(choices);
  place.directionMethod = choices.of(kMethods);
  if (choices.oneIn(3)) {
    const double tilt = choices.between(0.0, 0.6);
    place.direction = spot.normal + unitVector(choices) * tilt;
  }
  if (choices.oneIn(20)) place.direction = unitVector(choices);
  if (choices.oneIn(3)) place.eyeDistanceMm = 20 * std::pow(10.0, choices.between(0.0, 2.5));
  return place;
}

}  // namespace

EngraveCase makeEngraveCase(Choices& choices) {
  EngraveCase engraveCase;
  const Shape& shape = chosenShape(choices);
  engraveCase.shape = shape.name;
  engraveCase.mesh = moved(shape.make(choices), choices);
  EngraveRequest& request = engraveCase.request;
  request.placement = chosenPlacement(engraveCase.mesh, choices);
  request.code.text = chosenText(choices);
  request.code.symbol.errorCorrection = choices.of(kLevels);
  if (choices.oneIn(6)) request.code.symbol.version = choices.between(1, 5);
  request.code.modulePattern = choices.of(kModulePatterns);
  request.code.finderPattern = choices.of(kFinderPatterns);
  // The contrast is mostly below the default, because each step of the depth search costs more than all the rest.
  request.depth.contrast = choices.oneIn(6) ? choices.between(0.2, 0.5) : choices.between(0.02, 0.15);
  if (choices.oneIn(3)) request.depth.maxDepthMm = choices.between(0.1, 3.0);
  if (choices.oneIn(2)) request.depth.minWallMm = choices.between(0.0, 3.0);
  request.depth.surface = choices.of(kSurfaceModes);
  return engraveCase;
}

std::string EngraveCase::describe() const {
  const PlacementRequest& place = request.placement;
  return fmt::format(
      "{} of {} triangles, {}, {} size {:.4g} (at most {:.4g}) at ({:.6g}, {:.6g}, {:.6g}), {} bytes of text", shape,
      mesh.triangles.size(), surfaceModeName(request.depth.surface), sizeModeName(place.sizeMode), place.sizeMm,
      place.maxSizeMm, place.centreMm.x, place.centreMm.y, place.centreMm.z, request.code.text.size());
}

}  // namespace qrelief
