// SPDX-License-Identifier: GPL-3.0-or-later
// Implements the verbs that load the model and configure the code.
#include "engine/engine.h"

#include <cmath>

#include "base/parse_json.h"
#include "engine/answers.h"
#include "engine/model_file.h"
#include "message_codes/engine.h"
#include "settings/setting_json.h"

namespace qrelief {

Engine::Engine(const std::string& renderer, bool hasGl) : hasGl_(hasGl) {
  if (!hasGl) {
    gl_.renderer = gl::kProcessorName;
    return;
  }
  const auto capabilities = gl::queryCapabilities();
  if (!capabilities) {
    problems_.push_back(capabilities.error().message);
    return;
  }
  gl_ = *capabilities;
  if (!renderer.empty()) gl_.renderer = renderer;
  auto pass = GeometryPass::create();
  if (!pass) problems_.push_back(pass.error().message);
  if (const Status opened = scene_.open(ViewQuality::suitedTo(gl_)); !opened)
    problems_.push_back(opened.error().message);
  if (pass) pass_ = std::make_shared<const GeometryPass>(std::move(*pass));
}

std::string Engine::capabilities() const {
  Json problems = Json::array();
  for (const Message& problem : problems_) problems.push_back(jsonOf(problem));
  return textOf({{"renderer", gl_.renderer}, {"version", gl_.version}, {"problems", std::move(problems)}});
}

std::string Engine::loadModel(std::vector<std::uint8_t> bytes, const std::string& fileName, double scaleToMm) {
  if (hasGl_ && (!pass_ || !scene_.isOpen()))
    return answer(ErrorKind::Internal, message<"no-graphics">(with::cause<"why">(problems_.front())));
  auto model = loadedModel(pass_, std::move(bytes), fileName, scaleToMm);
  if (!model) return answer(model.error());
  carvings_.forgetAll();
  preview_.forgetFound();
  offers_.forget();
  plate_ = {};
  print_.reset();
  hemisphere_.reset();
  scene_.show(Scene::Surface::Carved, false);
  scene_.show(Scene::Surface::Sizes, false);
  model_ = std::move(*model);
  scene_.camera().setScene(model_->engravable->box);
  scene_.camera().fitFromDefaultSide();
  wanted_.choose(proposedCentre(*model_, scene_.camera(), settings().placement.eyeDistanceMm));
  updateView();
  return describeModel();
}

std::string Engine::describeModel() const {
  const std::optional<Vec3>& centre = wanted_.centreMm();
  Json model =
      qrelief::describeModel(model_->format, model_->scaleToMm, model_->warnings, model_->engravable->prepared);
  model["centre"] = centre ? jsonOf(*centre) : Json();
  return textOf({{"ok", true}, {"model", std::move(model)}});
}

std::string Engine::configure(const std::string& settings) {
  auto request = requestFromJson(settings);
  if (!request) return answer(request.error());
  wanted_.configure(std::move(*request), parseJson(settings)->contains("up"));
  heldLamps_.clear();
  scene_.setPlate(buildPlate());
  lightScene();
  standOnPlate();
  return done();
}

std::optional<SurfacePoint> Engine::surfaceAt(double x, double y) const {
  if (!model_) return {};
  const Ray ray = scene_.camera().ray(x, y);
  return firstHit(model_->mesh(), ray.origin, ray.direction);
}

std::string Engine::chooseCentre(std::optional<SurfacePoint> point, double movedMm) {
  if (!point) return textOf({{"hit", false}});
  wanted_.choose(point->position);
  preview_.forget();
  scene_.show(Scene::Surface::Carved, false);
  updateView();
  return textOf({{"hit", true}, {"centre", jsonOf(point->position)}, {"movedMm", movedMm}});
}

std::string Engine::setCentre(const std::string& where) {
  const Result<Json> parsed = parseJson(where);
  if (!parsed) return answer(parsed.error());
  if (parsed->contains("spot")) return chooseSpot(parsed->at("spot"));
  if (const auto at = parsed->find("at"); at != parsed->end()) {
    const auto picked = surfaceAt(numberOf(at->at(0)), numberOf(at->at(1)));
    if (!picked || !takesCode() || parsed->value("exact", false)) return chooseCentre(picked);
    const SurfacePoint centre = centreNear(*model_, wanted_, scene_.camera().modelUp(), *picked);
    return chooseCentre(centre, glm::distance(centre.position, picked->position));
  }
  const Json& mm = parsed->at("mm");
  const Vec3 point(numberOf(mm.at(0)), numberOf(mm.at(1)), numberOf(mm.at(2)));
  if (!model_ || !std::isfinite(point.x + point.y + point.z)) return chooseCentre({});
  return chooseCentre(closestPoint(model_->mesh(), point));
}

}  // namespace qrelief
