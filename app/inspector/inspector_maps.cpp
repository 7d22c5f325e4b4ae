// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the inspector's maps: one channel at a time, its colours, its histogram, and the selected submodule.
#include <algorithm>
#include <cmath>

#include "inspector/inspector.h"
#include "inspector/value_map.h"
#include "qr/module_pattern.h"

namespace qrelief {
namespace {

constexpr double kCutShare = 0.01;
constexpr double kMostZoom = 64;
constexpr double kWheelZoom = 1.2, kButtonZoom = 1.6;
constexpr float kPanDragPx = 4;
constexpr float kBesideMapPx = 300, kLeastMapPx = 200;  // height left for the facts about the map; least edge of the
                                                        // map

ImTextureID textureId(const gl::Texture& texture) {
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture.id()));
}

std::string known(const std::optional<float>& value, const char* unit = "") {
  return value ? numberText(static_cast<double>(*value), unit) : "-";
}

}  // namespace

void Inspector::chooseChannel() {
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::SetNextItemWidth(width * 0.62f);
  const bool open = ImGui::BeginCombo("##channel", translated(infoOf(static_cast<MapChannel>(channel_)).name),
                                      ImGuiComboFlags_HeightLargest);
  noteControl(controls_, "Channel");
  if (open) {
    for (int i = 0; i < static_cast<int>(kChannels.size()); ++i) {
      if (i == static_cast<int>(MapChannel::Limit)) ImGui::Separator();
      if (ImGui::Selectable(translated(kChannels[i].name), i == channel_)) {
        channel_ = i;
        rangeKind_ = Range::Whole;
        scale_ = kChannels[i].isSigned ? ColourScale::BlueRed : ColourScale::Viridis;
      }
      noteControl(controls_, kChannels[i].name);
    }
    ImGui::EndCombo();
  }
  ImGui::SameLine();
  int scale = static_cast<int>(scale_);
  ImGui::SetNextItemWidth(-1);
  const auto scales = translated(kColourScaleNames);
  if (ImGui::Combo("##scale", &scale, scales.data(), static_cast<int>(scales.size())))
    scale_ = static_cast<ColourScale>(scale);
  noteControl(controls_, "Colours");
  writeSoftly("{}", translated(infoOf(static_cast<MapChannel>(channel_)).what));
}

void Inspector::choosePass() {
  if (!infoOf(static_cast<MapChannel>(channel_)).changesByPass || model_.passes() == 0) return;
  if (ImGui::ArrowButton("earlier", ImGuiDir_Left)) model_.setPass(model_.pass() - 1);
  noteControl(controls_, "Earlier pass");
  ImGui::SameLine();
  int pass = model_.pass() + 1;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight() - 8);
  const std::string format = phrase("pass %d of {}", model_.passes());
  if (ImGui::SliderInt("##pass", &pass, 1, model_.passes(), format.c_str(), ImGuiSliderFlags_NoInput))
    model_.setPass(pass - 1);
  noteControl(controls_, "Pass");
  ImGui::SameLine();
  if (ImGui::ArrowButton("later", ImGuiDir_Right)) model_.setPass(model_.pass() + 1);
  noteControl(controls_, "Later pass");
}

void Inspector::chooseRange(const ValueMap& map) {
  if (rangeKind_ != Range::Own) {
    range_ = rangeOf(map.values, rangeKind_ == Range::Cut ? kCutShare : 0).value_or(ValueRange{});
    if (infoOf(static_cast<MapChannel>(channel_)).isSigned && scale_ == ColourScale::BlueRed) {
      const float reach = std::max(std::abs(range_.lowest), std::abs(range_.highest));
      range_ = {-reach, reach};
    }
  }
  const std::array<const char*, 3> kinds = {translated("whole range"), translated("without 1 % at each end"),
                                            translated("manual range")};
  int kind = static_cast<int>(rangeKind_);
  ImGui::SetNextItemWidth(-1);
  if (ImGui::Combo("##range", &kind, kinds.data(), static_cast<int>(kinds.size())))
    rangeKind_ = static_cast<Range>(kind);
  noteControl(controls_, "Range");
  if (rangeKind_ == Range::Own) {
    ImGui::SetNextItemWidth(-1);
    ImGui::InputFloat2("##own", &range_.lowest, "%.4f");
    noteControl(controls_, "Range by hand");
    range_.highest = std::max(range_.highest, range_.lowest);
  }
}

