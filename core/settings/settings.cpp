// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/settings.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <type_traits>

#include "settings/engrave_request.h"
#include "settings/preset.h"
#include "settings/setting_text.h"

namespace qrelief {
namespace {

using R = EngraveRequest;
using V = SettingValue;
using Kind = Setting::Kind;

constexpr double kMaxMm = 1e4;       // largest edge: no printer is larger
constexpr double kMaxWallMm = 1000;  // largest wall and largest depth

struct Range {
  double min, max, step;
};

/// Returns the names of an enumeration's first `count` values.
/// @param nameOf  a lambda: if the address of a function is taken before its first call, Emscripten 3.1.6 declares it
///                without parameters
template <class NameOf>
std::vector<std::string> namesOf(int count, NameOf nameOf) {
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i) names.emplace_back(nameOf(i));
  return names;
}

std::vector<std::string> sizeModeNames() {  // without Fixed, which is given as a number
  return namesOf(3, [](int i) { return sizeModeName(static_cast<SizeMode>(i)); });
}

std::vector<std::string> directionMethodNames() {
  return namesOf(5, [](int i) { return directionMethodName(static_cast<DirectionMethod>(i)); });
}

std::vector<std::string> buildPoseNames() {
  return namesOf(3, [](int i) { return buildPoseName(static_cast<BuildPose>(i)); });
}

std::vector<std::string> modulePatternNames() {
  return namesOf(5, [](int i) { return modulePatternName(static_cast<ModulePattern>(i)); });
}

std::size_t indexIn(const std::vector<std::string>& names, const V& value) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), std::get<std::string>(value)) - names.begin());
}

Setting made(const char* key, const char* group, Kind kind) {
  Setting setting;
  setting.key = key;
  setting.group = group;
  setting.kind = kind;
  return setting;
}

/// Makes a setting for a number.
/// @param Part  lambda from a request, constant or not, to the field that is set
template <class Part>
Setting number(const char* key, const char* group, Unit unit, Range range, Part) {
  Setting setting = made(key, group, Kind::Number);
  setting.unit = unit;
  setting.min = range.min, setting.max = range.max, setting.step = range.step;
  setting.isWhole = std::is_same_v<std::decay_t<decltype(Part{}(std::declval<R&>()))>, int>;
  setting.read = [](const R& r) -> V {
    const auto value = Part{}(r);
    // Gives the digits of the float, not of the double: 0.7f is 0.7.
    if constexpr (std::is_same_v<decltype(value), const float>)
      return std::round(static_cast<double>(value) * 1e6) / 1e6;
    else
      return static_cast<double>(value);
  };
  setting.write = [](R& r, const V& v) {
    Part{}(r) = static_cast<std::decay_t<decltype(Part{}(r))>>(std::get<double>(v));
  };
  return setting;
}

/// Makes a setting for a number that may be left out.
template <class Part>
Setting optionalNumber(const char* key, const char* group, Unit unit, Range range, Part) {
  using Number = typename std::decay_t<decltype(Part{}(std::declval<R&>()))>::value_type;
  Setting setting = made(key, group, Kind::Number);
  setting.unit = unit;
  setting.min = range.min, setting.max = range.max, setting.step = range.step;
  setting.isWhole = std::is_same_v<Number, int>;
  setting.mayBeEmpty = true;
  setting.read = [](const R& r) -> V { return Part{}(r) ? V(static_cast<double>(*Part{}(r))) : V(); };
  setting.write = [](R& r, const V& v) {
    Part{}(r).reset();
    if (const double* n = std::get_if<double>(&v)) Part{}(r) = static_cast<Number>(*n);
  };
  return setting;
}

template <class Part>
Setting toggle(const char* key, const char* group, Part) {
  Setting setting = made(key, group, Kind::Switch);
  setting.read = [](const R& r) -> V { return Part{}(r); };
  setting.write = [](R& r, const V& v) { Part{}(r) = std::get<bool>(v); };
  return setting;
}

