// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the inspector's settings: every setting of a request, as overrides of the page's controls.
#include <cmath>
#include <string_view>

#include "inspector/inspector.h"
#include "inspector/setting_labels.h"

namespace qrelief {
namespace {

/// @returns true if the value was changed
bool edit(const Tunable& tunable, double& value) {
  ImGui::SetNextItemWidth(-1);
  if (tunable.isSwitch) {
    bool on = value != 0;
    const bool changed = ImGui::Checkbox("##value", &on);
    value = on ? 1 : 0;
    return changed;
  }
  if (!tunable.choices.empty()) {
    int chosen = static_cast<int>(value);
    const std::vector<std::string> labels = choiceLabelsOf(tunable);
    std::vector<const char*> choices;
    for (const std::string& label : labels) choices.push_back(label.c_str());
    const bool changed = ImGui::Combo("##value", &chosen, choices.data(), static_cast<int>(choices.size()));
    value = chosen;
    return changed;
  }
  // Buttons next to the field, for touch screens without keys.
  ImGui::InputDouble("##value", &value, tunable.step, 0, "%.6g");
  return ImGui::IsItemDeactivatedAfterEdit();
}

}  // namespace

void Inspector::drawTunable(std::size_t index, const EngraveRequest& page) {
  const Tunable& tunable = tunables()[index];
  RequestOverrides& overrides = model_.overrides();
  const bool isSet = overrides.isSet(index);
  ImGui::PushID(static_cast<int>(index));
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  const std::string name = labelOf(tunable);
  if (isSet) ImGui::PushStyleColor(ImGuiCol_Text, palette_.accent);
  ImGui::TextUnformatted(name.c_str());
  if (isSet) ImGui::PopStyleColor();
  ImGui::TableNextColumn();
  double value = overrides.valueOf(index, page);
  const bool changed = edit(tunable, value);
  noteControl(controls_, tunable.key);
  if (changed) overrides.set(index, value, page);
  figures_.push_back({name, valueText(tunable, value)});
  if (isSet) {
    if (ImGui::SmallButton(label("reset").c_str())) overrides.reset(index);
    noteControl(controls_, fmt::format("Reset {}", tunable.key));
    ImGui::SameLine();
    ImGui::TextDisabled("%s", phrase("page: {}", valueText(tunable, tunable.read(page))).c_str());
  }
  ImGui::PopID();
}

void Inspector::drawSettings(const Engine& engine) {
  RequestOverrides& overrides = model_.overrides();
  const std::size_t count = overrides.count();
  if (ImGui::Button(label("Engrave again").c_str(), ImVec2(ImGui::GetContentRegionAvail().x * 0.53f, 0)))
    ++engraveAsked_;
  noteControl(controls_, "Engrave again");
  ImGui::SameLine();
  ImGui::BeginDisabled(count == 0);
  if (ImGui::Button(label("Reset all").c_str(), ImVec2(-1, 0))) overrides.resetAll();
  noteControl(controls_, "Reset all");
  ImGui::EndDisabled();
  if (count == 0)
    writeSoftly("All settings are as on the page. Changes here apply only to Engrave again.");
  else if (count == 1)
    write("One setting is changed here, only for Engrave again: the page's Engrave ignores it.");
  else
    write("{} settings are changed here, only for Engrave again: the page's Engrave ignores them.", count);
  ImGui::BeginChild("tunables", ImVec2(0, 0), false, ImGuiWindowFlags_NoScrollWithMouse);
  std::string_view group;
  const std::span<const Tunable> all = tunables();
  bool open = false;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Setting& setting = *all[i].setting;
    if (setting.group != group) {
      if (open) ImGui::EndTable();
      group = setting.group;
      ImGui::Spacing();
      ImGui::TextDisabled("%s", groupLabelOf(setting).c_str());
      open = ImGui::BeginTable(setting.group.c_str(), 2, ImGuiTableFlags_SizingStretchProp);
      if (open) {
        ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, 0.48f);
        ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch, 0.52f);
      }
    }
    if (open) drawTunable(i, engine.settings());
  }
  if (open) ImGui::EndTable();
  scrollBody();
  ImGui::EndChild();
}

}  // namespace qrelief
