// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspector/inspector.h"

#include <algorithm>
#include <cmath>
#include <imgui_impl_opengl3.h>

#include "base/clock.h"
#include "engine/answers.h"
#include "inspector/setting_labels.h"

namespace qrelief {
namespace {

constexpr float kMostWidth = 400, kMostHeight = 720;  // of the window when it opens
constexpr float kScrollLinePx = 40;
constexpr float kScrollDragPx = 6;

const char* cursorName() {
  switch (ImGui::GetMouseCursor()) {
    case ImGuiMouseCursor_TextInput:
      return "text";
    case ImGuiMouseCursor_ResizeEW:
      return "ew-resize";
    case ImGuiMouseCursor_ResizeNS:
      return "ns-resize";
    case ImGuiMouseCursor_ResizeNWSE:
      return "nwse-resize";
    case ImGuiMouseCursor_ResizeNESW:
      return "nesw-resize";
    default:
      return "default";
  }
}

std::optional<ImGuiKey> keyByName(const std::string& name) {
  static const std::map<std::string, ImGuiKey> kKeys = {{"Tab", ImGuiKey_Tab},
                                                        {"ArrowLeft", ImGuiKey_LeftArrow},
                                                        {"ArrowRight", ImGuiKey_RightArrow},
                                                        {"ArrowUp", ImGuiKey_UpArrow},
                                                        {"ArrowDown", ImGuiKey_DownArrow},
                                                        {"PageUp", ImGuiKey_PageUp},
                                                        {"PageDown", ImGuiKey_PageDown},
                                                        {"Home", ImGuiKey_Home},
                                                        {"End", ImGuiKey_End},
                                                        {"Delete", ImGuiKey_Delete},
                                                        {"Backspace", ImGuiKey_Backspace},
                                                        {"Enter", ImGuiKey_Enter},
                                                        {"Escape", ImGuiKey_Escape},
                                                        {"a", ImGuiKey_A},
                                                        {"c", ImGuiKey_C},
                                                        {"v", ImGuiKey_V},
                                                        {"x", ImGuiKey_X},
                                                        {"y", ImGuiKey_Y},
                                                        {"z", ImGuiKey_Z}};
  const auto key = kKeys.find(name);
  return key == kKeys.end() ? std::optional<ImGuiKey>() : key->second;
}

Json jsonOf(const std::optional<float>& value) { return value ? Json(*value) : Json(); }

Json jsonOf(const std::optional<SubmoduleFacts>& facts) {
  if (!facts) return {};
  return {{"row", facts->place.row},
          {"column", facts->place.column},
          {"role", facts->inSymbol ? moduleRoleName(facts->role) : "quiet zone"},
          {"carved", facts->carved},
          {"LS", facts->luminance},
          {"AL", jsonOf(facts->around)},
          {"G", jsonOf(facts->excess)},
          {"depthMm", jsonOf(facts->depthMm)},
          {"limitMm", jsonOf(facts->limitMm)}};
}

}  // namespace

std::unique_ptr<InspectorWindow> makeInspector() { return std::make_unique<Inspector>(); }

Inspector::Inspector() {
  IMGUI_CHECKVERSION();
  context_ = ImGui::CreateContext();
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // there is no file system
  io.MousePos = ImVec2(-FLT_MAX, -FLT_MAX);
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  for (int key = 0; key < ImGuiKey_COUNT; ++key) io.KeyMap[key] = key;
  ImGui_ImplOpenGL3_Init("#version 300 es");
  setTheme(true);
}

Inspector::~Inspector() {
  ImGui::SetCurrentContext(context_);
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext(context_);
}

void Inspector::resize(double width, double height, double devicePixelRatio) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = ImVec2(static_cast<float>(width), static_cast<float>(height));
  const auto scale = static_cast<float>(devicePixelRatio);
  io.DisplayFramebufferScale = ImVec2(scale, scale);
  fontIsStale_ = fontIsStale_ || devicePixelRatio != devicePixelRatio_;
  devicePixelRatio_ = devicePixelRatio;
  framesWanted_ = 2;
}

void Inspector::setFreeArea(double x, double y, double width, double height) {
  const std::array<float, 4> area = {static_cast<float>(x), static_cast<float>(y), static_cast<float>(width),
                                     static_cast<float>(height)};
  placeWindow_ = placeWindow_ || area != freeArea_;
  freeArea_ = area;
  framesWanted_ = 2;
}

void Inspector::setTheme(bool dark) {
  styleInspector(dark);
  palette_ = InspectorPalette::of(dark);
  framesWanted_ = 2;
}

void Inspector::setGlyphs(DrawnGlyphs glyphs) {
  glyphs_ = std::move(glyphs);
  fontIsStale_ = true;
  framesWanted_ = 2;
}