/// Makes a setting for a choice.
/// @param Names  lambda to the names in the order of the enumerators
template <class Part, class Names>
Setting choice(const char* key, const char* group, Part, Names) {
  Setting setting = made(key, group, Kind::Choice);
  setting.choices = Names{}();
  setting.read = [](const R& r) -> V { return Names{}()[static_cast<std::size_t>(Part{}(r))]; };
  setting.write = [](R& r, const V& v) {
    Part{}(r) = static_cast<std::decay_t<decltype(Part{}(r))>>(indexIn(Names{}(), v));
  };
  return setting;
}

/// Makes a setting for a choice that "auto" leaves to the program.
template <class Part, class Names>
Setting choiceOrAuto(const char* key, const char* group, Part, Names) {
  Setting setting = made(key, group, Kind::Choice);
  setting.choices = Names{}();
  setting.choices.insert(setting.choices.begin(), "auto");
  setting.read = [](const R& r) -> V {
    const auto chosen = Part{}(r);
    return chosen ? Names{}()[static_cast<std::size_t>(*chosen)] : std::string("auto");
  };
  setting.write = [](R& r, const V& v) {
    Part{}(r).reset();
    using Choice = typename std::decay_t<decltype(Part{}(r))>::value_type;
    if (std::get<std::string>(v) != "auto") Part{}(r) = static_cast<Choice>(indexIn(Names{}(), v));
  };
  return setting;
}

Setting text() {
  Setting setting = made("text", "symbol", Kind::Text);
  setting.read = [](const R& r) -> V { return r.code.text; };
  setting.write = [](R& r, const V& v) { r.code.text = std::get<std::string>(v); };
  return setting;
}

Setting content() {
  Setting setting = choice(
      "content", "symbol", [](auto& r) -> auto& { return r.code.content; },
      [] { return namesOf(2, [](int i) { return contentName(static_cast<Content>(i)); }); });
  return setting;
}

Setting label() {
  Setting setting = made("label", "making", Kind::Text);
  setting.read = [](const R& r) -> V { return r.code.label.text; };
  setting.write = [](R& r, const V& v) { r.code.label.text = std::get<std::string>(v); };
  return setting;
}

Setting frame() {
  Setting setting = choice(
      "frame", "making", [](auto& r) -> auto& { return r.code.label.frame; },
      [] { return namesOf(3, [](int i) { return labelFrameName(static_cast<LabelFrame>(i)); }); });
  return setting;
}

/// Makes the setting for error correction. A level given by its letter is exact.
Setting errorCorrection() {
  Setting setting = made("ecc", "symbol", Kind::Choice);
  setting.choices = namesOf(4, [](int i) { return errorCorrectionName(static_cast<ErrorCorrection>(i)); });
  setting.choices.insert(setting.choices.begin(), "auto");
  setting.read = [](const R& r) -> V {
    const bool isAuto = r.code.symbol.raiseErrorCorrection && r.code.symbol.errorCorrection == ErrorCorrection::M;
    return isAuto ? "auto" : std::string(errorCorrectionName(r.code.symbol.errorCorrection));
  };
  setting.write = [](R& r, const V& v) {
    const auto level = errorCorrectionByName(std::get<std::string>(v));
    r.code.symbol.errorCorrection = level.value_or(ErrorCorrection::M);
    r.code.symbol.raiseErrorCorrection = !level;
  };
  return setting;
}

Setting mask() {
  Setting setting = made("mask", "symbol", Kind::ChoiceOrNumber);
  setting.choices = {"auto", "shadiest"};
  setting.min = 0, setting.max = 7, setting.step = 1;
  setting.isWhole = true;
  setting.read = [](const R& r) -> V {
    if (r.code.symbol.maskRule == MaskRule::Fixed) return static_cast<double>(r.code.symbol.mask);
    return std::string(r.code.symbol.maskRule == MaskRule::Shadiest ? "shadiest" : "auto");
  };
  setting.write = [](R& r, const V& v) {
    if (const double* n = std::get_if<double>(&v)) {
      r.code.symbol.maskRule = MaskRule::Fixed;
      r.code.symbol.mask = static_cast<int>(*n);
    } else {
      r.code.symbol.maskRule = std::get<std::string>(v) == "shadiest" ? MaskRule::Shadiest : MaskRule::Standard;
    }
  };
  return setting;
}