/// Moves the map: the wheel zooms about the pointer, a drag pans, a click selects.
void Inspector::moveMap(Vec2 pointer, float edge) {
  const ImGuiIO& io = ImGui::GetIO();
  const auto inMap = [&] { return mapCentre_ + (pointer - 0.5) / mapZoom_; };
  if (ImGui::IsItemHovered()) {
    mapIsHovered_ = true;
    mapPointer_ = inMap();
    if (io.MouseWheel != 0) {
      const Vec2 place = inMap();
      mapZoom_ = std::clamp(mapZoom_ * std::pow(kWheelZoom, static_cast<double>(io.MouseWheel)), 1.0, kMostZoom);
      mapCentre_ = place - (pointer - 0.5) / mapZoom_;
    }
  }
  if (ImGui::IsItemActivated()) mapMoved_ = false;
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0, kPanDragPx)) {
    mapMoved_ = true;
    mapCentre_ -= Vec2(io.MouseDelta.x, io.MouseDelta.y) / (mapZoom_ * edge);
  }
  if (ImGui::IsItemDeactivated() && !mapMoved_ && model_.search()) model_.select(model_.search()->placeAt(inMap()));
  const double half = 0.5 / mapZoom_;
  mapCentre_ = glm::clamp(mapCentre_, Vec2(half), Vec2(1 - half));
}

/// Marks the selected submodule and the one under the pointer, if they are large enough to see.
void Inspector::drawMapMarks(const ValueMap& map, ImVec2 corner, float edge) {
  const SearchView* search = model_.search();
  if (!search) return;
  const int cells = search->edge(), quiet = kSubmodulesPerModule * kQuietZoneModules;
  const float cell = edge * static_cast<float>(mapZoom_) / static_cast<float>(cells);
  const auto frame = [&](SubmodulePlace place, ImU32 colour, float grow) {
    const auto toScreen = [&](double share, double centre) {
      return static_cast<float>((share - centre) * mapZoom_ + 0.5) * edge;
    };
    const ImVec2 min(corner.x + toScreen(static_cast<double>(place.column + quiet) / cells, mapCentre_.x) - grow,
                     corner.y + toScreen(static_cast<double>(place.row + quiet) / cells, mapCentre_.y) - grow);
    ImGui::GetWindowDrawList()->AddRect(min, ImVec2(min.x + cell + 2 * grow, min.y + cell + 2 * grow), colour, 0, 0, 2);
  };
  ImGui::PushClipRect(corner, ImVec2(corner.x + edge, corner.y + edge), true);
  if (const auto selected = model_.selected()) {
    frame(selected->place, IM_COL32(0, 0, 0, 255), 4);
    frame(selected->place, IM_COL32(255, 255, 255, 255), 2);
  }
  ImGui::PopClipRect();
  std::string text = translated("point at the map to read a value");
  if (mapPointer_) {
    const auto index = map.indexAt(*mapPointer_);
    const auto place = search->placeAt(*mapPointer_);
    if (index && place) {
      const ChannelInfo& info = infoOf(static_cast<MapChannel>(channel_));
      text = phrase("row {}, column {}: {}", place->row, place->column,
                    numberText(static_cast<double>(map.values[*index]), info.unit));
      if (!map.directions.empty() && std::isfinite(map.values[*index])) {
        const Vec3f n = map.directions[*index];
        text += fmt::format(" ({:.3f}, {:.3f}, {:.3f})", n.x, n.y, n.z);
      }
    }
  }
  writeSoftly("{}", text);
}

void Inspector::drawZoom(const ValueMap& map) {
  const auto zoomTo = [&](double zoom) { mapZoom_ = std::clamp(zoom, 1.0, kMostZoom); };
  if (ImGui::Button("-", ImVec2(32, 0))) zoomTo(mapZoom_ / kButtonZoom);
  noteControl(controls_, "Zoom out");
  ImGui::SameLine();
  if (ImGui::Button("+", ImVec2(32, 0))) zoomTo(mapZoom_ * kButtonZoom);
  noteControl(controls_, "Zoom in");
  ImGui::SameLine();
  if (ImGui::Button(label("All").c_str())) zoomTo(1);
  noteControl(controls_, "Whole map");
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%.1f×", mapZoom_);
  if (!map.directions.empty()) {
    ImGui::SameLine();
    ImGui::Checkbox(label("x, y, z as colours").c_str(), &showsDirections_);
    noteControl(controls_, "Directions as colours");
  }
}

