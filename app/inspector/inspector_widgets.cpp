// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspector/inspector_widgets.h"

#include <algorithm>
#include <cmath>

namespace qrelief {
namespace {

constexpr float kPlotHeight = 74;

struct Box {
  ImVec2 min, max;
  float width() const { return max.x - min.x; }
  float height() const { return max.y - min.y; }
};

/// Begins a framed area over the window's whole width that takes pointer input.
Box plotArea(const char* id, float height, const InspectorPalette& palette) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = std::max(80.0f, ImGui::GetContentRegionAvail().x);
  ImGui::InvisibleButton(id, ImVec2(width, height));
  const Box box{corner, ImVec2(corner.x + width, corner.y + height)};
  ImGui::GetWindowDrawList()->AddRect(box.min, box.max, palette.line, 3);
  return box;
}

ImU32 withAlpha(ImU32 colour, unsigned alpha) { return (colour & 0x00FFFFFFu) | (alpha << 24); }

void writeEnds(const std::string& left, const std::string& right, const InspectorPalette& palette) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddText(at, palette.soft, left.c_str());
  draw->AddText(ImVec2(at.x + width - ImGui::CalcTextSize(right.c_str()).x, at.y), palette.soft, right.c_str());
  ImGui::Dummy(ImVec2(width, ImGui::GetTextLineHeight()));
}

}  // namespace

InspectorPalette InspectorPalette::of(bool dark) {
  if (dark)
    return {IM_COL32(237, 239, 241, 255),
            IM_COL32(171, 178, 185, 255),
            IM_COL32(74, 81, 88, 255),
            IM_COL32(98, 203, 182, 255),
            {IM_COL32(86, 180, 233, 255), IM_COL32(230, 159, 0, 255), IM_COL32(204, 121, 167, 255),
             IM_COL32(0, 158, 115, 255), IM_COL32(240, 228, 66, 255)}};
  return {IM_COL32(28, 31, 33, 255),
          IM_COL32(87, 93, 97, 255),
          IM_COL32(190, 192, 186, 255),
          IM_COL32(15, 107, 92, 255),
          {IM_COL32(0, 114, 178, 255), IM_COL32(213, 94, 0, 255), IM_COL32(148, 68, 118, 255),
           IM_COL32(0, 158, 115, 255), IM_COL32(128, 112, 0, 255)}};
}