Setting eci() {
  Setting setting = choice(
      "eci", "symbol", [](auto& r) -> auto& { return r.code.symbol.eci; },
      [] { return namesOf(2, [](int i) { return eciUseName(static_cast<EciUse>(i)); }); });
  return setting;
}

/// Makes the setting for the pattern, which also drops a pattern of one's own. This comes later in the list.
Setting pattern() {
  Setting setting = choiceOrAuto(
      "pattern", "depth", [](auto& r) -> auto& { return r.code.modulePattern; }, [] { return modulePatternNames(); });
  setting.write = [](R& r, const V& v) {
    const std::vector<std::string> names = modulePatternNames();
    r.code.ownPattern.reset();
    r.code.modulePattern.reset();
    if (std::get<std::string>(v) != "auto") r.code.modulePattern = static_cast<ModulePattern>(indexIn(names, v));
  };
  return setting;
}

Setting patternMask() {
  Setting setting = made("patternMask", "depth", Kind::Mask);
  setting.mayBeEmpty = true;
  setting.read = [](const R& r) -> V { return r.code.ownPattern ? V(moduleMaskText(*r.code.ownPattern)) : V(); };
  setting.write = [](R& r, const V& v) {
    r.code.ownPattern.reset();
    if (const std::string* text = std::get_if<std::string>(&v)) r.code.ownPattern = moduleMaskFromText(*text);
  };
  return setting;
}

/// Makes the setting for contrast. If left out, it follows the preset.
Setting contrast() {
  Setting setting = optionalNumber(
      "contrast", "depth", Unit::None, {0.01, 0.99, 0.01}, [](auto& r) -> auto& { return r.depth.contrast; });
  setting.otherwise = [](const R& r) { return r.depth.contrastAsked(); };
  return setting;
}

Setting carveFor() {
  Setting setting = choice(
      "carveFor", "depth", [](auto& r) -> auto& { return r.depth.carveFor; },
      [] {
        return std::vector<std::string>{"design", "print"};
      });
  return setting;
}

std::vector<std::string> markNames() {
  return namesOf(3, [](int i) { return markName(static_cast<Mark>(i)); });
}

Setting mark() {
  Setting setting = made("mark", "mark", Kind::Choice);
  setting.choices = markNames();
  setting.choices.insert(setting.choices.begin(), "auto");
  setting.read = [](const R& r) -> V {
    return r.marking.isOpen ? std::string("auto") : std::string(markName(r.marking.mark));
  };
  setting.write = [](R& r, const V& v) {
    r.marking.isOpen = std::get<std::string>(v) == "auto";
    r.marking.mark = r.marking.isOpen ? Mark::Shadow : static_cast<Mark>(indexIn(markNames(), v));
  };
  return setting;
}

Setting markDepth() {
  Setting setting = optionalNumber(
      "markDepthMm", "mark", Unit::Millimetre, {0.05, kMaxWallMm, 0.05},
      [](auto& r) -> auto& { return r.marking.markDepthMm; });
  return setting;
}

/// Makes the setting for the model's reflectance. If left out, it follows the mark.
Setting albedo() {
  Setting setting = optionalNumber(
      "albedo", "mark", Unit::None, {0.01, 0.95, 0.05}, [](auto& r) -> auto& { return r.marking.albedo; });
  setting.otherwise = [](const R& r) { return r.marking.surfaceAlbedo(); };
  return setting;
}

Setting objective() {
  Setting setting = choice(
      "objective", "depth", [](auto& r) -> auto& { return r.depth.objective; },
      [] { return namesOf(2, [](int i) { return depthObjectiveName(static_cast<DepthObjective>(i)); }); });
  return setting;
}

