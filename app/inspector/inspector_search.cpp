// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the inspector's view of the depth search (convergence by solver, luminance of the submodules) and of the times.
#include <algorithm>

#include "inspector/inspector.h"

namespace qrelief {
namespace {

template <class Value>
std::vector<double> valuesOf(const std::vector<PassSummary>& passes, Value value) {
  std::vector<double> values;
  for (const PassSummary& pass : passes) values.push_back(static_cast<double>(value(pass)));
  return values;
}

void swatch(ImU32 colour) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float size = ImGui::GetTextLineHeight() * 0.7f;
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(at.x, at.y + size * 0.2f), ImVec2(at.x + size, at.y + size * 1.2f),
                                            colour, 2);
  ImGui::Dummy(ImVec2(size, size));
  ImGui::SameLine();
}

}  // namespace

void Inspector::drawRuns() {
  const auto& runs = model_.runs();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!runs[i]) continue;
    swatch(palette_.curves[i]);
    write("{}: {} passes", runs[i]->name, runs[i]->passes.size());
  }
  if (std::count_if(runs.begin(), runs.end(), [](const auto& run) { return run.has_value(); }) < 2)
    writeSoftly("Engrave with another solver (Settings) to compare them here.");
  const auto plot = [&](const char* name, const char* unit, auto value) {
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (!runs[i]) continue;
      curves.push_back({valuesOf(runs[i]->passes, value), palette_.curves[i]});
      std::vector<std::string> figures = {fmt::format("{}, {}", translated(name), runs[i]->name)};
      for (const double one : curves.back().values) figures.push_back(numberText(one, unit));
      figures_.push_back(std::move(figures));
    }
    const int pointed = plotCurves(name, curves, unit, model_.pass(), palette_);
    noteControl(controls_, name);
    if (pointed >= 0 && ImGui::IsMouseClicked(0)) model_.setPass(pointed);
  };
  plot("Mean depth", "mm", [](const PassSummary& pass) { return pass.meanDepthMm; });
  plot("Too bright (G > 0)", "", [](const PassSummary& pass) { return pass.unmet; });
  plot("Greatest change of a depth", "mm", [](const PassSummary& pass) { return pass.changeMm; });
}

void Inspector::drawLuminances() {
  const SearchView& search = *model_.search();
  const auto& carved = search.carvedLuminance(model_.pass());
  std::vector<float> all = search.lightLuminance();
  all.insert(all.end(), carved.begin(), carved.end());
  const ValueRange range = rangeOf(all).value_or(ValueRange{});
  write("Luminance at pass {}", model_.pass() + 1);
  swatch(palette_.curves[0]);
  ImGui::TextUnformatted(translated("light modules"));
  ImGui::SameLine();
  swatch(palette_.curves[1]);
  ImGui::TextUnformatted(translated("carved submodules"));
  const std::array<Bars, 2> luminances = {{{histogramOf(search.lightLuminance(), range, kBars), palette_.curves[0]},
                                           {histogramOf(carved, range, kBars), palette_.curves[1]}}};
  plotBars("##luminances", luminances, range, "", palette_);
  write("Depth at pass {}", model_.pass() + 1);
  const auto& depths = search.carvedDepths(model_.pass());
  const ValueRange depthRange = rangeOf(depths).value_or(ValueRange{});
  const Bars bars{histogramOf(depths, depthRange, kBars), palette_.curves[1]};
  plotBars("##depths", std::span(&bars, 1), depthRange, "mm", palette_);
}

void Inspector::drawSearch(const Engine&) {
  const SearchView* search = model_.search();
  if (!search) {
    write("Nothing to see yet: press Engrave.");
    return;
  }
  drawRuns();
  ImGui::Separator();
  int pass = model_.pass() + 1;
  ImGui::SetNextItemWidth(-1);
  const std::string format = phrase("pass %d of {}", search->passes());
  if (ImGui::SliderInt("##pass", &pass, 1, search->passes(), format.c_str(), ImGuiSliderFlags_NoInput))
    model_.setPass(pass - 1);
  noteControl(controls_, "Pass");
  const PassSummary& summary = search->summaries()[model_.pass()];
  write("{} of {} carved submodules too bright, by {} at most; deepest {}; took {:.0f} ms", summary.unmet,
        search->carvedCount(), numberText(static_cast<double>(summary.greatestExcess)),
        numberText(static_cast<double>(summary.maxDepthMm), "mm"), summary.ms);
  drawLuminances();
}

void Inspector::drawTimings(const Engine& engine) {
  write("{}", engine.gl().renderer);
  if (const Viewer* viewer = engine.viewer()) {
    const ViewStatistics& view = viewer->statistics();
    writeSoftly("View: {} × {}, {} pictures averaged, {:.0f} ms per frame in motion", view.width, view.height,
                view.samples, view.coarseFrameMs);
  }
  if (const Placement* placed = engine.placed()) {
    writeSoftly("Code: {:.2f} mm, modules {:.3f} mm, {} directions tried", placed->symbolMm, placed->moduleMm,
                placed->iterations.size());
  }
  const EngraveResult* result = engine.carvings().result();
  if (!result) {
    ImGui::Separator();
    write("The times of stages and passes appear here after an engraving.");
    return;
  }
  writeSoftly("Light: {}", result->litByShaders ? engine.gl().renderer : std::string(gl::kProcessorName));
  ImGui::Separator();
  const auto stages = result->timingsMs.all();
  double longest = 1;
  for (const auto& [name, ms] : stages) longest = std::max(longest, ms);
  ImGui::TextUnformatted(translated("Stages, named as in the report"));
  for (const auto& [name, ms] : stages) {
    if (ms <= 0) continue;
    const std::string time = fmt::format("{:.1f} ms", ms);
    figures_.push_back({std::string(name), time});
    ImGui::ProgressBar(static_cast<float>(ms / longest), ImVec2(-1, 0), fmt::format("{} {}", name, time).c_str());
  }
  ImGui::Separator();
  const gl::PassTimings* timings = engine.carvings().passTimings();
  if (!timings || timings->times().empty()) {
    write("Passes are timed from the next engraving on, because the inspector was closed during the last one.");
    return;
  }
  ImGui::TextUnformatted(
      translated(timings->hasGpuTimes() ? "Passes, GPU time by timer queries" : "Passes, CPU time only"));
  if (!timings->hasGpuTimes())
    writeSoftly(
        "This browser has no timer queries. CPU time ends when the calls return; the GPU's remaining work then "
        "counts as read-back.");
  if (!ImGui::BeginTable("passes", 4, ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerH)) return;
  std::vector<std::string> heads;
  for (const char* name : {"pass", "runs", "CPU ms", "GPU ms"})
    ImGui::TableSetupColumn(heads.emplace_back(translated(name)).c_str());
  figures_.push_back(std::move(heads));
  ImGui::TableHeadersRow();
  for (const gl::PassTime& pass : timings->times()) {
    figures_.push_back({std::string(pass.name), std::to_string(pass.count), fmt::format("{:.1f}", pass.cpuMs),
                        pass.gpuCount ? fmt::format("{:.1f}", pass.gpuMs) : "-"});
    for (const std::string& cell : figures_.back()) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(cell.c_str());
    }
  }
  ImGui::EndTable();
}

}  // namespace qrelief
