// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <fmt/format.h>
#include <imgui.h>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "inspector/translation.h"
#include "inspector/value_map.h"
#include "viewer/colour_scale.h"

namespace qrelief {

/// The inspector's own colours in addition to ImGui's, for dark and light pages.
struct InspectorPalette {
  ImU32 ink, soft, line, accent;
  std::array<ImU32, 5> curves;  ///< distinguishable by lightness alone [Okabe, Ito 2008]

  static InspectorPalette of(bool dark);
};

/// Sets ImGui's colours and sizes to match the page.
void styleInspector(bool dark);

/// Positions of a frame's controls, by their English names, for clients that cannot see the canvas.
using ControlAreas = std::map<std::string, std::array<float, 4>>;

/// Adds the last item to the control areas, unless it is scrolled out of sight, wholly or in part.
void noteControl(ControlAreas& areas, std::string_view name);

/// Writes text, wrapped at the window's edge. @param isSoft  in the soft ink
void writeWrapped(const std::string& text, bool isSoft);

/// Returns a translated label that ImGui identifies by its English text, whatever the language.
std::string label(const char* english);

struct Curve {
  std::vector<double> values;  ///< at 1, 2, 3 …
  ImU32 colour;
};

/// Plots curves over the passes of a search, from zero up.
/// @param marked  value index with a line through it; negative: none
/// @returns the index under the pointer; negative if the pointer is elsewhere
int plotCurves(const char* name, std::span<const Curve> curves, const char* unit, int marked,
               const InspectorPalette& palette);

/// Number of bars that fit in the panel.
inline constexpr int kBars = 64;

struct Bars {
  std::vector<int> counts;
  ImU32 colour;
};

/// Plots histograms over one range, one in front of the other, each relative to its own highest bar.
void plotBars(const char* id, std::span<const Bars> bars, ValueRange range, const char* unit,
              const InspectorPalette& palette);

/// Draws the colours of a scale from left to right, with the numbers at its ends.
void colourBar(ColourScale scale, ValueRange range, const char* unit, const InspectorPalette& palette);

/// Returns the shortest text with four significant digits.
std::string numberText(double value, const char* unit = "");

}  // namespace qrelief
