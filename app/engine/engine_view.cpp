// SPDX-License-Identifier: GPL-3.0-or-later
// Implements the verbs that control and describe the view.
#include <cmath>
#include <fmt/format.h>

#include "base/parse_json.h"
#include "engine/answers.h"
#include "engine/engine.h"
#include "engine/print_decal.h"
#include "message_codes/engine.h"
#include "viewer/depth_colours.h"

namespace qrelief {
namespace {

constexpr double kHiddenByMm = 0.01;      // a point is hidden if the surface is nearer to the reader by more than this
constexpr double kLampAwayEdges = 0.85;   // distance of a lamp's mark from the code's middle, in edges of the decal
constexpr double kFineShadowRadii = 0.9;  // the same of the places whose shadows are fine, in distances of the lamps:
                                          // the decal with its corners

Json jsonOf(Vec2 v) { return {v.x, v.y}; }

Box3 boxOfBody(const Mesh& mesh, std::uint32_t body) {
  Box3 box;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; mesh.body(t) == body && k < 3; ++k) box.add(mesh.corner(t, k));
  return box;
}

/// Returns the corners on the screen; null if one of them lies behind the camera.
Json onScreen(const CodeOnSurface& code, const OrbitCamera& camera) {
  const Decal& decal = code.decal;
  const CameraView view = camera.view();
  const Vec3 eye = view.eye();
  Json corners = Json::array();
  for (const Vec2 corner : {Vec2(-1, 1), Vec2(1, 1), Vec2(1, -1), Vec2(-1, -1)}) {
    const Vec3 point = decal.frame.onPlane(corner * (decal.edgeMm / 2));
    if (!(glm::dot(eye - point, view.back) > 0)) return {};
    corners.push_back(jsonOf(camera.toScreen(point)));
  }
  return {{"corners", corners},
          {"facing", glm::dot(glm::normalize(eye - decal.frame.centre), decal.frame.normal)},
          {"edgeMm", decal.edgeMm},
          {"symbolMm", code.symbolMm},
          {"rotationDeg", code.rotationDeg}};
}

LampHemisphere hemisphereOf(const CodeOnSurface& code) {
  return {code.decal.frame, kLampAwayEdges * code.decal.edgeMm};
}

/// Returns each lamp as a line from where it is drawn, null behind the camera, to the middle of the code.
Json onScreen(const std::vector<DirectionalLight>& lamps, const CodeOnSurface& code, const OrbitCamera& camera) {
  const LampHemisphere hemisphere = hemisphereOf(code);
  const Vec3 eye = camera.view().eye(), back = camera.view().back;
  Json lines = Json::array();
  for (const DirectionalLight& lamp : lamps) {
    const Vec3 point = hemisphere.place(lamp);
    const Json from = glm::dot(eye - point, back) > 0 ? jsonOf(camera.toScreen(point)) : Json();
    lines.push_back({{"from", from}, {"to", jsonOf(camera.toScreen(hemisphere.frame.centre))}});
  }
  return lines;
}

/// Returns an upright edge of the model's box over the plate, the one at the left on the screen; null if a corner lies
/// behind the camera.
Json onScreen(const BuildPlate& plate, const OrbitCamera& camera) {
  const CameraView view = camera.view();
  const auto isAhead = [&](Vec3 point) { return glm::dot(view.eye() - point, view.back) > 0; };
  std::optional<Vec2> foot, top;
  for (const Vec2 corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)}) {
    const Vec2 at = corner * plate.halfMm;
    const Vec3 below = plate.centre + plate.right * at.x + plate.back * at.y, above = below + plate.up * plate.heightMm;
    if (!isAhead(below) || !isAhead(above)) return {};
    const Vec2 onScreen = camera.toScreen(below);
    if (foot && foot->x <= onScreen.x) continue;
    foot = onScreen;
    top = camera.toScreen(above);
  }
  return {{"foot", jsonOf(*foot)}, {"top", jsonOf(*top)}, {"heightMm", plate.heightMm}};
}

