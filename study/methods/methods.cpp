// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/methods/methods.h"

#include <algorithm>

#include "pipeline/default_patterns.h"
#include "study/methods/by_engine.h"
#include "study/methods/groove_2018.h"
#include "study/methods/literal_2022.h"
#include "study/methods/one_light_2020.h"
#include "study/methods/reading_search.h"
#include "study/methods/self_shadow_2019.h"
#include "study/methods/shaped_floor_search.h"
#include "study/methods/symbol_flips_2019.h"

namespace qrelief::study {
namespace {

/// Our patterns, with patterned finder patterns, as where walls are thin.
constexpr ModulePattern kOurModules = ModulePattern::ThickPlus;
constexpr FinderPattern kOurFinders = FinderPattern::ThickPlusSharp;

SubmoduleMask wholeModules(const Symbol& symbol) {
  return submodulesToCarve(symbol, ModulePattern::None, FinderPattern::None);
}

Result<CarvedCode> groove2018(const StudyPlacement& spot, double contrast) {
  GrooveOptions options;
  options.contrast = contrast;
  return carveGrooves2018(spot, spot.symbol, wholeModules(spot.symbol), options);
}

Result<CarvedCode> selfShadow2019(const StudyPlacement& spot, double contrast) {
  auto symbol = symbolAtLevel(spot, ErrorCorrection::H);
  QRELIEF_TRY(symbol);
  flipModules2019(*symbol);
  SelfShadowOptions options;
  options.functionContrast = options.dataContrast = contrast;
  return carveSelfShadow2019(spot, *symbol, wholeModules(*symbol), options);
}

Result<CarvedCode> oneLight2020(const StudyPlacement& spot, double contrast) {
  auto symbol = symbolAtLevel(spot, ErrorCorrection::H);
  QRELIEF_TRY(symbol);
  breakUpRuns2020(*symbol);
  OneLightOptions options;
  options.contrast = contrast;
  return carveOneLight2020(spot, *symbol, wholeModules(*symbol), options);
}

/// Returns the spot's request with the given patterns and contrast.
EngraveRequest patterned(const StudyPlacement& spot, ModulePattern modules, FinderPattern finders, double contrast) {
  EngraveRequest request = spot.request;
  request.code.modulePattern = modules;
  request.code.finderPattern = finders;
  request.depth.contrast = contrast;
  return request;
}

/// Carves by Papp 2022 with a module pattern and its finder patterns.
auto paper2022(ModulePattern modules, FinderPattern finders) {
  return [modules, finders](const StudyPlacement& spot, double contrast) {
    EngraveRequest request = publishedRequest(spot, modules, finders);
    request.depth.contrast = contrast;
    return carveByEngine(spot, request);
  };
}

/// Carves by Papp 2022 by its words (literal_2022.h).
auto literal2022(ModulePattern modules, FinderPattern finders) {
  return [modules, finders](const StudyPlacement& spot, double contrast) {
    EngraveRequest request = publishedRequest(spot, modules, finders);
    request.depth.contrast = contrast;
    return carveLiteral2022(spot, request);
  };
}

/// Carves everywhere to the requested depth, mm, except where walls limit it.
Result<CarvedCode> evenDepth(const StudyPlacement& spot, double depthMm) {
  EngraveRequest request = patterned(spot, kOurModules, kOurFinders, 0.95);  // contrast never reached, so every depth
                                                                             // reaches its limit
  request.depth.maxDepthMm = depthMm;
  return carveByEngine(spot, request);
}

/// Carves to the least depths that a blurred picture needs (docs/decisions/0024).
Result<CarvedCode> oursReading(const StudyPlacement& spot, double contrast) {
  const ReadingOptions options{.dataContrast = contrast, .finderContrast = 1.5 * contrast};
  return carveByEngine(
      spot, patterned(spot, kOurModules, kOurFinders, contrast), nullptr,
      [options](CarvingTarget target) { return std::make_unique<ReadingSearch>(std::move(target), options); });
}

/// Carves by Papp 2021: whole modules with a tilted or a wavy floor.
auto floors2021(FloorShape shape) {
  return [shape](const StudyPlacement& spot, double contrast) {
    EngraveRequest request = patterned(spot, ModulePattern::None, FinderPattern::None, contrast);
    request.depth.maxDepthMm = kPublishedMaxDepthModules * spot.placement.moduleMm;
    const ShapedFloorOptions options{.shape = shape, .contrast = contrast};
    return carveByEngine(spot, request, nullptr, [options](CarvingTarget target) {
      return std::make_unique<ShapedFloorSearch>(std::move(target), options);
    });
  };
}

Result<CarvedCode> oursOneLight(const StudyPlacement& spot, double contrast) {
  EngraveRequest request = spot.request;
  request.depth.objective = DepthObjective::OneLight;
  request.depth.contrast = contrast;
  return carveByEngine(spot, request);
}

auto ours(ModulePattern modules, FinderPattern finders, CarveFor carveFor) {
  return [modules, finders, carveFor](const StudyPlacement& spot, double contrast) {
    EngraveRequest request = patterned(spot, modules, finders, contrast);
    request.depth.carveFor = carveFor;
    return carveByEngine(spot, request);
  };
}

/// Carves as the app does: pipeline/default_patterns.h decides everything but the contrast.
Result<CarvedCode> oursByDefault(const StudyPlacement& spot, double contrast) {
  EngraveRequest request = spot.request;
  request.depth.carveFor = CarveFor::Print;
  request.depth.contrast = contrast;
  return carveByEngine(spot, request);
}

}  // namespace

std::string versionOfMethod(const std::vector<std::string>& key) {
  return versionOf({findMethod(key[1])->search, kLight, kPrint, kDecoding});
}

Result<Symbol> symbolAtLevel(const StudyPlacement& spot, ErrorCorrection level) {
  SymbolOptions options = spot.request.code.symbol;
  options.errorCorrection = level;
  options.raiseErrorCorrection = false;
  return encodeSymbol(spot.request.code.text, options);
}

const std::vector<Method>& methods() {
  // Kikuchi 2018, Papp 2021 and Papp 2022 publish no contrast. Theirs is ours, so that their depths compare.
  static const std::vector<double> kContrasts = {0.1, 0.15, 0.2, 0.3, 0.4, 0.55, 0.7};
  static const std::vector<double> kLiteralContrasts = {0.1, 0.2, 0.3};
  static const double usual = EngraveRequest{}.depth.contrastAsked();
  static const double ofDefault = withDefaultPatterns({}, kUsualModuleMm).depth.contrastAsked();
  static const std::vector<Method> kAll = {
      {"groove-2018", kContrasts, 0.3, DirectionMethod::Pca, groove2018, {"groove-2018", 1}},
      {"self-shadow-2019",
       {0.05, 0.08, 0.12, 0.16, 0.2},
       0.2,
       DirectionMethod::MeanNormal,
       selfShadow2019,
       {"self-shadow-2019", 1}},
      {"one-light-2020",
       {0.05, 0.08, 0.12, 0.16, 0.2},
       0.2,
       DirectionMethod::MeanNormal,
       oneLight2020,
       {"one-light-2020", 1}},
      {"tilted-2021", kContrasts, usual, DirectionMethod::MeanNormal, floors2021(FloorShape::Tilted)},
      {"wavy-2021", kContrasts, usual, DirectionMethod::MeanNormal, floors2021(FloorShape::Wavy)},
      {"papp-2022", kContrasts, usual, DirectionMethod::DepthBalanced,
       paper2022(ModulePattern::Square, FinderPattern::ThickPlus)},
      {"papp-2022-whole-modules", kContrasts, usual, DirectionMethod::DepthBalanced,
       paper2022(ModulePattern::None, FinderPattern::None)},
      {"papp-2022-literal", kLiteralContrasts, usual, DirectionMethod::DepthBalanced,
       literal2022(ModulePattern::Square, FinderPattern::ThickPlus), kLiteral},
      {"papp-2022-literal-whole-modules", kLiteralContrasts, usual, DirectionMethod::DepthBalanced,
       literal2022(ModulePattern::None, FinderPattern::None), kLiteral},
      {"even-depth", {0.15, 0.25, 0.35, 0.45, 0.6, 0.8}, 0.45, DirectionMethod::DepthBalanced, evenDepth},
      {"ours-reading", {0.03, 0.05, 0.08, 0.12, 0.2}, 0.08, DirectionMethod::DepthBalanced, oursReading},
      {"ours-one-light", {0.1, 0.15, 0.2, 0.3, 0.4}, usual, DirectionMethod::DepthBalanced, oursOneLight},
      {"ours-for-design", kContrasts, usual, DirectionMethod::DepthBalanced,
       ours(kOurModules, kOurFinders, CarveFor::Design)},
      {"ours-thick-plus", kContrasts, usual, DirectionMethod::DepthBalanced,
       ours(kOurModules, kOurFinders, CarveFor::Print)},
      {"ours-whole-modules", kContrasts, usual, DirectionMethod::DepthBalanced,
       ours(ModulePattern::None, FinderPattern::None, CarveFor::Print)},
      {"ours", {0.15, 0.2, 0.25, 0.3, 0.4, 0.55}, ofDefault, DirectionMethod::DepthBalanced, oursByDefault},
  };
  return kAll;
}

const Method* findMethod(const std::string& name) {
  const auto it = std::find_if(methods().begin(), methods().end(), [&](const Method& m) { return m.name == name; });
  return it == methods().end() ? nullptr : &*it;
}

}  // namespace qrelief::study
