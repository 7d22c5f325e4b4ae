// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/verify.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "base/job_stages.h"
#include "io/three_mf/source.h"
#include "math/affine.h"
#include "math/angle.h"
#include "math/tolerance.h"
#include "mesh/polygon_soup.h"
#include "mesh/ray_tree.h"
#include "mesh/topology.h"
#include "mesh/touching_shells.h"
#include "mesh/weld.h"
#include "message_codes/pipeline.h"
#include "message_codes/settings_errors.h"
#include "message_codes/stages.h"
#include "pipeline/engrave.h"
#include "settings/settings.h"
#include "verification/inlaid_surface.h"
#include "verification/light_path.h"
#include "verification/mesh_luminance.h"

namespace qrelief {
namespace {

/// A large weak lamp on the right, as in a room; used only to find the ranges.
constexpr DirectionalLight kRoomLamp{.azimuthDeg = -30, .elevationDeg = 55, .strength = 0.5};
constexpr double kRoomLampRadiusDeg = 20;

/// Returns the least thickness of material behind the floors, along the rays. Pockets run along rays, too, so no ray
/// meets another pocket.
double leastWall(const RayTree& tree, const ProjectionFrame& frame, const CarvingProfile& profile) {
  constexpr double kBelowFloorMm = 1e-4;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < profile.carved.size(); ++i) {
    if (!profile.carved[i] || profile.points[i].triangle == kNoTriangle) continue;
    const Vec3 floor = profile.points[i].position;
    const auto hit = tree.firstHit(floor, glm::normalize(floor - frame.eye()), kBelowFloorMm);
    if (hit) least = std::min(least, hit->distance);
  }
  return least;
}

/// Checks the settings shared with engraving by the same rules.
Status checkShared(const VerifyRequest& request) {
  PlacementRequest placement;
  placement.sizeMode = SizeMode::Fixed;
  placement.sizeMm = request.symbolMm;
  placement.eyeDistanceMm = request.frame.eyeDistance;
  QRELIEF_TRY(checkSettings(placement));
  QRELIEF_TRY(checkSettings(
      MarkRequest{.mark = request.mark, .albedo = request.albedo, .darkReflectance = request.darkReflectance}));
  DepthRequest depth;
  depth.minWallMm = request.minWallMm;
  depth.lights = request.lamps;
  QRELIEF_TRY(checkSettings(depth));
  PrinterRequest print;
  print.process = request.process;
  print.printer = request.printer;
  print.buildUp.up = request.buildUp;
  return checkSettings(print);
}

}  // namespace

VerifyRequest verifyRequestOf(const EngraveRequest& request, const EngraveResult& result) {
  VerifyRequest verification;
  verification.frame = result.placement.frame;
  verification.symbolMm = result.placement.symbolMm;
  verification.text = request.code.text;
  verification.symbol = result.symbol;
  verification.printer = request.print.printer;
  verification.process = request.print.process;
  verification.buildUp = request.print.buildUp.resolve(verification.frame);
  verification.minWallMm = request.depth.minWallMm;
  verification.albedo = request.marking.surfaceAlbedo();
  verification.mark = request.marking.mark;
  verification.markDepthMm = result.markDepthMm;
  verification.darkReflectance = request.marking.darkReflectance;
  verification.label = request.code.lettering();
  verification.lamps = request.lamps();
  verification.needsLamp = request.isForOneLight();
  verification.ranges = false;
  verification.inheritedSelfIntersections = result.inheritedSelfIntersections;
  return verification;
}

namespace {

/// Gives touching shells vertices of their own. Needs triangles with three different vertices.
void separateShells(Mesh& mesh) {
  const bool repeatsAVertex = std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [](const Triangle& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
  });
  if (!repeatsAVertex) separateTouchingShells(mesh, buildEdgeTable(mesh.triangles));
}