/// Returns the points of a construction that have names.
Json onScreen(const Construction& construction, const OrbitCamera& camera) {
  const CameraView view = camera.view();
  const auto at = [&](Vec3 point) {
    return glm::dot(view.eye() - point, view.back) > 0 ? jsonOf(camera.toScreen(point)) : Json();
  };
  const ProjectionFrame& frame = construction.frame;
  Json directions = Json::array();
  for (const Construction::Direction& direction : construction.directions)
    directions.push_back(at(construction.tip(direction)));
  return {{"centre", at(frame.centre)},
          {"closest", construction.closest ? at(frame.onPlane(*construction.closest)) : Json()},
          {"eye", at(frame.eye())},
          {"directions", directions}};
}

}  // namespace

std::optional<BuildPlate> Engine::buildPlate() const {
  if (!model_) return {};
  const BuildDirection build = wanted_.buildDirection(scene_.camera().modelUp());
  const Placement* const placement = preview_.placement();
  if (!build.up && build.pose != BuildPose::AsModelled && !placement) return {};  // the code is not placed yet
  return plateUnder(model_->mesh(), build.resolve(placement ? placement->frame : ProjectionFrame{}));
}

namespace {

/// Returns a colour as in CSS: "#1466d6".
std::string cssColour(Vec3f colour) {
  const auto part = [](float value) { return std::lround(255 * value); };
  return fmt::format("#{:02x}{:02x}{:02x}", part(colour.x), part(colour.y), part(colour.z));
}

}  // namespace

std::optional<Construction> Engine::placedConstruction() const {
  const Placement* const placement = preview_.placement();
  if (!placement) return {};
  const int modules = static_cast<int>(std::lround(placement->symbolMm / placement->moduleMm));
  return constructionOf(*placement, roomFactor(modules, searchedPlacement(settings(), modules)));
}

std::vector<DirectionalLight> Engine::shownLamps() const {
  return heldLamps_.empty() ? settings().lamps() : heldLamps_;
}

void Engine::lightScene() {
  if (const CodeOnSurface* const code = preview_.code()) hemisphere_ = hemisphereOf(*code);
  const std::vector<DirectionalLight> lamps = shownLamps();
  if (!hemisphere_ || lamps.empty()) {
    scene_.setLight({});
    return;
  }
  LampLight light{{},
                  openIrradiance(lamps),
                  settings().marking.surfaceAlbedo(),
                  hemisphere_->frame.centre,
                  kFineShadowRadii * hemisphere_->radiusMm};
  for (const DirectionalLight& lamp : lamps) light.lamps.push_back({hemisphere_->direction(lamp), lamp.strength});
  scene_.setLight(std::move(light));
}

std::string Engine::moveLamp(const std::string& where) {
  const Result<Json> parsed = parseJson(where);
  if (!parsed) return answer(parsed.error());
  const Json& at = parsed->at("at");
  const std::size_t index = parsed->at("lamp");
  std::vector<DirectionalLight> lamps = shownLamps();
  if (!preview_.code() || index >= lamps.size()) return answer(kNoCode);
  const Ray ray = scene_.camera().ray(numberOf(at.at(0)), numberOf(at.at(1)));
  lamps[index] = hemisphereOf(*preview_.code()).moved(lamps[index], ray);
  heldLamps_ = lamps;
  lightScene();
  Json moved = Json::array();
  for (const auto& [azimuthDeg, elevationDeg, strength] : lamps)
    moved.push_back({{"azimuthDeg", azimuthDeg}, {"elevationDeg", elevationDeg}, {"strength", strength}});
  return textOf({{"ok", true}, {"lamps", std::move(moved)}});
}

std::string Engine::construction() const {
  const std::optional<Construction> placed = placedConstruction();
  if (!placed) return textOf({{"ok", true}, {"construction", Json()}});
  constexpr ConstructionColours colours;
  Json directions = Json::array();
  for (const Construction::Direction& direction : placed->directions) directions.push_back(direction.varianceMm2);
  return textOf({{"ok", true},
                 {"construction",
                  {{"eyeMm", placed->frame.eyeDistance},
                   {"closestMm", placed->closest ? Json(glm::length(*placed->closest)) : Json()},
                   {"largestMm", placed->largestMm},
                   {"squareMm", placed->squareMm},
                   {"variancesMm2", directions},
                   {"chosen", placed->chosen ? Json(*placed->chosen) : Json()},
                   {"colours",
                    {{"plane", cssColour(colours.plane)},
                     {"projection", cssColour(colours.projection)},
                     {"silhouette", cssColour(colours.silhouette)},
                     {"square", cssColour(colours.square)},
                     {"directions", cssColour(colours.directions)}}}}}});
}

