// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspector/inspected_engine.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "inspector/translation.h"

namespace qrelief {

void InspectedEngine::resize(double width, double height, double devicePixelRatio) {
  size_ = {width, height};
  devicePixelRatio_ = devicePixelRatio;
  engine_.resize(width, height, devicePixelRatio);
  if (window_) window_->resize(width, height, devicePixelRatio);
}

void InspectedEngine::setTheme(bool dark) {
  dark_ = dark;
  engine_.setTheme(dark);
  if (window_) window_->setTheme(dark);
}

std::string InspectedEngine::startJob(const std::string& job, const std::string& options) {
  if (!window_ || !nlohmann::json::parse(options).value("withOverrides", false)) return engine_.startJob(job, options);
  return engine_.startJob(job, options,
                          [&](EngraveRequest page) { return window_->overrides().appliedTo(std::move(page)); });
}

bool InspectedEngine::draw() {
  InspectorWindow* const window = shownWindow();
  const bool more = engine_.draw(window || std::exchange(hasGone_, false));
  return window ? window->draw(engine_) || more : more;
}

void InspectedEngine::openInspector() {
  if (window_) return;
  window_ = makeWindow_();
  window_->setTheme(dark_);
  engine_.timePasses(withTimerQueries_);
}

void InspectedEngine::showInspector(bool shown) {
  if (shown && window_) window_->resize(size_.x, size_.y, devicePixelRatio_);
  hasGone_ = isShown_ && !shown;
  isShown_ = shown;
}

void InspectedEngine::inspectorTexts(const std::string& texts) {
  setTranslation(nlohmann::json::parse(texts).get<Translation>());
}

void InspectedEngine::inspectorArea(double x, double y, double width, double height) {
  if (window_) window_->setFreeArea(x, y, width, height);
}

void InspectedEngine::inspectorGlyphs(float lineHeight, const std::vector<float>& metrics,
                                      std::vector<std::uint8_t> alpha) {
  if (!window_) return;
  DrawnGlyphs glyphs;
  glyphs.lineHeight = lineHeight;
  for (std::size_t i = 0; i + 5 < metrics.size(); i += 6)
    glyphs.glyphs.push_back({static_cast<std::uint32_t>(metrics[i]), static_cast<int>(metrics[i + 1]),
                             static_cast<int>(metrics[i + 2]), metrics[i + 3], metrics[i + 4], metrics[i + 5]});
  glyphs.alpha = std::move(alpha);
  window_->setGlyphs(std::move(glyphs));
}

bool InspectedEngine::inspectorPointer(double x, double y, int buttons, double wheel) {
  return shownWindow() && window_->pointer(x, y, buttons, wheel);
}

void InspectedEngine::inspectorKey(const std::string& key, bool control, bool shift) {
  if (shownWindow()) window_->key(key, control, shift);
}

bool InspectedEngine::inspectorPick(double x, double y) {
  return shownWindow() && window_->pickSubmodule(engine_, x, y);
}

std::string InspectedEngine::inspectorState() const { return window_ ? window_->state() : "{}"; }

}  // namespace qrelief