/// Returns the bounding boxes of a turned file: first of the whole file, then of each item.
std::vector<Box3> boxesOfItems(const Mesh& mesh, const ThreeMfSource* source, const Affine& turn) {
  std::vector<Box3> boxes(1);
  for (const Vec3f& p : mesh.positions) boxes[0].add(turn(Vec3(p)));
  if (!source) return boxes;
  for (const ThreeMfRun& run : source->runs) {
    boxes.resize(std::max(boxes.size(), run.item + 2));
    const std::size_t end = std::min(run.firstTriangle + run.count, mesh.triangles.size());
    for (std::size_t t = run.firstTriangle; t < end; ++t)
      for (int k = 0; k < 3; ++k) boxes[run.item + 1].add(turn(mesh.corner(t, k)));
  }
  return boxes;
}

/// Tells how badly a surface looks like a symbol at a place: the distance of its light modules from the QR plane, less
/// the depth of its dark ones, each on average, mm.
double misfit(const RayTree& surface, const ProjectionFrame& frame, const Symbol& symbol, double symbolMm) {
  double light = 0, dark = 0;
  int lights = 0, darks = 0;
  for (int row = 0; row < symbol.size; ++row)
    for (int column = 0; column < symbol.size; ++column) {
      const Vec2 middle((column + 0.5) / symbol.size - 0.5, 0.5 - (row + 0.5) / symbol.size);
      const Vec3 toPlane = frame.onPlane(middle * symbolMm) - frame.eye();
      const auto hit = surface.firstHit(frame.eye(), glm::normalize(toPlane));
      const double behindMm = hit ? hit->distance - glm::length(toPlane) : symbolMm;
      if (hit && symbol.isDark(row, column))
        dark += std::min(behindMm, symbolMm), ++darks;
      else
        light += std::min(std::abs(behindMm), symbolMm), ++lights;
    }
  return light / std::max(lights, 1) - dark / std::max(darks, 1);
}

}  // namespace

void findInPose(VerifyRequest& request, const Mesh& mesh, const ThreeMfSource* source) {
  const Affine turn = turnedUp(request.buildUp);
  if (!request.lowMm) return;
  const bool isWhereReported = glm::distance(boundingBox(mesh).min, *request.lowMm) < kOnSurfaceMm;
  if (isWhereReported && turn == Affine()) return;
  const RayTree surface(mesh);
  std::optional<double> least;
  const ProjectionFrame reported = request.frame;
  const Vec3 reportedUp = request.buildUp;
  for (const Affine& way : {turn, Affine()}) {
    std::vector<Box3> boxes = boxesOfItems(mesh, source, way.inverse());
    // A mark in colour looks the same on each of several equal items: then the least move counts.
    std::stable_sort(boxes.begin(), boxes.end(), [&](const Box3& a, const Box3& b) {
      return glm::distance(a.min, *request.lowMm) < glm::distance(b.min, *request.lowMm);
    });
    for (const Box3& box : boxes) {
      const Vec3 moved = box.min - *request.lowMm;
      ProjectionFrame frame = reported;
      frame.centre = way(reported.centre + moved);
      frame.right = way(reported.right);
      frame.up = way(reported.up);
      frame.normal = way(reported.normal);
      const double misses = misfit(surface, frame, request.symbol, request.symbolMm);
      if (least && *least <= misses + kOnSurfaceMm) continue;
      least = misses;
      request.frame = frame;
      request.buildUp = way == turn ? Vec3(0, 0, 1) : reportedUp;
    }
  }
}

Result<Mesh> meshAsFound(const PolygonSoup& soup, double scaleToMm) {
  if (soup.triangles.empty()) return badInput(message<"no-triangle">());
  for (const Vec3 position : soup.positions) {
    const Vec3f p(position * scaleToMm);
    if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)))
      return badInput(message<"coordinates-not-finite">());
  }
  Mesh mesh = meshOfSoup(soup, scaleToMm);
  separateShells(mesh);
  return mesh;
}

/// The job's state.
struct VerifyJob::State {
  Mesh mesh;                 // of a code in colour: the outer surface
  std::optional<Mesh> body;  // of a model that waits for its inlay
  Symbol marked;             // of a code in colour: the modules found to be dark
  VerifyRequest request;
  std::vector<Decoder> decoders;
  JobStages<State> stages = stagesOf(request);
  RayTree tree;
  std::optional<BakedLight> light;
  int bakedRows = 0;
  std::optional<ReadingSweep> sweep;
  VerifyResult result;