void styleInspector(bool dark) {
  dark ? ImGui::StyleColorsDark() : ImGui::StyleColorsLight();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 8;
  style.FrameRounding = style.GrabRounding = style.TabRounding = 4;
  style.ScrollbarSize = 14;
  style.FramePadding = ImVec2(8, 5);
  style.ItemSpacing = ImVec2(8, 6);
  style.WindowPadding = ImVec2(10, 10);
  style.TouchExtraPadding = ImVec2(2, 3);
  style.WindowMenuButtonPosition = ImGuiDir_Right;
  const InspectorPalette palette = InspectorPalette::of(dark);
  const auto set = [&](ImGuiCol which, int r, int g, int b, int a = 255) {
    style.Colors[which] = ImVec4(static_cast<float>(r) / 255, static_cast<float>(g) / 255, static_cast<float>(b) / 255,
                                 static_cast<float>(a) / 255);
  };
  const auto setTo = [&](ImGuiCol which, ImU32 colour) {
    style.Colors[which] = ImGui::ColorConvertU32ToFloat4(colour);
  };
  setTo(ImGuiCol_Text, palette.ink);
  setTo(ImGuiCol_TextDisabled, palette.soft);
  for (const ImGuiCol which :
       {ImGuiCol_CheckMark, ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive, ImGuiCol_NavHighlight})
    setTo(which, palette.accent);
  setTo(ImGuiCol_Border, palette.line);
  const bool d = dark;
  set(ImGuiCol_WindowBg, d ? 30 : 255, d ? 33 : 255, d ? 37 : 255, 251);
  set(ImGuiCol_PopupBg, d ? 36 : 255, d ? 39 : 255, d ? 44 : 255);
  for (const ImGuiCol which : {ImGuiCol_TitleBg, ImGuiCol_TitleBgActive, ImGuiCol_TitleBgCollapsed})
    set(which, d ? 41 : 232, d ? 45 : 232, d ? 50 : 227);
  for (const ImGuiCol which : {ImGuiCol_FrameBg, ImGuiCol_Button, ImGuiCol_Header, ImGuiCol_TableHeaderBg})
    set(which, d ? 49 : 236, d ? 54 : 236, d ? 60 : 231);
  for (const ImGuiCol which : {ImGuiCol_FrameBgHovered, ImGuiCol_ButtonHovered, ImGuiCol_HeaderHovered})
    set(which, d ? 62 : 221, d ? 68 : 223, d ? 76 : 217);
  for (const ImGuiCol which : {ImGuiCol_FrameBgActive, ImGuiCol_ButtonActive, ImGuiCol_HeaderActive})
    set(which, d ? 40 : 196, d ? 92 : 222, d ? 83 : 215);
  set(ImGuiCol_Tab, d ? 36 : 244, d ? 40 : 244, d ? 45 : 240);
  set(ImGuiCol_TabHovered, d ? 62 : 221, d ? 68 : 223, d ? 76 : 217);
  set(ImGuiCol_TabActive, d ? 40 : 196, d ? 92 : 222, d ? 83 : 215);
  set(ImGuiCol_TextSelectedBg, d ? 40 : 160, d ? 110 : 214, d ? 98 : 203);
  set(ImGuiCol_PlotHistogram, d ? 40 : 176, d ? 92 : 214, d ? 83 : 204);
  set(ImGuiCol_ScrollbarBg, 0, 0, 0, 0);
}

void noteControl(ControlAreas& areas, std::string_view name) {
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  const ImDrawList* draw = ImGui::GetWindowDrawList();
  if (min.y < draw->GetClipRectMin().y || max.y > draw->GetClipRectMax().y) return;
  areas[std::string(name)] = {min.x, min.y, max.x - min.x, max.y - min.y};
}

void writeWrapped(const std::string& text, bool isSoft) {
  if (isSoft) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  if (isSoft) ImGui::PopStyleColor();
}

std::string label(const char* english) { return fmt::format("{}###{}", translated(english), english); }

std::string numberText(double value, const char* unit) {
  if (!std::isfinite(value)) return translated("nothing");
  std::string text = std::abs(value) < 0.00005    ? "0"
                     : value == std::round(value) ? fmt::format("{:.0f}", value)
                     : std::abs(value) < 10       ? fmt::format("{:.4f}", value)
                     : std::abs(value) < 1000     ? fmt::format("{:.2f}", value)
                                                  : fmt::format("{:.0f}", value);
  if (*unit) text += std::string_view(unit) == "°" ? unit : fmt::format(" {}", unit);
  return text;
}

