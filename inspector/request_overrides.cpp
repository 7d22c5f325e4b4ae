// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspector/request_overrides.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "inspector/translation.h"

namespace qrelief {
namespace {

using R = EngraveRequest;

// In the order of the enumerators.
constexpr const char* kDirections[] = {"mean normal", "depth-balanced", "principal axes", "optimal"};
constexpr const char* kSizes[] = {"free", "oriented", "best", "fixed"};
constexpr const char* kPatterns[] = {"none", "square", "thin plus", "diamond", "thick plus"};
constexpr const char* kFinders[] = {"none", "as modules", "diamond", "thick plus", "thick plus, sharp"};
constexpr const char* kLevels[] = {"L", "M", "Q", "H"};
constexpr const char* kMaskRules[] = {"standard", "shadiest", "fixed"};
constexpr const char* kObjectives[] = {"contrast", "reading"};
constexpr const char* kSolvers[] = {"fast", "paper's steps"};
constexpr const char* kSurfaces[] = {"preserved", "resampled"};

/// @param part  lambda from a request, constant or not, to the part of it that is tuned
template <class Part>
Tunable number(const char* group, const char* name, const char* unit, double least, double most, double step, Part) {
  Tunable made{group, name, unit, least, most, step};
  made.read = [](const R& r) { return static_cast<double>(Part{}(r)); };
  made.write = [](R& r, double v) { Part{}(r) = static_cast<std::decay_t<decltype(Part{}(r))>>(v); };
  return made;
}

template <class Part>
Tunable choice(const char* group, const char* name, std::span<const char* const> names, Part part) {
  Tunable made = number(group, name, "", 0, static_cast<double>(names.size() - 1), 1, part);
  made.choices = names;
  return made;
}

template <class Part>
Tunable onOff(const char* group, const char* name, Part) {
  Tunable made{group, name, ""};
  made.isSwitch = true;
  made.read = [](const R& r) { return Part{}(r) ? 1.0 : 0.0; };
  made.write = [](R& r, double v) { Part{}(r) = v != 0; };
  return made;
}

/// 0 stands for what is not given.
template <class Part>
Tunable optional(const char* group, const char* name, const char* unit, double most, double step, Part) {
  Tunable made{group, name, unit, 0, most, step};
  made.read = [](const R& r) { return static_cast<double>(Part{}(r).value_or(0)); };
  made.write = [](R& r, double v) {
    Part{}(r).reset();
    if (v > 0) Part{}(r) = static_cast<typename std::decay_t<decltype(Part{}(r))>::value_type>(v);
  };
  return made;
}

template <std::size_t Lamp, double DirectionalLight::*Part>
Tunable lamp(const char* name, const char* unit, double least, double most, double step) {
  Tunable made{"Light", name, unit, least, most, step};
  made.read = [](const R& r) {
    static const DirectionalLight kOff = {.strength = 0};
    return (Lamp < r.lights.size() ? r.lights[Lamp] : kOff).*Part;
  };
  made.write = [](R& r, double v) {
    while (r.lights.size() <= Lamp) r.lights.push_back({.strength = 0});
    r.lights[Lamp].*Part = v;
  };
  return made;
}

/// That of the preset, until one is set.
Tunable contrastTunable() {
  Tunable made{"Depth", "contrast", "", 0.01, 0.95, 0.01};
  made.read = [](const R& r) { return r.contrastAsked(); };
  made.write = [](R& r, double v) { r.contrast = v; };
  return made;
}

std::vector<Tunable> makeTunables() {
  Tunable direction = choice(
      "Placement", "direction", kDirections, [](auto& r) -> auto& { return r.placement.directionMethod; });
  direction.write = [](R& r, double v) {
    r.placement.directionMethod = static_cast<DirectionMethod>(v);
    r.placement.direction.reset();  // that of a suggested spot
  };
  return {
      direction,
      choice(
          "Placement", "size", kSizes, [](auto& r) -> auto& { return r.placement.sizeMode; }),
      number(
          "Placement", "fixed size", "mm", 0, 1000, 1, [](auto& r) -> auto& { return r.placement.sizeMm; }),
      number(
          "Placement", "greatest size", "mm", 1, 1000, 1, [](auto& r) -> auto& { return r.placement.maxSizeMm; }),
      onOff(
          "Placement", "room for the quiet zone", [](auto& r) -> auto& { return r.placement.quietZone; }),
      number(
          "Placement", "rotation", "°", -360, 360, 5, [](auto& r) -> auto& { return r.placement.rotateDeg; }),
      number(
          "Placement", "eye distance", "mm", 20, 1e5, 10, [](auto& r) -> auto& { return r.placement.eyeDistanceMm; }),
      choice(
          "Depth", "objective", kObjectives, [](auto& r) -> auto& { return r.objective; }),
      choice(
          "Depth", "solver", kSolvers, [](auto& r) -> auto& { return r.solver; }),
      contrastTunable(),
      number(
          "Depth", "layer", "mm", 0.01, 1, 0.01, [](auto& r) -> auto& { return r.layerMm; }),
      optional(
          "Depth", "deepest, 0 = auto", "mm", 100, 0.1, [](auto& r) -> auto& { return r.maxDepthMm; }),
      number(
          "Depth", "wall left", "mm", 0, 100, 0.1, [](auto& r) -> auto& { return r.minWallMm; }),
      number(
          "Reading objective", "data contrast", "", 0.01, 0.95, 0.01,
          [](auto& r) -> auto& { return r.reading.dataContrast; }),
      number(
          "Reading objective", "finder contrast", "", 0.01, 0.95, 0.01,
          [](auto& r) -> auto& { return r.reading.finderContrast; }),
      number(
          "Reading objective", "blur", "modules", 0.05, 2, 0.05,
          [](auto& r) -> auto& { return r.reading.blurModules; }),
      number(
          "Reading objective", "tolerance", "", 0.001, 0.1, 0.001,
          [](auto& r) -> auto& { return r.reading.tolerance; }),
      number(
          "Reading objective", "most passes", "", 1, 60, 1, [](auto& r) -> auto& { return r.reading.maxPasses; }),
      number(
          "Light", "albedo", "", 0, 0.95, 0.05, [](auto& r) -> auto& { return r.albedo; }),
      lamp<0, &DirectionalLight::strength>("lamp 1 strength", "skies", 0, 1000, 0.25),
      lamp<0, &DirectionalLight::azimuthDeg>("lamp 1 azimuth", "°", -360, 360, 15),
      lamp<0, &DirectionalLight::elevationDeg>("lamp 1 elevation", "°", 1, 90, 5),
      lamp<1, &DirectionalLight::strength>("lamp 2 strength", "skies", 0, 1000, 0.25),
      lamp<1, &DirectionalLight::azimuthDeg>("lamp 2 azimuth", "°", -360, 360, 15),
      lamp<1, &DirectionalLight::elevationDeg>("lamp 2 elevation", "°", 1, 90, 5),
      choice(
          "Symbol", "module pattern", kPatterns, [](auto& r) -> auto& { return r.modulePattern; }),
      choice(
          "Symbol", "finder pattern", kFinders, [](auto& r) -> auto& { return r.finderPattern; }),
      choice(
          "Symbol", "error correction", kLevels, [](auto& r) -> auto& { return r.symbol.errorCorrection; }),
      onOff(
          "Symbol", "raise it if free", [](auto& r) -> auto& { return r.symbol.raiseErrorCorrection; }),
      optional(
          "Symbol", "version, 0 = smallest", "", 40, 1, [](auto& r) -> auto& { return r.symbol.version; }),
      choice(
          "Symbol", "mask rule", kMaskRules, [](auto& r) -> auto& { return r.symbol.maskRule; }),
      number(
          "Symbol", "fixed mask", "", 0, 7, 1, [](auto& r) -> auto& { return r.symbol.mask; }),
      onOff(
          "Symbol", "break up dark areas", [](auto& r) -> auto& { return r.symbol.breakUpDarkAreas; }),
      choice(
          "Making", "surface", kSurfaces, [](auto& r) -> auto& { return r.surface; }),
      number(
          "Making", "nozzle, for advice", "mm", 0.01, 10, 0.05, [](auto& r) -> auto& { return r.nozzleMm; }),
  };
}

}  // namespace

std::span<const Tunable> tunables() {
  static const std::vector<Tunable> kAll = makeTunables();
  return kAll;
}

RequestOverrides::RequestOverrides() : values_(tunables().size()) {}

void RequestOverrides::set(std::size_t index, double value, const EngraveRequest& page) {
  const Tunable& tunable = tunables()[index];
  const double pages = tunable.read(page);
  if (!std::isfinite(value)) return;
  value = std::clamp(value, tunable.least, tunable.most);
  values_[index] = std::abs(value - pages) < 1e-6 ? std::optional<double>() : value;  // floats pass through doubles
}

void RequestOverrides::resetAll() { values_.assign(values_.size(), std::nullopt); }

std::size_t RequestOverrides::count() const {
  return static_cast<std::size_t>(std::count_if(values_.begin(), values_.end(), [](const auto& v) { return bool(v); }));
}

double RequestOverrides::valueOf(std::size_t index, const EngraveRequest& page) const {
  return values_[index].value_or(tunables()[index].read(page));
}

EngraveRequest RequestOverrides::appliedTo(EngraveRequest page) const {
  for (std::size_t i = 0; i < values_.size(); ++i)
    if (values_[i]) tunables()[i].write(page, *values_[i]);
  std::erase_if(page.lights, [](const DirectionalLight& light) { return light.strength == 0; });
  return page;
}

std::string RequestOverrides::describe() const {
  std::string text;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    if (!values_[i]) continue;
    const Tunable& tunable = tunables()[i];
    const double value = *values_[i];
    text += text.empty() ? "" : ", ";
    if (tunable.isSwitch)
      text += fmt::format("{} {}", translated(tunable.name), translated(value != 0 ? "on" : "off"));
    else if (!tunable.choices.empty())
      text +=
          fmt::format("{} {}", translated(tunable.name), translated(tunable.choices[static_cast<std::size_t>(value)]));
    else
      text += fmt::format("{} {:g}{}{}", translated(tunable.name), value,
                          *tunable.unit && *tunable.unit != '\xc2' ? " " : "", translated(tunable.unit));
  }
  return text;
}

}  // namespace qrelief