  State(Mesh model, VerifyRequest task, std::vector<Decoder> readBy)
      : mesh(std::move(model)),
        marked(task.symbol),
        request(std::move(task)),
        decoders(std::move(readBy)),
        tree(outerSurface()) {}

  static JobStages<State> stagesOf(const VerifyRequest& request);
  const Mesh& outerSurface();
  bool isInColour() const { return request.mark != Mark::Shadow; }

  double moduleMm() const { return request.symbolMm / request.symbol.size; }
  Result<StageStep> checkSolid();
  Result<StageStep> measureShape();
  std::vector<Lamp> lamps() const;
  void prepareLight();
  void lightMesh();
  Result<StageStep> bake();
  SymbolGrades gradeInk() const;
  Result<StageStep> read();
};

/// Weights are times in ms of the page's samples.
JobStages<VerifyJob::State> VerifyJob::State::stagesOf(const VerifyRequest& request) {
  const bool isCode = !request.isText();
  return {{message<"checking-solid">(), 110, &State::checkSolid},
          {message<"measuring-carving">(), 35, &State::measureShape, isCode},
          {message<"tracing-light">(), request.isTraced ? 2700.0 : 220.0, &State::bake, isCode},
          {message<"reading-pictures">(), request.ranges ? 10000.0 : 110.0, &State::read, isCode}};
}

/// Finds the outer surface and the modules of an inlaid code, before the tree is built.
const Mesh& VerifyJob::State::outerSurface() {
  if (request.mark != Mark::Inlay) return mesh;
  InlaidSurface surface =
      inlaidSurface(mesh, request.frame, request.symbol.size, request.symbolMm, request.markDepthMm);
  marked.dark = std::move(surface.inlaid);
  if (!surface.hasBothBodies) body = std::move(mesh);
  mesh = std::move(surface.mesh);
  separateShells(mesh);
  return mesh;
}

Result<StageStep> VerifyJob::State::checkSolid() {
  auto solidity = checkSolidity(body ? *body : mesh);
  QRELIEF_TRY(solidity);
  result.solidity = *solidity;
  return kStageDone;
}

Result<StageStep> VerifyJob::State::measureShape() {
  if (!isInColour()) result.profile = profileCarving(tree, request.frame, request.symbol, request.symbolMm);
  const CarvingProfile& profile = result.profile;
  if (profile.pose == SymbolPose::AsWanted && profile.meanDepthMm > kFlatMm) {
    result.features = measureFeatures(request.symbol, profile.carved, profile.depthMm.values(), moduleMm());
    const double wall = leastWall(tree, request.frame, profile);
    if (std::isfinite(wall)) result.features->wallMm = wall;
  }
  prepareLight();
  return kStageDone;
}

/// Returns the lamps of the code; of a code for the sky alone the room's, if the ranges are wanted.
std::vector<Lamp> VerifyJob::State::lamps() const {
  std::vector<Lamp> lamps;
  for (const DirectionalLight& lamp : request.lamps) lamps.push_back(lampOf(lamp, request.frame, kLampRadiusDeg));
  if (lamps.empty() && request.ranges) lamps = {lampOf(kRoomLamp, request.frame, kRoomLampRadiusDeg)};
  return lamps;
}

void VerifyJob::State::prepareLight() {
  light.emplace(tree, request.frame,
                BakeOptions{.texelMm = moduleMm() / kBakedPixels,
                            .texels = kBakedPixels * (request.symbol.size + 2 * kPictureMarginModules),
                            .isTraced = request.isTraced,
                            .paths = request.paths,
                            .albedo = request.albedo,
                            .lamps = lamps()});
}

