// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "carving/mark.h"
#include "carving/surface_mode.h"
#include "label/label_layout.h"
#include "light/directional_light.h"
#include "printing/build_direction.h"
#include "printing/print_process.h"
#include "projection/placement_request.h"
#include "qr/module_pattern.h"
#include "qr/symbol.h"
#include "settings/preset.h"
#include "verification/ink.h"

namespace qrelief {

/// Criterion that makes a depth deep enough.
enum class DepthObjective : std::uint8_t {
  Contrast,  ///< every submodule darker than its surroundings, as published: depth/depth_search.h
  OneLight   ///< every submodule darker than its surroundings under one lamp: depth/one_light_search.h
};

/// Returns "contrast" or "one-light".
const char* depthObjectiveName(DepthObjective objective);

/// The lamp of DepthObjective::OneLight if the request has none. It is as strong relative to the sky as in [Peng 2020].
/// It shines from the symbol's top left, as in drawings: along a diagonal, so that long rows of dark modules cast no
/// long shadows. It is low, where a flat place needs the least depth (docs/decisions/0035).
inline constexpr DirectionalLight kOneLight = {.azimuthDeg = 135, .elevationDeg = 20, .strength = 19};

/// Method that finds the depths for DepthObjective::Contrast.
enum class ContrastSolver : std::uint8_t {
  Fast,       ///< depth/fast_search.h
  PaperSteps  ///< as published: depth/depth_search.h
};

/// The surface that has to be dark enough.
enum class CarveFor : std::uint8_t {
  Design,  ///< the carved surface, as in the file
  Print    ///< the printed surface, too: pipeline/contrast_for_print.h
};

/// Everything that decides the result. The table of settings/settings.h lists what a person can set.
struct EngraveRequest {
  std::string text;  ///< UTF-8, not empty
  SymbolOptions symbol;
  std::optional<ModulePattern> modulePattern;  ///< none: see pipeline/default_patterns.h
  std::optional<FinderPattern> finderPattern;  ///< none: the same
  PlacementRequest placement;
  /// Inlay and Paint need no light: patterns, preset and all else that decides the depth of pockets, lamps, albedo,
  /// surface and `inlay` have no effect on them.
  Mark mark = Mark::Shadow;
  std::optional<double> markDepthMm;  ///< depth of Mark::Inlay along the rays; none: pipeline/mark_depth.h
  Ink ink;                            ///< of Mark::Inlay and Mark::Paint
  DepthObjective objective = DepthObjective::Contrast;
  Preset preset = Preset::Balanced;  ///< darkness of carved submodules; a code that does not read gets a deeper preset
  bool keepPreset = false;  ///< never carve deeper than the preset, even if the code or its print does not read
  /// Fraction by which a carved submodule is darker than its surroundings, 0 < c < 1; none: the preset's contrast.
  std::optional<double> contrast;
  ContrastSolver solver = ContrastSolver::Fast;
  /// Print takes effect for ContrastSolver::Fast without lamps, if a process is known; otherwise Design applies.
  CarveFor carveFor = CarveFor::Design;
  std::optional<double> maxDepthMm;      ///< none: see pipeline/default_patterns.h
  double minWallMm = 0.8;                ///< material left behind every floor, ≥ 0
  float albedo = 0.7f;                   ///< reflectance of the printed material
  std::vector<DirectionalLight> lights;  ///< in addition to the uniform sky, at most kMaxLights; see lamps()
  SurfaceMode surface = SurfaceMode::Preserved;
  /// Index of the printer in namedPrinters(); none: the print is not simulated.
  std::optional<std::size_t> process = 0;
  Printer printer = namedPrinters()[0].printer;  ///< depths are found to within half a layer
  BuildDirection buildUp;                        ///< orientation of the model on the printer
  LabelOptions label;                            ///< text under the code and frame round it, carved two layers deep
  bool inlay = false;         ///< also make the body that fills the pockets, for printing in two colours
  bool recordSearch = false;  ///< record what every pass of the depth search saw, in EngraveResult::search

  bool isInColour() const { return mark != Mark::Shadow; }
  /// Returns true if the result has a body of a second material.
  bool hasInlay() const { return mark == Mark::Inlay || (mark == Mark::Shadow && inlay); }
  bool isTwoColoured() const { return isInColour() || inlay; }
  bool isForOneLight() const { return !isInColour() && objective == DepthObjective::OneLight; }

  bool isForPrint() const {
    return !isInColour() && carveFor == CarveFor::Print && process && lights.empty() &&
           objective == DepthObjective::Contrast && solver == ContrastSolver::Fast;
  }

  /// Returns the lamps that the code is carved for and judged under.
  std::vector<DirectionalLight> lamps() const {
    if (isInColour()) return {};
    return isForOneLight() && lights.empty() ? std::vector{kOneLight} : lights;
  }

  /// Returns the reflectance of the model's material.
  float surfaceAlbedo() const { return isInColour() ? static_cast<float>(ink.light) : albedo; }

  /// Returns the contrast asked for by itself, or else the preset's.
  double contrastAsked() const { return contrast.value_or(presetContrast(preset)); }

  bool operator==(const EngraveRequest&) const = default;
};

}  // namespace qrelief