int plotCurves(const char* name, std::span<const Curve> curves, const char* unit, int marked,
               const InspectorPalette& palette) {
  double highest = 0;
  std::size_t longest = 1;
  for (const Curve& curve : curves) {
    longest = std::max(longest, curve.values.size());
    for (const double value : curve.values) highest = std::max(highest, value);
  }
  ImGui::TextUnformatted(translated(name));
  const std::string top = phrase("up to {}", numberText(highest, unit));
  ImGui::SameLine(ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(top.c_str()).x);
  ImGui::TextDisabled("%s", top.c_str());
  const Box box = plotArea(name, kPlotHeight, palette);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float pad = 6, step = (box.width() - 2 * pad) / static_cast<float>(std::max<std::size_t>(1, longest - 1));
  const auto at = [&](std::size_t i, double value) {
    const double share = highest > 0 ? value / highest : 0;
    return ImVec2(box.min.x + pad + step * static_cast<float>(i),
                  box.max.y - pad - static_cast<float>(share) * (box.height() - 2 * pad));
  };
  if (marked >= 0) {
    const float x = at(static_cast<std::size_t>(marked), 0).x;
    draw->AddLine(ImVec2(x, box.min.y), ImVec2(x, box.max.y), palette.soft);
  }
  for (const Curve& curve : curves) {
    for (std::size_t i = 0; i < curve.values.size(); ++i) {
      if (i > 0) draw->AddLine(at(i - 1, curve.values[i - 1]), at(i, curve.values[i]), curve.colour, 1.5f);
      draw->AddCircleFilled(at(i, curve.values[i]), 2.5f, curve.colour);
    }
  }
  if (!ImGui::IsItemHovered()) return -1;
  const float along = (ImGui::GetIO().MousePos.x - box.min.x - pad) / step;
  const int index = std::clamp(static_cast<int>(std::lround(along)), 0, static_cast<int>(longest) - 1);
  std::string text = phrase("pass {}", index + 1);
  for (const Curve& curve : curves)
    if (static_cast<std::size_t>(index) < curve.values.size()) text += "\n" + numberText(curve.values[index], unit);
  ImGui::SetTooltip("%s", text.c_str());
  return index;
}

void plotBars(const char* id, std::span<const Bars> bars, ValueRange range, const char* unit,
              const InspectorPalette& palette) {
  const Box box = plotArea(id, kPlotHeight, palette);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  for (const Bars& series : bars) {
    const int highest = std::max(1, *std::max_element(series.counts.begin(), series.counts.end()));
    const float width = (box.width() - 2) / static_cast<float>(series.counts.size());
    for (std::size_t i = 0; i < series.counts.size(); ++i) {
      if (series.counts[i] == 0) continue;
      const float share = static_cast<float>(series.counts[i]) / static_cast<float>(highest);
      const float x = box.min.x + 1 + width * static_cast<float>(i);
      draw->AddRectFilled(ImVec2(x, box.max.y - 1 - std::max(1.0f, share * (box.height() - 4))),
                          ImVec2(x + std::max(1.0f, width - 0.5f), box.max.y - 1),
                          withAlpha(series.colour, bars.size() > 1 ? 190 : 255));
    }
  }
  if (ImGui::IsItemHovered()) {
    const float share = std::clamp((ImGui::GetIO().MousePos.x - box.min.x) / box.width(), 0.0f, 0.999f);
    std::string text = numberText(range.lowest + share * (range.highest - range.lowest), unit);
    for (const Bars& series : bars)
      text += "\n" + phrase("{} values",
                            series.counts[static_cast<std::size_t>(share * static_cast<float>(series.counts.size()))]);
    ImGui::SetTooltip("%s", text.c_str());
  }
  writeEnds(numberText(range.lowest, unit), numberText(range.highest, unit), palette);
}

void colourBar(ColourScale scale, ValueRange range, const char* unit, const InspectorPalette& palette) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  constexpr int kSteps = 48;
  for (int i = 0; i < kSteps; ++i) {
    const Rgb8 from = colourAt(scale, static_cast<double>(i) / kSteps);
    const Rgb8 to = colourAt(scale, static_cast<double>(i + 1) / kSteps);
    const ImU32 left = IM_COL32(from[0], from[1], from[2], 255), right = IM_COL32(to[0], to[1], to[2], 255);
    ImGui::GetWindowDrawList()->AddRectFilledMultiColor(
        ImVec2(at.x + width * static_cast<float>(i) / kSteps, at.y),
        ImVec2(at.x + width * static_cast<float>(i + 1) / kSteps, at.y + 10), left, right, right, left);
  }
  ImGui::Dummy(ImVec2(width, 10));
  writeEnds(numberText(range.lowest, unit), numberText(range.highest, unit), palette);
}

}  // namespace qrelief