/// Computes the light on the mesh as on a height map.
void VerifyJob::State::lightMesh() {
  MeshLuminanceOptions options{.pixels = light->options().texels,
                               .pixelMm = light->options().texelMm,
                               .nearMm = kPictureMarginModules * moduleMm(),
                               .albedo = request.albedo};
  const BottomUp<float> sky = meshLuminance(mesh, request.frame, options);
  BottomUp<SurfaceLight> texels(sky.rows(), sky.columns());
  for (std::size_t i = 0; i < texels.size(); ++i) texels[i].sky = static_cast<double>(sky[i]);
  if (const std::vector<Lamp>& lamps = light->options().lamps; !lamps.empty()) {
    options.lamps = request.lamps.empty() ? std::vector{kRoomLamp} : request.lamps;
    options.lampRadiusDeg = lamps.front().radiusDeg;
    const BottomUp<float> all = meshLuminance(mesh, request.frame, options);
    for (std::size_t i = 0; i < texels.size(); ++i)
      texels[i].lamp = static_cast<double>(all[i]) * light->openLight() - texels[i].sky;
  }
  light->setLight(std::move(texels));
}

SymbolGrades VerifyJob::State::gradeInk() const {
  BottomUp<float> luminance(light->options().texels, light->options().texels, 1);
  for (std::size_t i = 0; i < luminance.size(); ++i)
    if (light->light()[i].sky >= 0) luminance[i] = static_cast<float>(light->light()[i].sky);
  InkMap(marked, request.symbolMm, request.ink()).apply(luminance, light->options().texelMm);
  return gradeSymbol(
      measureModules(request.symbol, withoutInversion(submoduleMeans(luminance, request.symbol.size), request.ink())),
      request.albedo);
}

Result<StageStep> VerifyJob::State::bake() {
  bakedRows += kRowsAStep;
  if (!light->bakeRows(kRowsAStep)) return StageStep{static_cast<double>(bakedRows) / light->options().texels};
  if (request.isTraced)
    light->smooth();
  else
    lightMesh();
  if (isInColour()) {
    result.grades = gradeInk();
  } else if (result.profile.pose == SymbolPose::AsWanted) {
    const ModuleReflectances measured =
        measureModules(request.symbol, submoduleLight(*light, request.symbol.size, !request.lamps.empty()));
    result.grades = gradeSymbol(measured, request.albedo);
  }
  sweep.emplace(*light, request.frame, request.symbol.size, request.symbolMm, request.text, decoders,
                SweepOptions{.ranges = request.ranges,
                             .underLamps = !request.lamps.empty(),
                             .ink = isInColour() ? std::optional(InkMap(marked, request.symbolMm, request.ink()))
                                                 : std::nullopt});
  return kStageDone;
}

Result<StageStep> VerifyJob::State::read() {
  if (!sweep->step()) return StageStep{sweep->doneFraction()};
  result.views = sweep->views();
  result.reading = sweep->summary();
  return kStageDone;
}

VerifyJob::VerifyJob(std::unique_ptr<State> state) : state_(std::move(state)) {}
VerifyJob::~VerifyJob() = default;

Result<std::unique_ptr<VerifyJob>> VerifyJob::create(Mesh mesh, VerifyRequest request, std::vector<Decoder> decoders) {
  if (request.text.empty()) return fail(ErrorKind::BadUsage, message<"verify-no-text">());
  if (!(std::abs(glm::length(request.frame.normal) - 1) < 1e-6))
    return fail(ErrorKind::BadUsage, message<"verify-no-direction">());
  QRELIEF_TRY(checkShared(request));
  if (request.mark == Mark::Inlay && !(request.markDepthMm > 0))
    return fail(ErrorKind::BadUsage, message<"verify-no-inlay-depth">(with::setting<"depth">("markDepthMm")));
  auto state = std::make_unique<State>(std::move(mesh), std::move(request), std::move(decoders));
  return std::unique_ptr<VerifyJob>(new VerifyJob(std::move(state)));
}

Progress VerifyJob::progress() const { return state_->stages.progress(); }

Result<Progress> VerifyJob::advance() { return state_->stages.advance(*state_); }

VerifyResult VerifyJob::takeResult() {
  assert(state_->stages.done());
  return std::move(state_->result);
}

}  // namespace qrelief
