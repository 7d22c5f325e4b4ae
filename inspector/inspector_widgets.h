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

/// The colours of the inspector beside ImGui's own, for dark and light pages.
struct InspectorPalette {
  ImU32 ink, soft, line, accent;
  std::array<ImU32, 5> curves;  ///< told apart by anyone who sees light and dark [Okabe, Ito 2008]

  static InspectorPalette of(bool dark);
};

/// Sets ImGui's colours and measures to those of the page.
void styleInspector(bool dark);

/// Where the controls of a frame are, by the English names they show: for whoever cannot see the canvas.
using ControlAreas = std::map<std::string, std::array<float, 4>>;

/// Notes the last item.
void noteControl(ControlAreas& areas, std::string_view name);

/// Translated; wraps at the window's edge. ImGui takes printf formats; these are checked when they are compiled.
template <class... Args>
void write(fmt::format_string<Args...> format, Args&&... args) {
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(phrase(format, std::forward<Args>(args)...).c_str());
  ImGui::PopTextWrapPos();
}

/// The same in the soft ink.
template <class... Args>
void writeSoftly(fmt::format_string<Args...> format, Args&&... args) {
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  write(format, std::forward<Args>(args)...);
  ImGui::PopStyleColor();
}

/// A label that ImGui knows by its English text in every language.
std::string label(const char* english);

struct Curve {
  std::vector<double> values;  ///< at 1, 2, 3 …
  ImU32 colour;
};

/// Curves over the passes of a search, from zero up.
/// @param marked  value index with a line through it; none if negative
/// @returns the index that the pointer is at; negative if it is elsewhere
int plotCurves(const char* name, std::span<const Curve> curves, const char* unit, int marked,
               const InspectorPalette& palette);

/// Parts of a histogram that the panel has room for.
inline constexpr int kBars = 64;

struct Bars {
  std::vector<int> counts;
  ImU32 colour;
};

/// Histograms over one range, one in front of the other; each in shares of its own highest bar.
void plotBars(const char* id, std::span<const Bars> bars, ValueRange range, const char* unit,
              const InspectorPalette& palette);

/// The colours of a scale from left to right, with the numbers at its ends.
void colourBar(ColourScale scale, ValueRange range, const char* unit, const InspectorPalette& palette);

/// As short as it can be said with four digits.
std::string numberText(double value, const char* unit = "");

}  // namespace qrelief