Setting size() {
  Setting setting = made("size", "placement", Kind::ChoiceOrNumber);
  setting.choices = sizeModeNames();
  setting.unit = Unit::Millimetre;
  setting.min = 0.1, setting.max = kMaxMm, setting.step = 1;
  setting.usual = 35;
  setting.read = [](const R& r) -> V {
    if (r.placement.sizeMode == SizeMode::Fixed) return r.placement.sizeMm;
    return std::string(sizeModeName(r.placement.sizeMode));
  };
  setting.write = [](R& r, const V& v) {
    if (const double* mm = std::get_if<double>(&v)) {
      r.placement.sizeMode = SizeMode::Fixed;
      r.placement.sizeMm = *mm;
    } else {
      r.placement.sizeMode = static_cast<SizeMode>(indexIn(sizeModeNames(), v));
    }
  };
  return setting;
}

Setting direction() {
  Setting setting = made("direction", "placement", Kind::ChoiceOrVector);
  setting.choices = directionMethodNames();
  setting.read = [](const R& r) -> V {
    if (r.placement.direction) return *r.placement.direction;
    return std::string(directionMethodName(r.placement.directionMethod));
  };
  setting.write = [](R& r, const V& v) {
    r.placement.direction.reset();  // drops the direction of a suggested spot, too
    if (const Vec3* vector = std::get_if<Vec3>(&v))
      r.placement.direction = *vector;
    else
      r.placement.directionMethod = static_cast<DirectionMethod>(indexIn(directionMethodNames(), v));
  };
  return setting;
}

Setting up() {
  Setting setting = made("up", "placement", Kind::Vector);
  setting.read = [](const R& r) -> V { return r.placement.upHint; };
  setting.write = [](R& r, const V& v) { r.placement.upHint = std::get<Vec3>(v); };
  return setting;
}

std::vector<std::string> processNames() {
  std::vector<std::string> names = {"none"};
  for (const NamedPrinter& named : namedPrinters()) names.emplace_back(named.name);
  return names;
}

/// Makes the setting for the process, which also sets nozzle, layer and line width. These come later in the list.
Setting process() {
  Setting setting = made("process", "printing", Kind::Choice);
  setting.choices = processNames();
  setting.read = [](const R& r) -> V { return processNames()[r.print.process ? *r.print.process + 1 : 0]; };
  setting.write = [](R& r, const V& v) {
    const std::size_t chosen = indexIn(processNames(), v);
    r.print.process.reset();
    if (chosen == 0) return;
    r.print.process = chosen - 1;
    r.print.printer = namedPrinters()[chosen - 1].printer;
  };
  return setting;
}

Setting lineWidth() {
  Setting setting = optionalNumber(
      "lineWidthMm", "printing", Unit::Millimetre, {0.01, 10, 0.05},
      [](auto& r) -> auto& { return r.print.printer.lineWidthMm; });
  return setting;
}

Setting buildUp() {
  Setting setting = made("buildUp", "printing", Kind::ChoiceOrVector);
  setting.choices = buildPoseNames();
  setting.read = [](const R& r) -> V {
    if (r.print.buildUp.up) return *r.print.buildUp.up;
    return std::string(buildPoseName(r.print.buildUp.pose));
  };
  setting.write = [](R& r, const V& v) {
    r.print.buildUp = {};
    if (const Vec3* vector = std::get_if<Vec3>(&v))
      r.print.buildUp.up = *vector;
    else
      r.print.buildUp.pose = static_cast<BuildPose>(indexIn(buildPoseNames(), v));
  };
  return setting;
}

Setting lamps() {
  Setting setting = made("light", "light", Kind::Lamps);
  setting.read = [](const R& r) -> V { return r.depth.lights; };
  setting.write = [](R& r, const V& v) { r.depth.lights = std::get<std::vector<DirectionalLight>>(v); };
  return setting;
}

