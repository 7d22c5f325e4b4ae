// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "carving/reading_search.h"
#include "carving/shaped_floor_search.h"
#include "embedding/surface_mode.h"
#include "light/directional_light.h"
#include "printing/build_direction.h"
#include "printing/print_process.h"
#include "projection/placement_request.h"
#include "qr/module_pattern.h"
#include "qr/symbol.h"
#include "settings/preset.h"

namespace qrelief {

/// Which depth is deep enough.
enum class DepthObjective : std::uint8_t {
  Contrast,  ///< every submodule darker than its surroundings, as published: carving/depth_search.h
  Reading,   ///< every module darker than its surroundings, as a reader sees it: carving/reading_search.h
  OneLight   ///< every submodule darker than its surroundings under one lamp: carving/one_light_search.h
};

/// "contrast", "reading" or "one-light".
const char* depthObjectiveName(DepthObjective objective);

/// DepthObjective::OneLight without a lamp of its own: as strong beside the sky as [Peng 2020] has it; from the
/// symbol's top left, as drawings are lit: on a diagonal, long rows of dark modules throw no long shadows; and low,
/// where a flat place needs the least depth (docs/decisions/0035).
inline constexpr DirectionalLight kOneLight = {.azimuthDeg = 135, .elevationDeg = 20, .strength = 19};

/// How the depths that DepthObjective::Contrast asks for are found.
enum class ContrastSolver : std::uint8_t {
  Fast,       ///< carving/fast_search.h
  PaperSteps  ///< as published: carving/depth_search.h
};

/// Which surface has to be dark enough.
enum class CarveFor : std::uint8_t {
  Design,  ///< the carved one, as the file has it
  Print    ///< what the printer leaves of it, too: pipeline/contrast_for_print.h
};

/// Everything that decides what comes out. What a person can set of it stands in the table of settings/settings.h.
struct EngraveRequest {
  std::string text;  ///< UTF-8, not empty
  SymbolOptions symbol;
  std::optional<ModulePattern> modulePattern;  ///< none: pipeline/default_patterns.h
  std::optional<FinderPattern> finderPattern;  ///< likewise
  PlacementRequest placement;
  DepthObjective objective = DepthObjective::Contrast;
  /// Other than flat for DepthObjective::Contrast by ContrastSolver::Fast only.
  FloorShape floor = FloorShape::Flat;
  Preset preset = Preset::Balanced;  ///< how dark carved submodules are; where the code does not read, a deeper one
  bool keepPreset = false;  ///< carve no deeper than the preset says, whether the code and its print read or not
  /// A carved submodule is darker than its surroundings by this fraction, 0 < c < 1; none: that of the preset.
  std::optional<double> contrast;
  ContrastSolver solver = ContrastSolver::Fast;
  ReadingOptions reading;
  /// Print counts for flat floors by ContrastSolver::Fast without lamps, if a process is known; else Design does.
  CarveFor carveFor = CarveFor::Design;
  std::optional<double> maxDepthMm;      ///< none: pipeline/default_patterns.h
  double minWallMm = 0.8;                ///< material that stays behind every floor, ≥ 0
  float albedo = 0.7f;                   ///< of the printed material
  std::vector<DirectionalLight> lights;  ///< beside the uniform sky, at most kMaxLights; see lamps()
  SurfaceMode surface = SurfaceMode::Preserved;
  /// Which of namedPrinters() the printer was taken from; none: whether the code reads as printed is not found out.
  std::optional<std::size_t> process = 0;
  Printer printer = namedPrinters()[0].printer;  ///< no depth is found more exactly than half a layer needs
  BuildDirection buildUp;                        ///< how the model stands on it
  bool inlay = false;         ///< make the body that fills the pockets as well, for printing in two colours
  bool recordSearch = false;  ///< keep what every pass of the search for depths saw, in EngraveResult::search

  bool isForPrint() const {
    return carveFor == CarveFor::Print && process && lights.empty() && objective == DepthObjective::Contrast &&
           solver == ContrastSolver::Fast && floor == FloorShape::Flat;
  }

  /// The lamps that it is carved for and judged under.
  std::vector<DirectionalLight> lamps() const {
    return objective == DepthObjective::OneLight && lights.empty() ? std::vector{kOneLight} : lights;
  }

  /// That of the preset, unless one is asked for by itself.
  double contrastAsked() const { return contrast.value_or(presetContrast(preset)); }

  bool operator==(const EngraveRequest&) const = default;
};

}  // namespace qrelief