void Inspector::buildFont() {
  if (!fontIsStale_) return;
  ImGuiIO& io = ImGui::GetIO();
  const auto ratio = static_cast<float>(devicePixelRatio_);
  ImFontConfig config;
  config.SizePixels = glyphs_.glyphs.empty() ? std::round(13 * ratio) : std::round(glyphs_.lineHeight);
  io.Fonts->Clear();
  ImFont* font = io.Fonts->AddFontDefault(&config);  // for characters without a glyph
  std::vector<int> places;
  for (const DrawnGlyphs::Glyph& glyph : glyphs_.glyphs)
    places.push_back(io.Fonts->AddCustomRectFontGlyph(font, static_cast<ImWchar>(glyph.codePoint),
                                                      std::max(1, glyph.width), std::max(1, glyph.height),
                                                      glyph.advance, ImVec2(glyph.left, glyph.top)));
  io.Fonts->Build();
  unsigned char* texels = nullptr;
  int width = 0;
  io.Fonts->GetTexDataAsAlpha8(&texels, &width, nullptr);
  const std::uint8_t* drawn = glyphs_.alpha.data();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const ImFontAtlasCustomRect* place = io.Fonts->GetCustomRectByIndex(places[i]);
    const DrawnGlyphs::Glyph& glyph = glyphs_.glyphs[i];
    for (int row = 0; row < glyph.height; ++row, drawn += glyph.width)
      std::copy_n(drawn, glyph.width, texels + (place->Y + row) * width + place->X);
  }
  io.FontGlobalScale = 1 / ratio;
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
  fontIsStale_ = false;
}

bool Inspector::pointer(double x, double y, int buttons, double wheel) {
  inputs_.push_back({x, y, buttons, wheel, {}, false, false});
  framesWanted_ = 2;
  // Not WantCaptureMouse, which refers to the pointer's position in the last frame.
  const bool isOver = x >= windowMin_.x && x < windowMax_.x && y >= windowMin_.y && y < windowMax_.y;
  const ImGuiIO& io = ImGui::GetIO();
  const bool drags = io.MouseDown[0] && io.MouseDownOwned[0];
  return isOver || drags || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
}

void Inspector::key(const std::string& key, bool control, bool shift) {
  const Input last = inputs_.empty() ? pointer_ : inputs_.back();
  inputs_.push_back({last.x, last.y, last.buttons, 0, key, control, shift});
  framesWanted_ = 2;
}

/// Passes on the input since the last frame, up to the first press or release. A frame sees only one of them, so that
/// none is lost however slow the frames are.
void Inspector::takeInput() {
  ImGuiIO& io = ImGui::GetIO();
  io.MouseWheel = 0;
  io.KeyCtrl = io.KeyShift = false;
  const bool keyWasDown = std::find(std::begin(io.KeysDown), std::end(io.KeysDown), true) != std::end(io.KeysDown);
  std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
  if (keyWasDown) return;  // now it is up, so that the same key can come again
  bool moved = false;
  while (!inputs_.empty()) {
    const Input input = inputs_.front();
    const bool changes = input.buttons != pointer_.buttons;
    moved = moved || input.x != pointer_.x || input.y != pointer_.y;
    io.MousePos = ImVec2(static_cast<float>(input.x), static_cast<float>(input.y));
    if (changes && moved) {  // some controls take a press only after the pointer moved onto them, which fingers never
                             // do
      pointer_.x = input.x;
      pointer_.y = input.y;
      return;
    }
    inputs_.pop_front();
    pointer_ = input;
    io.MouseDown[0] = (input.buttons & 1) != 0;
    io.MouseDown[1] = (input.buttons & 2) != 0;
    io.MouseDown[2] = (input.buttons & 4) != 0;
    io.MouseWheel += static_cast<float>(input.wheel);
    io.KeyCtrl = input.control;
    io.KeyShift = input.shift;
    const auto known = keyByName(input.key);
    if (known && (input.key.size() > 1 || input.control)) {
      io.KeysDown[*known] = true;
      return;
    }
    if (!input.control && input.key.size() <= 4) io.AddInputCharactersUTF8(input.key.c_str());  // longer: name of a key
    if (changes) return;
  }
}

bool Inspector::pickSubmodule(const Engine& engine, double x, double y) {
  const auto place = engine.codePlaceAt(x, y);
  if (!place || !model_.search()) return false;
  model_.select(model_.search()->placeAt(*place));
  openMaps_ = true;
  framesWanted_ = 2;
  return true;
}

