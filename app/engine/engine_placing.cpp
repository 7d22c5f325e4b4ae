// SPDX-License-Identifier: GPL-3.0-or-later
// Implements the verbs that place the code, move the code under the pointer, and offer spots.
#include <cmath>

#include "base/parse_json.h"
#include "engine/answers.h"
#include "engine/engine.h"
#include "math/angle.h"
#include "mesh/flat_region.h"
#include "message_codes/engine.h"
#include "pipeline/best_spot.h"
#include "pipeline/coloured_code.h"
#include "pipeline/label_pockets.h"
#include "projection/flatness.h"
#include "projection/size_bound.h"

namespace qrelief {
namespace {

constexpr double kOnAxisDeg = 0.5;  // a direction this near to an axis of the model means the axis

Vec3 nearAxis(Vec3 direction) {
  for (const Vec3 axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
    const double along = glm::dot(direction, axis);
    if (std::abs(along) >= std::cos(toRadians(kOnAxisDeg))) return axis * std::copysign(1.0, along) + Vec3(0);  // no -0
  }
  return direction;
}

/// Returns the height of the capitals of a text alone, mm; none for a code.
std::optional<double> capitalMmAt(const EngraveRequest& request, int modules, double moduleMm) {
  return request.code.isText() ? labelCapitalMm(request.code.lettering(), modules, moduleMm) : std::nullopt;
}

}  // namespace

PlacementTask Engine::task() const { return {*model_, wanted_, scene_.camera().modelUp()}; }

Status Engine::hasRoom() const {
  const int modules = wanted_.symbol()->size;
  const SizeBound room{modules, roomFactor(modules, searchedPlacement(settings(), modules))};
  return checkSizeBound(model_->engravable->prepared, room, settings().placement.eyeDistanceMm);
}

bool Engine::takesCode() const {
  return model_ && !carvings_.isRunning() && wanted_.symbol() && model_->engravable->prepared.engravable() && hasRoom();
}

Status Engine::placeCode() {
  if (!model_) return tl::unexpected(kNoModel);
  if (!wanted_.centreMm()) return fail(ErrorKind::BadUsage, message<"no-centre">());
  QRELIEF_TRY(model_->engravable->prepared.engravable());
  if (!wanted_.symbol()) return tl::unexpected(wanted_.symbol().error());
  QRELIEF_TRY(hasRoom());
  return preview_.place(task());
}

std::string Engine::placement() {
  preview_.forget();
  const Status placed = placeCode();
  updateView();
  return placed ? describePlacement() : answer(placed.error());
}

std::string Engine::describePlacement() const {
  const Placement& placement = *preview_.placement();
  const Symbol& symbol = *wanted_.symbol();
  const auto capitalMm = capitalMmAt(settings(), symbol.size, placement.moduleMm);
  const bool isForgiving =
      settings().code.isText() || aimToleranceDeg(placement.bendMm, placement.moduleMm) >= kForgivingTiltDeg;
  return textOf({{"ok", true},
                 {"placement",
                  {{"centre", jsonOf(placement.frame.centre)},
                   {"direction", wanted_.direction() ? jsonOf(*wanted_.direction()) : Json()},
                   {"normal", jsonOf(placement.frame.normal)},
                   {"up", jsonOf(placement.frame.up)},
                   {"symbolMm", placement.symbolMm},
                   {"moduleMm", placement.moduleMm},
                   {"largestMm", placement.largestMm},
                   {"sizeMode", sizeModeName(settings().placement.sizeMode)},
                   {"concerns", jsonOf(std::span(preview_.code()->concerns.value()))},
                   {"aimToleranceDeg", aimToleranceDeg(placement.bendMm, placement.moduleMm)},
                   {"forgiving", isForgiving},
                   {"rotationDeg", placement.rotationDeg},
                   {"colourLayers", layersOfCode(placement, symbol.size, colouredCodeOf(settings()))},
                   {"capitalMm", capitalMm ? Json(*capitalMm) : Json()},
                   {"version", symbol.version},
                   {"modules", symbol.size}}}});
}

std::string Engine::describeCode(const CodeOnSurface& code) const {
  const auto capitalMm = capitalMmAt(settings(), code.modules, code.moduleMm());
  return textOf({{"ok", true},
                 {"hit", true},
                 {"done", true},
                 {"onCode", false},
                 {"code",
                  {{"symbolMm", code.symbolMm},
                   {"moduleMm", code.moduleMm()},
                   {"capitalMm", capitalMm ? Json(*capitalMm) : Json()},
                   {"missingShare", code.missingFraction},
                   {"forgiving", code.isForgiving},
                   {"exact", code.isExact}}}});
}

std::string Engine::hover(const std::string& at) {
  const Result<Json> parsed = parseJson(at);
  if (!parsed) return answer(parsed.error());
  preview_.stopSettling();
  const bool mayHit = !parsed->is_null() && takesCode() && !showsCarved();
  const auto point = mayHit ? surfaceAt(numberOf(parsed->at(0)), numberOf(parsed->at(1))) : std::nullopt;
  if (!point) {
    endHover();
    return textOf({{"ok", true}, {"hit", false}});
  }
  if (preview_.code() && preview_.code()->covers(model_->mesh(), *point)) {
    endHover();
    return textOf({{"ok", true}, {"hit", true}, {"onCode", true}});
  }
  if (const Status hovered = preview_.hover(task(), *point); !hovered) return answer(hovered.error());
  scene_.setGhost(preview_.hovered());
  return describeCode(*preview_.hovered());
}

std::string Engine::hoverConcerns() {
  const auto concerns = preview_.hoveredConcerns(task());
  if (!concerns) return answer(concerns.error());
  return textOf({{"ok", true}, {"concerns", jsonOf(std::span(*concerns))}});
}

void Engine::endHover() {
  preview_.endHover();
  scene_.setGhost(nullptr);
}

std::string Engine::moveCode(double x, double y) {
  const auto at = takesCode() ? surfaceAt(x, y) : std::nullopt;
  if (!at) return textOf({{"ok", true}, {"hit", false}});
  if (const Status moved = preview_.move(task(), *at); !moved) return answer(moved.error());
  construction_.reset();
  scene_.setConstruction(nullptr);
  scene_.setGhost(nullptr);
  scene_.setDecal(preview_.code());
  lightScene();
  return describeCode(*preview_.code());
}

std::string Engine::layFace(const std::string& at) const {
  const Result<Json> parsed = parseJson(at);
  if (!parsed) return answer(parsed.error());
  const auto point = surfaceAt(numberOf(parsed->at(0)), numberOf(parsed->at(1)));
  if (!point) return textOf({{"ok", true}, {"hit", false}});
  const Vec3 up = nearAxis(-flatRegionNormal(model_->mesh(), model_->engravable->prepared.adjacency, point->triangle));
  const bool isScenesUp = up == scene_.camera().modelUp();
  return textOf(
      {{"ok", true}, {"hit", true}, {"buildUp", isScenesUp ? Json(buildPoseName(BuildPose::AsModelled)) : jsonOf(up)}});
}

std::string Engine::adjustCode(const std::string& change) {
  const Result<Json> parsed = parseJson(change);
  if (!parsed) return answer(parsed.error());
  if (const auto at = parsed->find("at"); at != parsed->end())
    return moveCode(numberOf(at->at(0)), numberOf(at->at(1)));
  return resizeCode(numberOf(parsed->at("rotateDeg")), numberOf(parsed->at("symbolMm")));
}

std::string Engine::resizeCode(double rotateDeg, double symbolMm) {
  if (!preview_.code() || !takesCode()) return answer(kNoCode);
  if (!std::isfinite(rotateDeg) || !(symbolMm > 0))
    return answer(ErrorKind::BadUsage, message<"code-size-unusable">(with::lengthMm<"size">(symbolMm),
                                                                     with::angleDeg<"rotation">(rotateDeg)));
  const int modules = wanted_.symbol()->size;
  preview_.adjust(rotateDeg, symbolMm, roomFactor(modules, searchedPlacement(settings(), modules)));
  scene_.setDecal(preview_.code());
  lightScene();
  return describeCode(*preview_.code());
}

std::string Engine::chooseSpot(std::size_t index) {
  if (index >= offers_.spots().size())
    return answer(ErrorKind::BadUsage, message<"no-such-spot">(with::index<"index">(index)));
  const Spot& spot = offers_.spots()[index];
  const std::string chosen = chooseCentre(SurfacePoint{.position = spot.centreMm});
  if (spot.needsDirection) wanted_.choose(wanted_.centreMm(), spot.direction);
  const SpotSearchRequest& search = offers_.request();
  preview_.offer(placedAt(spot, search.placement), search.modules, *spot.placement);
  return chosen;
}

void Engine::showSizes(bool isShown) {
  scene_.show(Scene::Surface::Sizes, isShown && offers_.sizesDisplay());
  updateView();
}

ColourImage Engine::spotPicture(std::size_t index, int width, int height) {
  if (index >= offers_.spots().size() || !model_ || !wanted_.symbol()) return {};
  const Spot& spot = offers_.spots()[index];
  const PlacementRequest& request = offers_.request().placement;
  const auto upTo = [&](Vec3 up) { return makeFrame(spot.centreMm, spot.direction, up, request.eyeDistanceMm); };
  const auto decal =
      visibleDecal(*model_, *wanted_.symbol(), turned(upTo(request.upHint), toRadians(request.rotateDeg)),
                   spot.symbolMm, settings());
  const ProjectionFrame upright = upTo(scene_.camera().modelUp());
  return decal ? scene_.picture(model_->display, *decal, upright, width, height) : ColourImage{};
}

}  // namespace qrelief