void Engine::updateView() {
  const auto inkOf = [](const EngraveRequest* request) {
    return request && request->marking.isInColour() ? std::optional(request->marking.ink()) : std::nullopt;
  };
  const EngraveResult* const result = carvings_.result();
  construction_ = scene_.constructionShown() ? placedConstruction() : std::nullopt;
  const auto sizes = scene_.surface() == Scene::Surface::Sizes ? offers_.sizesDisplay() : nullptr;
  scene_.update({model_ ? model_->display : nullptr, carvings_.madeDisplay(), sizes, preview_.code(),
                 preview_.hovered(), print_ ? &*print_ : nullptr, wanted_.centreMm(), inkOf(&wanted_.settings()),
                 inkOf(result ? &result->request : nullptr), model_ && !model_->engravable->prepared.colours.empty(),
                 buildPlate(), construction_ ? &*construction_ : nullptr});
  lightScene();
}

void Engine::setUpAxis(const std::string& axis) {
  scene_.camera().setUpAxis(axis == "y" ? UpAxis::Y : UpAxis::Z);
  standOnPlate();
  scene_.camera().fitFromDefaultSide();
}

void Engine::standOnPlate() {
  const BuildDirection& build = settings().print.buildUp;
  const Vec3 up = build.up ? glm::normalize(*build.up) : scene_.camera().modelUp();
  if (up != scene_.camera().skyward()) scene_.camera().standOn(up);
}

void Engine::zoom(double factor, double x, double y) {
  const auto surface = surfaceAt(x, y);
  scene_.camera().zoom(factor, surface ? surface->position : scene_.camera().onTargetPlane(x, y));
}

std::string Engine::look(const std::string& action) {
  const Result<Json> parsed = parseJson(action);
  if (!parsed) return answer(parsed.error());
  const auto number = [&](const char* key) { return parsed->at(key).get<double>(); };
  const std::string kind = parsed->at("kind");
  const Placement* const placement = preview_.placement();
  const CodeOnSurface* const code = preview_.code();
  scene_.freeLook();
  if (kind != "readerView") hidePrint();
  if (kind == "orbit")
    scene_.camera().orbit(number("dx"), number("dy"));
  else if (kind == "pan")
    scene_.camera().pan(number("dx"), number("dy"));
  else if (kind == "zoom")
    zoom(number("factor"), number("x"), number("y"));
  else if (kind == "fit")
    scene_.camera().fit();
  else if (kind == "body" && model_)
    scene_.camera().fitTo(boxOfBody(model_->engravable->prepared.mesh, parsed->at("index").get<std::uint32_t>()));
  else if (kind == "standard")
    scene_.standardView(parsed->at("name"));
  else if (kind == "readerView" && placement && code)
    scene_.lookAsReader(placement->frame, code->decal.edgeMm);
  else if (kind == "face" && placement && code)
    scene_.faceCode(placement->frame, code->decal.edgeMm, model_->engravable->box.diagonal());
  else if (kind == "faceSection" && code)
    scene_.faceSection(*code);
  else if (kind == "faceConstruction" && construction_)
    scene_.faceConstruction(*construction_);
  return done();
}

