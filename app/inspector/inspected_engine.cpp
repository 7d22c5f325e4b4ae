// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspector/inspected_engine.h"

#include <utility>

#include "base/parse_json.h"
#include "engine/answers.h"
#include "inspector/translation.h"

namespace qrelief {

void InspectedEngine::resize(double width, double height, double devicePixelRatio) {
  size_ = {width, height};
  devicePixelRatio_ = devicePixelRatio;
  engine_.resize(width, height, devicePixelRatio);
  if (window_) window_->resize(width, height, devicePixelRatio);
}

std::string InspectedEngine::show(const std::string& what) {
  const Result<Json> parsed = parseJson(what);
  if (!parsed) return answer(parsed.error());
  if (parsed->contains("dark")) {
    dark_ = parsed->at("dark");
    engine_.setTheme(dark_);
    if (window_) window_->setTheme(dark_);
  }
  return engine_.show(what);
}

std::string InspectedEngine::startJob(const std::string& job, const std::string& options) {
  if (!window_ || !nlohmann::json::parse(options).value("withOverrides", false)) return engine_.startJob(job, options);
  return engine_.startJob(job, options,
                          [&](EngraveRequest page) { return window_->overrides().appliedTo(std::move(page)); });
}

std::string InspectedEngine::draw() {
  InspectorWindow* const window = shownWindow();
  bool more = engine_.draw(window || std::exchange(hasGone_, false));
  if (window && window->draw(engine_)) more = true;
  return textOf({{"ok", true},
                 {"more", more},
                 {"view", Json::parse(engine_.viewState())},
                 {"inspector", window ? Json::parse(window->state()) : Json()}});
}

void InspectedEngine::open() {
  if (window_) return;
  window_ = makeWindow_();
  window_->setTheme(dark_);
}

void InspectedEngine::showWindow(bool isShown) {
  if (isShown && window_) window_->resize(size_.x, size_.y, devicePixelRatio_);
  hasGone_ = isShown_ && !isShown;
  isShown_ = isShown;
  engine_.timePasses(isShown && window_ ? std::optional(withTimerQueries_) : std::nullopt);
}

std::string InspectedEngine::inspector(const std::string& event) {
  const Result<Json> parsed = parseJson(event);
  if (!parsed) return answer(parsed.error());
  const auto number = [&](const char* key) { return parsed->at(key).get<double>(); };
  const std::string kind = parsed->at("kind");
  bool takes = false;
  if (kind == "open")
    open();
  else if (kind == "show")
    showWindow(parsed->at("shown"));
  else if (kind == "texts")
    setTranslation(parsed->at("texts").get<Translation>());
  else if (kind == "area" && window_)
    window_->setFreeArea(number("x"), number("y"), number("width"), number("height"));
  else if (kind == "pointer" && shownWindow())
    takes = window_->pointer(number("x"), number("y"), parsed->at("buttons"), number("wheel"));
  else if (kind == "key" && shownWindow())
    window_->key(parsed->at("key"), parsed->at("control"), parsed->at("shift"));
  else if (kind == "pick" && shownWindow())
    takes = window_->pickSubmodule(engine_, number("x"), number("y"));
  return textOf({{"ok", true}, {"takes", takes}});
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

}  // namespace qrelief