void Inspector::drawMap(const ValueMap& map) {
  const PictureKey key{model_.channelVersion(), scale_, showsDirections_, range_};
  if (pictureKey_ != key || !picture_) {
    picture_ = mapPicture(map, {scale_, range_, showsDirections_});
    pictureKey_ = key;
  }
  const float room = ImGui::GetContentRegionAvail().x;
  const float edge =
      std::clamp(std::min(room, ImGui::GetWindowHeight() - kBesideMapPx), std::min(room, kLeastMapPx), 640.0f);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("map", ImVec2(edge, edge));
  noteControl(controls_, "Map");
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  mapPointer_.reset();
  moveMap({(mouse.x - corner.x) / edge, (mouse.y - corner.y) / edge}, edge);
  const double half = 0.5 / mapZoom_;
  const ImVec2 from(static_cast<float>(mapCentre_.x - half), static_cast<float>(mapCentre_.y - half));
  const ImVec2 to(static_cast<float>(mapCentre_.x + half), static_cast<float>(mapCentre_.y + half));
  const ImVec2 end(corner.x + edge, corner.y + edge);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(corner, end, IM_COL32(128, 128, 128, 60));
  draw->AddImage(textureId(*picture_), corner, end, from, to);
  draw->AddRect(corner, end, palette_.line);
  drawMapMarks(map, corner, edge);
}

void Inspector::fact(const char* name, const std::string& value) {
  if (!value.empty()) figures_.push_back({translated(name), value});
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", translated(name));
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(value.c_str());
}

void Inspector::drawFacts() {
  const auto facts = model_.selected();
  if (!facts) {
    writeSoftly("Click a submodule here or on the model to see its values in the search.");
    return;
  }
  ImGui::Separator();
  write("Submodule row {}, column {}: {}{}", facts->place.row, facts->place.column,
        translated(facts->inSymbol ? moduleRoleName(facts->role) : "quiet zone"),
        translated(facts->carved ? ", carved"
                   : facts->dark ? ", in a dark module, not carved"
                                 : ", light"));
  if (!ImGui::BeginTable("facts", 4)) return;
  fact("LS", numberText(static_cast<double>(facts->luminance)));
  fact("depth", known(facts->depthMm, "mm"));
  fact("AL", known(facts->around));
  fact("limit", known(facts->limitMm, "mm"));
  fact("G", known(facts->excess));
  const bool atLimit = facts->depthMm && *facts->limitMm - *facts->depthMm < 0.002f;
  const char* const end = *facts->excess <= 0 ? "dark enough" : atLimit ? "too bright, limited" : "too bright";
  fact("", facts->carved ? translated(end) : "");
  ImGui::EndTable();
}

void Inspector::drawChannelHistogram(const ValueMap& map) {
  const ChannelInfo& info = infoOf(static_cast<MapChannel>(channel_));
  const Bars bars{histogramOf(map.values, range_, kBars), palette_.accent};
  plotBars("##histogram", std::span(&bars, 1), range_, info.unit, palette_);
}

void Inspector::drawMaps(const Engine& engine) {
  chooseChannel();
  choosePass();
  const ValueMap* map = model_.channel(engine, static_cast<MapChannel>(channel_));
  if (!map) {
    ImGui::Separator();
    if (model_.search())
      write("This map appears when the engraving is done.");
    else
      write("Nothing to see yet: press Engrave.");
    return;
  }
  drawMap(*map);
  drawZoom(*map);
  const bool asDirections = showsDirections_ && !map->directions.empty();
  const ChannelInfo& info = infoOf(static_cast<MapChannel>(channel_));
  if (!asDirections) colourBar(scale_, range_, info.unit, palette_);
  figures_.push_back(
      {translated(info.name), numberText(range_.lowest, info.unit) + " … " + numberText(range_.highest, info.unit)});
  drawFacts();
  ImGui::Separator();
  chooseRange(*map);
  drawChannelHistogram(*map);
}

}  // namespace qrelief