std::string Engine::show(const std::string& what) {
  const Result<Json> parsed = parseJson(what);
  if (!parsed) return answer(parsed.error());
  if (parsed->contains("carved")) showCarved(parsed->at("carved"));
  if (parsed->contains("sizes")) showSizes(parsed->at("sizes"));
  if (parsed->contains("depths")) scene_.showDepths(parsed->at("depths"));
  if (parsed->contains("buildPlate")) scene_.showPlate(parsed->at("buildPlate"));
  if (parsed->contains("construction")) scene_.showConstruction(parsed->at("construction"));
  if (parsed->contains("lampLight")) scene_.showLampLight(parsed->at("lampLight"));
  if (parsed->contains("upAxis")) setUpAxis(parsed->at("upAxis"));
  if (parsed->contains("section")) {
    const Json& offset = parsed->at("section");
    scene_.showSection(!offset.is_null(), offset.is_null() ? 0 : offset.get<double>());
  }
  updateView();
  const EngraveResult* const result = carvings_.result();
  return textOf({{"ok", true},
                 {"topMm", result ? depthColoursTopMm(*result) : 0},
                 {"deepestMm", result ? pocketDepths(*result).maxMm : 0}});
}

std::string Engine::showPrint(std::vector<std::uint8_t> picture, int size) {
  const EngraveResult* const result = carvings_.result();
  if (!result) return answer(kNoResult);
  hidePrint();
  if (picture.empty()) return done();
  const bool isShadow = !carvings_.request().marking.isInColour();
  auto print = printDecal(*model_, result->placement, picture, size, isShadow);
  if (!print) return answer(print.error());
  print_ = std::move(*print);
  updateView();
  return done();
}

void Engine::hidePrint() {
  if (!print_) return;
  print_.reset();
  updateView();
}

bool Engine::draw(bool always) {
  const Result<bool> more = scene_.draw(always);
  if (more) return *more;
  problems_.push_back(more.error().message);
  return false;
}

std::string Engine::viewState() const {
  const OrbitCamera& camera = scene_.camera();
  const CameraView view = camera.view();
  Json axes = Json::array();
  for (const Vec3 axis : {view.right, view.up, view.back}) axes.push_back(qrelief::jsonOf(camera.toTurntable(axis)));
  const CodeOnSurface* placed = preview_.code();
  const Json code = placed ? onScreen(*placed, camera) : Json();
  const Json lamps = placed ? onScreen(shownLamps(), *placed, camera) : Json::array();
  const std::optional<BuildPlate> plate = scene_.shownPlate();
  const Json plateOnScreen = plate ? onScreen(*plate, camera) : Json();
  return textOf({{"code", code},
                 {"lamps", lamps},
                 {"buildPlate", plateOnScreen},
                 {"construction", construction_ && !scene_.isReaders() ? onScreen(*construction_, camera) : Json()},
                 {"axes", axes}});
}

Result<BackDistanceMap> Engine::backDistances() const {
  const EngraveResult* result = carvings_.result();
  const SurfaceMaps* maps = carvings_.job() ? carvings_.job()->surfaceMaps() : nullptr;
  if (!result || !maps) return fail(ErrorKind::BadUsage, message<"nothing-engraved">());
  return model_->engravable->gpu->backMap(result->placement.frame, maps->window);
}

std::optional<Vec2> Engine::codePlaceAt(double x, double y) const {
  const EngraveResult* result = carvings_.result();
  if (!result) return {};
  // A code in colour lies in the surface of the model.
  const bool isRelief = scene_.surface() == Scene::Surface::Carved && !result->request.marking.isInColour();
  const Mesh& mesh = isRelief ? result->mesh : model_->mesh();
  const Ray ray = scene_.camera().ray(x, y);
  const auto hit = firstHit(mesh, ray.origin, ray.direction);
  if (!hit) return {};
  const ProjectionFrame& frame = result->placement.frame;
  if (frame.distanceAlongAxis(hit->position) <= 0) return {};
  const Vec3 fromEye = hit->position - frame.eye();
  const auto seen = firstHit(mesh, frame.eye(), fromEye);
  if (!seen || seen->distance < glm::length(fromEye) - kHiddenByMm) return {};
  const Vec2 onPlane = frame.project(hit->position) / carvings_.codeEdgeMm();
  const Vec2 place(0.5 + onPlane.x, 0.5 - onPlane.y);
  if (place.x < 0 || place.y < 0 || place.x >= 1 || place.y >= 1) return {};
  return place;
}

}  // namespace qrelief