void Inspector::beginFrame() {
  ImGuiIO& io = ImGui::GetIO();
  const double now = nowMs();
  io.DeltaTime = lastFrameMs_ > 0 ? static_cast<float>(std::clamp((now - lastFrameMs_) / 1000, 1e-4, 0.2)) : 1.0f / 60;
  lastFrameMs_ = now;
  ImGui_ImplOpenGL3_NewFrame();
  buildFont();
  takeInput();
  controls_.clear();
  figures_.clear();
  ImGui::NewFrame();
}

void Inspector::endFrame() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  const ImGuiIO& io = ImGui::GetIO();
  const bool keyIsDown = std::find(std::begin(io.KeysDown), std::end(io.KeysDown), true) != std::end(io.KeysDown);
  framesWanted_ = !inputs_.empty() || keyIsDown ? 2 : std::max(0, framesWanted_ - 1);
}

bool Inspector::tab(const char* name) {
  const bool opensMaps = openMaps_ && std::string_view(name) == "Maps";
  const bool open = ImGui::BeginTabItem(label(name).c_str(), nullptr, opensMaps ? ImGuiTabItemFlags_SetSelected : 0);
  noteControl(controls_, name);
  if (opensMaps) openMaps_ = false;
  if (open) tab_ = name;
  return open;
}

/// Scrolls the window's body: by the wheel, unless it is over the map and zooms, or by dragging off all controls, for
/// fingers.
void Inspector::scrollBody() {
  const ImGuiIO& io = ImGui::GetIO();
  const bool hovered = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  if (hovered && !mapIsHovered_ && io.MouseWheel != 0)
    ImGui::SetScrollY(ImGui::GetScrollY() - io.MouseWheel * kScrollLinePx);
  if (ImGui::IsMouseClicked(0)) scrolls_ = hovered && !ImGui::IsAnyItemHovered() && !ImGui::IsAnyItemActive();
  if (scrolls_ && ImGui::IsMouseDragging(0, kScrollDragPx)) ImGui::SetScrollY(ImGui::GetScrollY() - io.MouseDelta.y);
}

void Inspector::drawWindow(const Engine& engine) {
  const ImVec2 place(freeArea_[0], freeArea_[1]);
  const ImVec2 most(std::max(200.0f, std::min(kMostWidth, freeArea_[2])),
                    std::max(160.0f, std::min(kMostHeight, freeArea_[3])));
  ImGui::SetNextWindowPos(place, placeWindow_ ? ImGuiCond_Always : ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSize(most, placeWindow_ ? ImGuiCond_Always : ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSizeConstraints(ImVec2(220, 120), ImGui::GetIO().DisplaySize);
  placeWindow_ = false;
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoScrollbar;
  const bool open = ImGui::Begin(label("Inspector").c_str(), nullptr, kFlags);
  const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  windowMin_ = {at.x, at.y};
  windowMax_ = {at.x + size.x, at.y + size.y};
  if (open && ImGui::BeginTabBar("tabs")) {
    const std::array<std::pair<const char*, void (Inspector::*)(const Engine&)>, 4> tabs = {
        {{"Maps", &Inspector::drawMaps},
         {"Search", &Inspector::drawSearch},
         {"Timing", &Inspector::drawTimings},
         {"Settings", &Inspector::drawSettings}}};
    for (const auto& [name, drawBody] : tabs) {
      if (!tab(name)) continue;
      ImGui::BeginChild(name, ImVec2(0, 0), false, ImGuiWindowFlags_NoScrollWithMouse);
      (this->*drawBody)(engine);
      scrollBody();
      ImGui::EndChild();
      ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
  }
  ImGui::End();
}

bool Inspector::draw(const Engine& engine) {
  model_.follow(engine);
  if (engine.carvings().passTimings()) engine.carvings().passTimings()->collect();
  mapIsHovered_ = false;
  beginFrame();
  drawWindow(engine);
  endFrame();
  return framesWanted_ > 0;
}

std::string Inspector::state() const {
  Json controls = Json::object();
  for (const auto& [name, area] : controls_) controls[name] = area;
  const ImGuiIO& io = ImGui::GetIO();
  return textOf({{"tab", tab_},
                 {"channel", infoOf(static_cast<MapChannel>(channel_)).name},
                 {"pass", model_.passes() ? model_.pass() + 1 : 0},
                 {"passes", model_.passes()},
                 {"selected", jsonOf(model_.selected())},
                 {"overridden", model_.overrides().count()},
                 {"overrides", describe(model_.overrides())},
                 {"engraveAsked", engraveAsked_},
                 {"keyboard", io.WantTextInput},
                 {"cursor", io.WantCaptureMouse ? cursorName() : ""},
                 {"window", {windowMin_.x, windowMin_.y, windowMax_.x - windowMin_.x, windowMax_.y - windowMin_.y}},
                 {"figures", figures_},
                 {"controls", controls}});
}

}  // namespace qrelief
