// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gl/objects.h"
#include "inspector/inspector_model.h"
#include "inspector/inspector_widgets.h"
#include "inspector/inspector_window.h"
#include "viewer/colour_scale.h"

struct ImGuiContext;

namespace qrelief {

/// The inspector, drawn with Dear ImGui.
class Inspector : public InspectorWindow {
 public:
  Inspector();
  ~Inspector() override;
  Inspector(const Inspector&) = delete;
  Inspector& operator=(const Inspector&) = delete;

  void resize(double width, double height, double devicePixelRatio) override;
  void setFreeArea(double x, double y, double width, double height) override;
  void setTheme(bool dark) override;
  void setGlyphs(DrawnGlyphs glyphs) override;
  bool pointer(double x, double y, int buttons, double wheel) override;
  void key(const std::string& key, bool control, bool shift) override;
  bool pickSubmodule(const Engine& engine, double x, double y) override;
  bool draw(const Engine& engine) override;
  std::string state() const override;
  const RequestOverrides& overrides() const override { return model_.overrides(); }

 private:
  enum class Range { Whole, Cut, Own };
  /// A pointer event or, if `key` is not empty, a key event.
  struct Input {
    double x = -1e6, y = -1e6;
    int buttons = 0;
    double wheel = 0;
    std::string key;
    bool control = false, shift = false;
  };
  /// Writes translated text and notes it as a figure. ImGui takes printf formats; these formats are checked at compile
  /// time.
  template <class... Args>
  void write(fmt::format_string<Args...> format, Args&&... args) {
    figures_.push_back({phrase(format, std::forward<Args>(args)...)});
    writeWrapped(figures_.back().front(), false);
  }
  /// Writes the same in the soft ink.
  template <class... Args>
  void writeSoftly(fmt::format_string<Args...> format, Args&&... args) {
    figures_.push_back({phrase(format, std::forward<Args>(args)...)});
    writeWrapped(figures_.back().front(), true);
  }
  void fact(const char* name, const std::string& value);
  void buildFont();
  void takeInput();
  void beginFrame();
  void endFrame();
  void drawWindow(const Engine& engine);
  void scrollBody();
  bool tab(const char* name);

  void drawMaps(const Engine& engine);
  void chooseChannel();
  void choosePass();
  void chooseRange(const ValueMap& map);
  void drawMap(const ValueMap& map);
  void moveMap(Vec2 pointer, float edge);
  void drawMapMarks(const ValueMap& map, ImVec2 corner, float edge);
  void drawZoom(const ValueMap& map);
  void drawFacts();
  void drawChannelHistogram(const ValueMap& map);

  void drawSearch(const Engine& engine);
  void drawRuns();
  void drawLuminances();
  void drawTimings(const Engine& engine);
  void drawSettings(const Engine& engine);
  void drawTunable(std::size_t index, const EngraveRequest& page);

  InspectorModel model_;
  ImGuiContext* context_ = nullptr;
  InspectorPalette palette_ = InspectorPalette::of(false);
  DrawnGlyphs glyphs_;
  double devicePixelRatio_ = 1;
  bool fontIsStale_ = true;
  std::deque<Input> inputs_;   // not processed by a frame yet
  Input pointer_;              // the last one processed
  bool mapIsHovered_ = false;  // so the wheel zooms the map
  bool scrolls_ = false;       // a drag that began off all controls scrolls
  Vec2 windowMin_{0}, windowMax_{0};
  std::array<float, 4> freeArea_{12, 12, 380, 640};
  bool placeWindow_ = true;
  int framesWanted_ = 0;  // ImGui lays out a change only in the frame after it
  double lastFrameMs_ = 0;

  std::string tab_;
  bool openMaps_ = false;
  int channel_ = static_cast<int>(MapChannel::Depth);
  ColourScale scale_ = ColourScale::Viridis;
  bool showsDirections_ = true;
  Range rangeKind_ = Range::Whole;
  ValueRange range_;
  Vec2 mapCentre_{0.5};
  double mapZoom_ = 1;
  bool mapMoved_ = false;
  std::optional<Vec2> mapPointer_;  // position in the map
  std::optional<gl::Texture> picture_;
  struct PictureKey {
    int version;
    ColourScale scale;
    bool directions;
    ValueRange range;
    bool operator==(const PictureKey&) const = default;
  };
  std::optional<PictureKey> pictureKey_;
  int engraveAsked_ = 0;
  ControlAreas controls_;
  std::vector<std::vector<std::string>> figures_;  // rows of texts of the last frame, for those who cannot see it
};

}  // namespace qrelief
