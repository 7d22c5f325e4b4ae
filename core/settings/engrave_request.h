// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "carving/mark.h"
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

/// Criterion for a sufficient depth.
enum class DepthObjective : std::uint8_t {
  Contrast,  ///< every submodule darker than its surroundings, as published: depth/paper_step_search.h
  OneLight   ///< every submodule darker than its surroundings under one lamp: depth/one_light_search.h
};

/// Returns "contrast" or "one-light".
const char* depthObjectiveName(DepthObjective objective);

/// The lamp of DepthObjective::OneLight if the request has none. It is as strong relative to the sky as in [Peng 2020].
/// It shines from the symbol's top left, as in drawings: along a diagonal, so that long rows of dark modules cast no
/// long shadows. It is low, because a flat place then needs the least depth (docs/decisions/0035).
inline constexpr DirectionalLight kOneLight = {.azimuthDeg = 135, .elevationDeg = 20, .strength = 19};

/// Method that finds the depths for DepthObjective::Contrast.
enum class ContrastSolver : std::uint8_t {
  Fast,       ///< depth/fast_search.h
  PaperSteps  ///< as published: depth/paper_step_search.h
};

/// The surface that has to be dark enough.
enum class CarveFor : std::uint8_t {
  Design,  ///< the carved surface, as in the file
  Print    ///< the printed surface, too: pipeline/contrast_for_print.h
};

/// Form of the text on the model.
enum class Content : std::uint8_t {
  Code,  ///< a QR code
  Text   ///< letters; each line of the text is a line of letters
};

/// Returns "code" or "text".
const char* contentName(Content content);

/// The text and how it becomes a symbol or letters.
struct CodeRequest {
  std::string text;  ///< UTF-8, not empty
  Content content = Content::Code;
  SymbolOptions symbol;                             ///< this and the patterns have no effect on Content::Text
  std::optional<ModulePattern> modulePattern = {};  ///< none: see pipeline/default_patterns.h
  std::optional<ModuleMask> ownPattern = {};        ///< replaces modulePattern
  std::optional<FinderPattern> finderPattern = {};  ///< none: the same
  LabelOptions label;  ///< text under the code, only for Content::Code, and frame round either

  /// Returns the carved submodules of a dark module.
  /// Needs a pattern: CodeRequest::modulePattern is filled in by pipeline/default_patterns.h.
  ModuleMask modules() const { return ownPattern ? *ownPattern : *modulePattern; }

  bool isText() const { return content == Content::Text; }
  /// Returns the letters and the frame to make.
  LabelOptions lettering() const { return isText() ? LabelOptions{text, label.frame, true} : label; }

  bool operator==(const CodeRequest&) const = default;
};

/// Reflectance of a model with a code made by shadow, unless the request has one.
inline constexpr double kShadowAlbedo = 0.7;

/// The technique for dark modules, its options, and the reflectances of the materials.
struct MarkRequest {
  /// Inlay and Paint need no light: patterns, depths, lamps and surface have no effect on them.
  Mark mark = Mark::Shadow;
  /// If a shadow does not read or print well, try an inlay, then paint (verdict/engrave_plan.h). Needs Mark::Shadow.
  bool isOpen = false;
  std::optional<double> markDepthMm = {};  ///< depth of Mark::Inlay along the rays; none: pipeline/mark_depth.h
  std::optional<double> albedo = {};       ///< reflectance of the model's material; none: see surfaceAlbedo()
  double darkReflectance = Ink{}.dark;     ///< of the second colour of Mark::Inlay and Mark::Paint

  bool isInColour() const { return mark != Mark::Shadow; }

  /// Returns the requested reflectance of the model's material, else white plastic's for a code in colour, and
  /// kShadowAlbedo for a shadow.
  double surfaceAlbedo() const { return albedo.value_or(isInColour() ? Ink{}.light : kShadowAlbedo); }

  /// Returns the two materials of Mark::Inlay and Mark::Paint.
  Ink ink() const { return {darkReflectance, surfaceAlbedo()}; }

  bool operator==(const MarkRequest&) const = default;
};

/// The depth of the pockets, and the light in which they must be dark.
struct DepthRequest {
  DepthObjective objective = DepthObjective::Contrast;
  Preset preset = Preset::Balanced;  ///< darkness of carved submodules; a code that does not read gets a deeper preset
  bool keepPreset = false;  ///< never carve deeper than the preset, even if the code or its print does not read
  /// Fraction by which a carved submodule is darker than its surroundings, 0 < c < 1; none: the preset's contrast.
  std::optional<double> contrast = {};
  ContrastSolver solver = ContrastSolver::Fast;
  /// Print takes effect for ContrastSolver::Fast, if a process is known; otherwise Design applies.
  CarveFor carveFor = CarveFor::Design;
  std::optional<double> maxDepthMm = {};      ///< none: see pipeline/default_patterns.h
  double minWallMm = 0.8;                     ///< material left behind every floor, ≥ 0
  std::vector<DirectionalLight> lights = {};  ///< in addition to the uniform sky, at most kMaxLights; see lamps()
  SurfaceMode surface = SurfaceMode::Preserved;
  bool recordSearch = false;  ///< record every pass of the depth search in EngraveResult::search

  /// Returns the requested contrast, else the preset's.
  double contrastAsked() const { return contrast.value_or(presetContrast(preset)); }

  bool operator==(const DepthRequest&) const = default;
};

/// The printer, and the model's orientation on it.
struct PrinterRequest {
  /// Index of the printer in namedPrinters(); none: the print is not simulated.
  std::optional<std::size_t> process = 0;
  Printer printer = namedPrinters()[0].printer;  ///< depths are found to within half a layer
  BuildDirection buildUp;                        ///< orientation of the model on the printer

  bool operator==(const PrinterRequest&) const = default;
};

/// Everything that determines the result. The table in settings/settings.h lists the user's settings.
struct EngraveRequest {
  CodeRequest code;
  PlacementRequest placement;
  MarkRequest marking;
  DepthRequest depth;
  PrinterRequest print;

  /// Returns true if the light decides the depths: neither colours nor letters need it.
  bool needsLight() const { return !marking.isInColour() && !code.isText(); }

  bool isForOneLight() const { return needsLight() && depth.objective == DepthObjective::OneLight; }

  bool isForPrint() const {
    return needsLight() && depth.carveFor == CarveFor::Print && print.process &&
           depth.objective == DepthObjective::Contrast && depth.solver == ContrastSolver::Fast;
  }

  /// Returns the lamps that the code is carved for and judged under.
  std::vector<DirectionalLight> lamps() const {
    if (!needsLight()) return {};
    return isForOneLight() && depth.lights.empty() ? std::vector{kOneLight} : depth.lights;
  }

  /// Returns the treatment of the facets under the code.
  SurfaceMode surface() const { return needsLight() ? depth.surface : SurfaceMode::Preserved; }

  bool operator==(const EngraveRequest&) const = default;
};

}  // namespace qrelief
