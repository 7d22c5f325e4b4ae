// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict/remedies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <optional>

#include "message_codes/verdict.h"
#include "pipeline/engrave.h"
#include "verdict/ink_advice.h"
#include "verification/printability.h"

namespace qrelief {
namespace {

constexpr std::array kNozzlesMm = {0.8, 0.6, 0.4, 0.3, 0.25, 0.2, 0.15};          // nozzles on the market
constexpr std::array kLayersMm = {0.2, 0.16, 0.12, 0.1, 0.08, 0.06, 0.05, 0.04};  // layers that printers offer
constexpr double kThickestLayer = 0.75;                                           // of the nozzle's width
constexpr double kMaxSizeMm = 1000;
constexpr double kLarger = 1.25;
constexpr double kRoundingMm = 1e-9;

std::string plain(double value) { return fmt::format("{:g}", value); }

/// Returns true if the model may have room for a code of this size: two opposite corners of the square that it needs
/// lie on the model, so they are at most its diagonal apart. That ignores perspective, which can help little.
bool mayHaveRoom(double symbolMm, const EngraveRequest& request, const EngraveResult& result) {
  const int modules = result.symbol.size;
  const double edgeMm = symbolMm * roomFactor(modules, searchedPlacement(request, modules));
  return std::numbers::sqrt2 * edgeMm <= boundingBox(result.mesh).diagonal();
}

/// Adds a larger code, if the settings keep it small and the model may have room for it.
/// @param leastModuleMm  width of a module that would suffice; 0 if it is not known
void addLargerCode(const EngraveRequest& request, const EngraveResult& result, double leastModuleMm,
                   std::vector<Remedy>& remedies) {
  const PlacementRequest& place = request.placement;
  const Placement& placement = result.placement;
  if (place.sizeMode == SizeMode::Fixed) {
    if (placement.largestMm > placement.symbolMm + 0.1)
      remedies.push_back({message<"remedy-as-large-as-fits">(), {{"size", "best"}}});
    return;
  }
  const double neededMm = std::ceil(std::max(kLarger * placement.symbolMm, leastModuleMm * result.symbol.size));
  if (placement.symbolMm > place.maxSizeMm - 0.1) {
    if (neededMm <= kMaxSizeMm && mayHaveRoom(neededMm, request, result))
      remedies.push_back(
          {message<"remedy-allow-size">(with::lengthMm<"size">(neededMm)), {{"maxSizeMm", plain(neededMm)}}});
  } else if (place.sizeMode != SizeMode::Best) {
    remedies.push_back({message<"remedy-as-large-as-fits">(), {{"size", "best"}}});
  } else if (!place.mayTurn()) {
    remedies.push_back({message<"remedy-turn">(), {{"rotateDeg", "0"}}});
  }
}

void addDarkerModules(const EngraveRequest& request, std::vector<Remedy>& remedies) {
  if (request.marking.isInColour()) return;
  if (request.depth.contrast) {
    remedies.push_back({message<"remedy-preset-contrast">(), {{"contrast", ""}}});
  } else if (const std::optional<Preset> deeper = deeperPreset(request.depth.preset)) {
    const char* name = presetName(*deeper);
    remedies.push_back({message<"remedy-deeper">(with::choice<"preset">("preset", name)), {{"preset", name}}});
  }
}

/// Adds carving for the sky alone, as lamps light a curved surface unevenly.
void addCarvingForAnyLight(const EngraveRequest& request, std::vector<Remedy>& remedies) {
  if (request.lamps().empty()) return;
  Remedy remedy{message<"remedy-any-light">(), {}};
  if (request.isForOneLight()) remedy.changes.push_back({"objective", depthObjectiveName(DepthObjective::Contrast)});
  if (!request.depth.lights.empty()) remedy.changes.push_back({"light", ""});
  remedies.push_back(std::move(remedy));
}

/// Adds the exchange of the two colours of an inverted code.
void addOtherColours(const MarkRequest& marking, std::vector<Remedy>& remedies) {
  const Ink ink = marking.ink();
  if (!marking.isInColour() || !ink.isInverted()) return;
  const double mostLight = findSetting("albedo")->max;
  remedies.push_back({message<"remedy-swap-colours">(),
                      {{"albedo", plain(std::min(ink.dark, mostLight))}, {"darkReflectance", plain(ink.light)}}});
}

void addCarvingForPrint(EngraveRequest request, std::vector<Remedy>& remedies) {
  if (request.isForPrint()) return;
  request.depth.carveFor = CarveFor::Print;
  if (request.isForPrint()) remedies.push_back({message<"remedy-carve-for-print">(), {{"carveFor", "print"}}});
}

/// Adds paint, which needs no wall.
void addPaint(const EngraveRequest& request, const EngraveResult& result, std::vector<Remedy>& remedies) {
  if (request.marking.mark == Mark::Inlay && (result.modulesLeftOut > 0 || result.markDepthMm < result.opaqueDepthMm))
    remedies.push_back({message<"remedy-paint">(), {{"mark", std::string(markName(Mark::Paint))}}});
}

/// Returns the thickest of the layers that printers offer up to a bound; none: all are thicker.
std::optional<double> thickestLayerMm(double mostMm) {
  const auto thickest =
      std::find_if(kLayersMm.begin(), kLayersMm.end(), [&](double mm) { return mm <= mostMm + kRoundingMm; });
  return thickest == kLayersMm.end() ? std::nullopt : std::optional(*thickest);
}

/// Adds the widest nozzle up to a bound, with thinner layers if it cannot lay the present ones.
void addFinerNozzle(double mostMm, const EngraveRequest& request, std::vector<Remedy>& remedies) {
  const Printer& printer = request.print.printer;
  const auto finer = std::find_if(kNozzlesMm.begin(), kNozzlesMm.end(),
                                  [&](double mm) { return mm <= mostMm + kRoundingMm && mm < printer.nozzleMm; });
  if (finer == kNozzlesMm.end()) return;
  const SettingChange nozzle{"nozzleMm", plain(*finer)};
  const double thickestMm = kThickestLayer * *finer;
  const auto layer = printer.layerMm > thickestMm + kRoundingMm ? thickestLayerMm(thickestMm) : std::nullopt;
  if (layer)
    remedies.push_back(
        {message<"remedy-nozzle-and-layer">(with::lengthMm<"nozzle">(*finer), with::lengthMm<"layer">(*layer)),
         {nozzle, {"layerMm", plain(*layer)}}});
  else
    remedies.push_back({message<"remedy-nozzle">(with::lengthMm<"nozzle">(*finer)), {nozzle}});
}

std::vector<Remedy> inkPrintingRemedies(const EngraveRequest& request, const EngraveResult& result, bool wasPrinted) {
  const double lineMm = lineWidthMm(request.print.printer), moduleMm = result.placement.moduleMm;
  std::vector<Remedy> remedies;
  if (wasPrinted) addOtherColours(request.marking, remedies);
  addLargerCode(request, result, lineMm, remedies);
  if (moduleMm < lineMm) addFinerNozzle(nozzleForInk(moduleMm, request.print.printer), request, remedies);
  addPaint(request, result, remedies);
  remedies.push_back(anotherSpot());
  return remedies;
}

}  // namespace

Remedy anotherSpot() { return {message<"remedy-another-spot">(), {}}; }

std::vector<Remedy> readingRemedies(const EngraveRequest& request, const EngraveResult& result) {
  std::vector<Remedy> remedies;
  addOtherColours(request.marking, remedies);
  addCarvingForAnyLight(request, remedies);
  addDarkerModules(request, remedies);
  addPaint(request, result, remedies);
  addLargerCode(request, result, 0, remedies);
  if (request.code.symbol.errorCorrection == ErrorCorrection::L && !request.code.symbol.raiseErrorCorrection)
    remedies.push_back({message<"remedy-more-correction">(), {{"ecc", ""}}});
  remedies.push_back(anotherSpot());
  return remedies;
}

std::vector<Remedy> textRemedies(const EngraveRequest& request, const EngraveResult& result, double growth,
                                 bool isForPrint) {
  const Printer& printer = request.print.printer;
  std::vector<Remedy> remedies;
  addLargerCode(request, result, growth * result.placement.moduleMm, remedies);
  if (isForPrint && printer.technique == PrintTechnique::Filament && !printer.lineWidthMm)
    addFinerNozzle(printer.nozzleMm / growth, request, remedies);
  remedies.push_back(anotherSpot());
  return remedies;
}

std::vector<Remedy> printingRemedies(const EngraveRequest& request, const EngraveResult& result, bool wasPrinted) {
  if (request.marking.isInColour()) return inkPrintingRemedies(request, result, wasPrinted);
  const CarvedFeatures features = featuresOf(result);
  std::vector<Remedy> remedies;
  const double leastModuleMm = printableModuleMm(features, request.print.printer.nozzleMm);
  const bool isTooFine = features.moduleMm < leastModuleMm - kRoundingMm;
  if (wasPrinted && !isTooFine) {  // depth helps if the printer makes the modules
    addCarvingForAnyLight(request, remedies);
    addCarvingForPrint(request, remedies);
    addDarkerModules(request, remedies);
  }
  if (wasPrinted || isTooFine) addLargerCode(request, result, leastModuleMm, remedies);
  if (isTooFine) {
    if (request.code.ownPattern ||
        (request.code.modulePattern && request.code.modulePattern != ModulePattern::ThickPlus)) {
      const bool isThin = !request.code.ownPattern && request.code.modulePattern == ModulePattern::ThinPlus;
      const char* pattern = isThin ? "square" : "thick-plus";
      remedies.push_back(
          {message<"remedy-pattern">(with::choice<"pattern">("pattern", pattern)), {{"pattern", pattern}}});
    }
    addFinerNozzle(printableNozzleMm(features), request, remedies);
  }
  const double printableMm = printableLayerMm(features);
  if (printableMm < request.print.printer.layerMm - kRoundingMm) {
    if (!wasPrinted) addDarkerModules(request, remedies);
    if (const auto thinner = thickestLayerMm(printableMm))
      remedies.push_back({message<"remedy-layer">(with::lengthMm<"layer">(*thinner)), {{"layerMm", plain(*thinner)}}});
  }
  remedies.push_back(anotherSpot());
  return remedies;
}

}  // namespace qrelief