std::vector<Setting> makeSettings() {
  const auto mm = Unit::Millimetre;
  return {
      text(),
      content(),
      errorCorrection(),
      optionalNumber(
          "version", "symbol", Unit::None, {1, 40, 1}, [](auto& r) -> auto& { return r.code.symbol.version; }),
      mask(),
      eci(),
      mark(),
      markDepth(),
      albedo(),
      number(
          "darkReflectance", "mark", Unit::None, {0.01, 1, 0.05},
          [](auto& r) -> auto& { return r.marking.darkReflectance; }),
      choice(
          "preset", "depth", [](auto& r) -> auto& { return r.depth.preset; },
          [] { return namesOf(3, [](int i) { return presetName(static_cast<Preset>(i)); }); }),
      toggle(
          "keepPreset", "depth", [](auto& r) -> auto& { return r.depth.keepPreset; }),
      pattern(),
      patternMask(),
      choiceOrAuto(
          "finderPattern", "depth", [](auto& r) -> auto& { return r.code.finderPattern; },
          [] { return namesOf(5, [](int i) { return finderPatternName(static_cast<FinderPattern>(i)); }); }),
      contrast(),
      carveFor(),
      objective(),
      choice(
          "solver", "depth", [](auto& r) -> auto& { return r.depth.solver; },
          [] {
            return std::vector<std::string>{"fast", "paper-steps"};
          }),
      optionalNumber(
          "maxDepthMm", "depth", mm, {0.1, kMaxWallMm, 0.1}, [](auto& r) -> auto& { return r.depth.maxDepthMm; }),
      number(
          "minWallMm", "depth", mm, {0, kMaxWallMm, 0.1}, [](auto& r) -> auto& { return r.depth.minWallMm; }),
      size(),
      number(
          "maxSizeMm", "placement", mm, {0.1, kMaxMm, 1}, [](auto& r) -> auto& { return r.placement.maxSizeMm; }),
      toggle(
          "quietZone", "placement", [](auto& r) -> auto& { return r.placement.quietZone; }),
      up(),
      number(
          "rotateDeg", "placement", Unit::Degree, {-360, 360, 5},
          [](auto& r) -> auto& { return r.placement.rotateDeg; }),
      direction(),
      number(
          "eyeDistanceMm", "placement", mm, {20, 1e5, 10}, [](auto& r) -> auto& { return r.placement.eyeDistanceMm; }),
      lamps(),
      choice(
          "surface", "making", [](auto& r) -> auto& { return r.depth.surface; },
          [] { return namesOf(2, [](int i) { return surfaceModeName(static_cast<SurfaceMode>(i)); }); }),
      label(),
      frame(),
      process(),
      number(
          "nozzleMm", "printing", mm, {0.01, 10, 0.05}, [](auto& r) -> auto& { return r.print.printer.nozzleMm; }),
      number(
          "layerMm", "printing", mm, {0.01, 1, 0.01}, [](auto& r) -> auto& { return r.print.printer.layerMm; }),
      lineWidth(),
      buildUp(),
  };
}

}  // namespace

std::span<const LampPart> lampParts() {
  static constexpr std::array<LampPart, 3> kParts = {{
      {"azimuthDeg", Unit::Degree, -360, 360, 15, &DirectionalLight::azimuthDeg},
      {"elevationDeg", Unit::Degree, 0.1, 90, 5, &DirectionalLight::elevationDeg},
      {"strength", Unit::Sky, 0, 1000, 0.25, &DirectionalLight::strength},
  }};
  return kParts;
}

std::span<const Setting> settings() {
  static const std::vector<Setting> kAll = makeSettings();
  return kAll;
}

const Setting* findSetting(std::string_view key) {
  for (const Setting& setting : settings())
    if (setting.key == key) return &setting;
  return nullptr;
}

void apply(const SettingChange& change, EngraveRequest& request) {
  const Setting* setting = findSetting(change.setting);
  assert(setting && (setting->kind == Setting::Kind::Text || setting->takesChoice() || setting->takesNumber()));
  const auto value = valueFromText(*setting, std::vector{change.value});
  assert(value);
  setting->write(request, *value);
}

const char* contentName(Content content) { return content == Content::Code ? "code" : "text"; }

const char* depthObjectiveName(DepthObjective objective) {
  constexpr std::array<const char*, 2> kNames = {"contrast", "one-light"};
  return kNames[static_cast<std::size_t>(objective)];
}

EngraveRequest defaultRequest() {
  EngraveRequest request;
  request.code.symbol.raiseErrorCorrection = true;
  request.depth.carveFor = CarveFor::Print;
  return request;
}

}  // namespace qrelief
