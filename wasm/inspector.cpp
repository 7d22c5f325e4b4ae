// SPDX-License-Identifier: GPL-3.0-or-later
#include "wasm/inspector.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_impl_opengl3.h>

namespace qrelief {
namespace {

constexpr double kRefreshMs = 400;  // how often a running job's map is looked at: reading it back stalls the GPU
constexpr int kPictureTexels = 512;
constexpr float kFontPx = 13;

struct MapKind {
  const char* tab;
  const char* what;
  MapReading reading;
};

constexpr std::array<MapKind, 4> kKinds = {{
    {"Normals", "facet normals, as seen by the reader", {true, 0, true, false}},
    {"Heights", "height over the QR plane, mm", {false, 3, true, false}},
    {"Luminance", "under a uniform sky, 1 = unoccluded", {false, 0, false, false}},
    {"Depth", "carving depth, mm", {false, 0, false, false}},
}};

double nowMs() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// ImGui takes printf formats; ours are checked at compile time instead.
template <class... Args>
void write(fmt::format_string<Args...> format, Args&&... args) {
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(fmt::format(format, std::forward<Args>(args)...).c_str());
  ImGui::PopTextWrapPos();
}

}  // namespace

Inspector::Inspector() {
  IMGUI_CHECKVERSION();
  context_ = ImGui::CreateContext();
  ImGui::SetCurrentContext(context_);
  ImGui::GetIO().IniFilename = nullptr;  // there is no file system
  ImGui::GetIO().MousePos = ImVec2(-FLT_MAX, -FLT_MAX);
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

void Inspector::setTheme(bool dark) {
  dark ? ImGui::StyleColorsDark() : ImGui::StyleColorsLight();
  ImGui::GetStyle().WindowRounding = 6;
  framesWanted_ = 2;
}

void Inspector::buildFont() {
  if (!fontIsStale_) return;
  ImGuiIO& io = ImGui::GetIO();
  ImFontConfig config;
  config.SizePixels = std::round(kFontPx * static_cast<float>(devicePixelRatio_));
  io.Fonts->Clear();
  io.Fonts->AddFontDefault(&config);
  io.FontGlobalScale = kFontPx / config.SizePixels;
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
  fontIsStale_ = false;
}

bool Inspector::pointer(double x, double y, int buttons, double wheel) {
  ImGuiIO& io = ImGui::GetIO();
  io.MousePos = ImVec2(static_cast<float>(x), static_cast<float>(y));
  pressed_ = pressed_ || (buttons & 1);
  io.MouseDown[0] = pressed_;
  io.MouseDown[1] = (buttons & 2) != 0;
  io.MouseDown[2] = (buttons & 4) != 0;
  io.MouseWheel += static_cast<float>(wheel);
  framesWanted_ = 2;
  releasePending_ = !(buttons & 1);
  if (releasePending_ && !io.MouseDown[0]) pressed_ = false;
  // WantCaptureMouse is the last frame's; a finger comes without a hover before it, so its place counts as well.
  const bool isOver = x >= windowMin_.x && x < windowMax_.x && y >= windowMin_.y && y < windowMax_.y;
  return io.WantCaptureMouse || isOver;
}

void Inspector::refresh(const Engine& engine, Map map) {
  const InspectorMaps maps = engine.job() ? engine.job()->inspectorMaps() : InspectorMaps{};
  const gl::Texture* surface = maps.surface ? &maps.surface->surface : nullptr;
  const std::array<const gl::Texture*, 4> sources = {surface, surface, maps.luminance, maps.depths};
  const gl::Texture* source = sources[static_cast<std::size_t>(map)];
  if (!source || source->width() == 0) {
    picture_.reset();
    source_ = nullptr;
    return;
  }
  const bool isOld = !engine.result() && nowMs() - madeMs_ > kRefreshMs;
  const bool isFinal = engine.result() && !madeOfResult_;
  if (source == source_ && map == shown_ && !isOld && !isFinal) return;
  auto made = MapPicture::create(*source, kKinds[static_cast<std::size_t>(map)].reading, kPictureTexels);
  if (!made) {
    picture_.reset();
    return;
  }
  picture_ = std::move(*made);
  source_ = source;
  shown_ = map;
  madeMs_ = nowMs();
  madeOfResult_ = engine.result() != nullptr;
}

void Inspector::showValueUnderPointer(Map map, double across, double down) const {
  const float* texel = picture_->texelAt(across, down);
  if (!texel) {
    ImGui::TextDisabled("point at the map to read a value");
  } else if (map == Map::Normals) {
    write("normal {:.3f}, {:.3f}, {:.3f}", texel[0], texel[1], texel[2]);
  } else {
    write("value {:.4f}", texel[kKinds[static_cast<std::size_t>(map)].reading.component]);
  }
}

void Inspector::showMap(const Engine& engine, Map map) {
  refresh(engine, map);
  if (!picture_) {
    ImGui::TextWrapped("Nothing to see yet: press Engrave.");
    return;
  }
  ImGui::TextUnformatted(kKinds[static_cast<std::size_t>(map)].what);
  const float edge = std::clamp(ImGui::GetContentRegionAvail().x, 120.0f, 512.0f);
  const auto id = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(picture_->picture().id()));
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::Image(id, ImVec2(edge, edge), ImVec2(0, 1), ImVec2(1, 0));
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (map != Map::Normals) write("{:.3f} (blue) to {:.3f} (yellow)", picture_->lowest(), picture_->highest());
  showValueUnderPointer(map, (mouse.x - corner.x) / edge, (mouse.y - corner.y) / edge);
}

void Inspector::showTimings(const Engine& engine) const {
  write("{}", engine.gl().renderer);
  if (const Viewer* viewer = engine.viewer()) {
    const ViewStatistics& view = viewer->statistics();
    write("view: {} × {}, {} pictures averaged, {:.0f} ms a frame in motion", view.width, view.height, view.samples,
          view.coarseFrameMs);
  }
  if (const Placement* placed = engine.placed()) {
    ImGui::Separator();
    write("code: {:.2f} mm, modules {:.3f} mm, {} directions tried", placed->symbolMm, placed->moduleMm,
          placed->iterations.size());
    for (const DirectionIteration& i : placed->iterations)
      write("  variance {:.4f} mm², outside {:.1f} %", i.varianceMm2, 100 * i.outsideShare);
  }
  const EngraveResult* result = engine.result();
  if (!result) return;
  const StageTimings& t = result->timingsMs;
  ImGui::Separator();
  const std::array<std::pair<const char*, double>, 5> stages = {{{"direction", t.direction},
                                                                 {"size", t.size},
                                                                 {"depth search", t.depthSearch},
                                                                 {"embedding", t.embed},
                                                                 {"verification", t.verify}}};
  double longest = 1;
  for (const auto& stage : stages) longest = std::max(longest, stage.second);
  for (const auto& [name, ms] : stages)
    ImGui::ProgressBar(static_cast<float>(ms / longest), ImVec2(-1, 0), fmt::format("{} {:.0f} ms", name, ms).c_str());
  write("{} search iterations, {} submodules limited", result->searchIterations, result->limitedSubmodules);
}

bool Inspector::draw(const Engine& engine) {
  ImGuiIO& io = ImGui::GetIO();
  const double now = nowMs();
  io.DeltaTime = lastFrameMs_ > 0 ? static_cast<float>(std::clamp((now - lastFrameMs_) / 1000, 1e-4, 0.2)) : 1.0f / 60;
  lastFrameMs_ = now;
  ImGui_ImplOpenGL3_NewFrame();
  buildFont();
  ImGui::NewFrame();
  ImGui::SetNextWindowPos(ImVec2(12, 12), ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSize(ImVec2(std::min(320.0f, io.DisplaySize.x - 24), std::min(460.0f, io.DisplaySize.y - 24)),
                           ImGuiCond_FirstUseEver);
  if (ImGui::Begin("Inspector") && ImGui::BeginTabBar("maps")) {
    for (std::size_t i = 0; i < kKinds.size(); ++i) {
      if (!ImGui::BeginTabItem(kKinds[i].tab)) continue;
      showMap(engine, static_cast<Map>(i));
      ImGui::EndTabItem();
    }
    if (ImGui::BeginTabItem("Timing")) {
      showTimings(engine);
      ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
  }
  const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  windowMin_ = {at.x, at.y};
  windowMax_ = {at.x + size.x, at.y + size.y};
  ImGui::End();
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  if (releasePending_) {
    io.MouseDown[0] = false;
    pressed_ = false;
    releasePending_ = false;
  }
  io.MouseWheel = 0;
  framesWanted_ = std::max(0, framesWanted_ - 1);
  return framesWanted_ > 0;
}

}  // namespace qrelief
