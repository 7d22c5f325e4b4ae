// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/settings.h"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pipeline/preset.h"

namespace qrelief {
namespace {

using Json = nlohmann::json;

/// Reads setting by setting; the first that cannot be used is kept as the error.
class SettingsReader {
 public:
  explicit SettingsReader(const Json& settings) : settings_(settings) {}

  void number(const char* name, double& value) {
    const Json* found = find(name);
    if (!found) return;
    if (!found->is_number() || !std::isfinite(found->get<double>())) return refuse(name, "give a number");
    value = found->get<double>();
  }
  void flag(const char* name, bool& value) {
    const Json* found = find(name);
    if (!found) return;
    if (!found->is_boolean()) return refuse(name, "give true or false");
    value = found->get<bool>();
  }
  void text(const char* name, std::string& value) {
    const Json* found = find(name);
    if (!found) return;
    if (!found->is_string()) return refuse(name, "give a text");
    value = found->get<std::string>();
  }
  /// @param byName  from the name to a std::optional of the value; a lambda: the address of a function taken before a
  ///                call of it makes Emscripten 3.1.6 declare it without parameters
  template <class T, class ByName>
  void choice(const char* name, T& value, ByName byName, const char* hint) {
    std::string chosen;
    text(name, chosen);
    if (chosen.empty()) return;
    if (const std::optional<T> known = byName(chosen))
      value = *known;
    else
      refuse(name, hint);
  }
  void size(PlacementRequest& placement) {
    const Json* found = find("size");
    if (!found) return;
    if (found->is_number()) {
      placement.sizeMode = SizeMode::Fixed;
      return number("size", placement.sizeMm);
    }
    choice(
        "size", placement.sizeMode, [](std::string_view name) { return sizeModeByName(name); },
        "Give mm, \"free\", \"oriented\" or \"best\"");
  }
  const std::optional<Error>& error() const { return error_; }

  bool has(const char* name) const { return find(name) != nullptr; }

 private:
  const Json* find(const char* name) const {
    const auto found = settings_.find(name);
    return found == settings_.end() || found->is_null() ? nullptr : &*found;
  }
  void refuse(const char* name, const char* hint) {
    if (!error_)
      error_ = Error{ErrorKind::BadUsage,
                     untold(fmt::format("the setting {} is {}", name, settings_.at(name).dump()), hint)};
  }

  const Json& settings_;
  std::optional<Error> error_;
};

}  // namespace

Result<EngraveRequest> readSettings(std::string_view json) {
  const Json settings = Json::parse(json, nullptr, false);
  if (!settings.is_object()) return fail(ErrorKind::BadUsage, "the settings are no JSON object");
  EngraveRequest request;
  SettingsReader read(settings);
  read.text("text", request.text);
  read.choice(
      "ecc", request.symbol.errorCorrection, [](std::string_view name) { return errorCorrectionByName(name); },
      "Choose L, M, Q or H");
  request.symbol.raiseErrorCorrection = !read.has("ecc");
  read.choice(
      "preset", request.preset, [](std::string_view name) { return presetByName(name); },
      "Choose shallow, balanced or robust");
  read.choice(
      "pattern", request.modulePattern, [](std::string_view name) { return modulePatternByName(name); },
      "Choose none, square, thin-plus, diamond or thick-plus");
  read.choice(
      "finderPattern", request.finderPattern, [](std::string_view name) { return finderPatternByName(name); },
      "Choose none, as-modules, diamond, thick-plus or thick-plus-sharp");
  read.size(request.placement);
  read.number("maxSizeMm", request.placement.maxSizeMm);
  read.flag("quietZone", request.placement.quietZone);
  read.choice(
      "direction", request.placement.directionMethod, [](std::string_view name) { return directionMethodByName(name); },
      "Choose mean-normal, depth-balanced, pca or optimal");
  read.number("rotateDeg", request.placement.rotateDeg);
  double contrast = 0;
  read.number("contrast", contrast);
  if (read.has("contrast")) request.contrast = contrast;
  read.number("minWallMm", request.minWallMm);
  read.number("nozzleMm", request.nozzleMm);
  read.number("layerMm", request.layerMm);
  double maxDepth = 0;
  read.number("maxDepthMm", maxDepth);
  if (maxDepth != 0) request.maxDepthMm = maxDepth;
  read.number("eyeDistanceMm", request.placement.eyeDistanceMm);
  if (read.error()) return tl::unexpected(*read.error());
  return request;
}

}  // namespace qrelief
