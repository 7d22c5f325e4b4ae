// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/engine.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "base/clock.h"
#include "engine/answers.h"
#include "engine/settings.h"
#include "engine/symbol_print.h"
#include "io/read_model.h"
#include "io/write_checked.h"
#include "pipeline/add_inlay.h"
#include "pipeline/carved_objects.h"
#include "projection/size.h"
#include "projection/surface_raster.h"
#include "verification/baked_light.h"
#include "viewer/depth_colours.h"
#include "viewer/display_mesh.h"
#include "viewer/spot_search.h"

namespace qrelief {
namespace {

constexpr double kProposedMm = 50;      // square looked for on a new model, quiet zone included,
constexpr double kProposedShare = 0.3;  // and its greatest share of the model's diagonal
constexpr std::size_t kSpotsTried = 6;
constexpr double kGoodFit = 0.7;    // a spot that takes this share of it will do
constexpr int kNormalTexels = 768;  // of the map that gives a carved surface its smooth normals
constexpr int kPreparedSteps = 2;   // of an engraving: the surface, and the search's first pass, which looks everywhere

const Error kNoResult = {ErrorKind::BadUsage, untold("nothing has been engraved yet", "press Engrave first")};

}  // namespace

Engine::Engine(const std::string& renderer) : symbol_(encodeSymbol(request_.text, request_.symbol)) {
  const auto capabilities = gl::queryCapabilities();
  if (!capabilities) {
    problems_.push_back(toldText(capabilities.error().message) + "; " + toldHint(capabilities.error().message));
    return;
  }
  gl_ = *capabilities;
  if (!renderer.empty()) gl_.renderer = renderer;
  auto pass = GeometryPass::create();
  auto viewer = Viewer::create(ViewQuality::suitedTo(gl_));
  for (const Error* error : {pass ? nullptr : &pass.error(), viewer ? nullptr : &viewer.error()})
    if (error) problems_.push_back(toldText(error->message) + "; " + toldHint(error->message));
  if (!problems_.empty()) return;
  pass_ = std::make_shared<const GeometryPass>(std::move(*pass));
  viewer_ = std::make_unique<Viewer>(std::move(*viewer));
}

std::string Engine::capabilities() const {
  return textOf({{"renderer", gl_.renderer}, {"version", gl_.version}, {"problems", problems_}});
}

Result<Engine::Model> Engine::readAndPrepare(std::vector<std::uint8_t> bytes, const std::string& fileName,
                                             double scaleToMm) const {
  const auto start = Clock::now();
  auto soup = readModel(bytes, fileName);
  if (!soup) return tl::unexpected(soup.error());
  bytes = {};  // the file and the model need not be in memory at once
  Model model;
  model.fileName = fileName;
  model.format = soup->format;
  model.scaleToMm = scaleToMm > 0 ? scaleToMm : soup->unitMm.value_or(1);
  model.warnings = soup->warnings;
  for (ModelPart& part : soup->parts) model.partNames.push_back(std::move(part.name));
  model.loadMs = millisecondsSince(start);

  const auto preparing = Clock::now();
  auto prepared = prepareModel(*soup, {.scaleToMm = model.scaleToMm});
  if (!prepared) return tl::unexpected(prepared.error());
  *soup = {};
  {
    const DisplayMesh display = splitAtCreases(prepared->mesh);
    model.display = std::make_shared<const GpuMesh>(display.mesh, display.normals);
  }
  model.engravable = EngravableModel::upload(std::move(*prepared));
  model.look = [raster = std::make_shared<const SurfaceRaster>(model.engravable->prepared.mesh)](
                   const ProjectionFrame& frame, const MapWindow& window) -> Result<std::vector<float>> {
    return raster->draw(frame, window);
  };
  model.prepareMs = millisecondsSince(preparing);
  return model;
}

std::string Engine::loadModel(std::vector<std::uint8_t> bytes, const std::string& fileName, double scaleToMm) {
  if (!viewer_) return answer(ErrorKind::Internal, problems_.front(), "use a browser with WebGL 2 and float targets");
  if (!(scaleToMm >= 0) || !std::isfinite(scaleToMm))
    return answer(ErrorKind::BadUsage, fmt::format("the scale is {:g}", scaleToMm),
                  "Choose how many mm one unit of the file is");
  auto model = readAndPrepare(std::move(bytes), fileName, scaleToMm);
  if (!model) return answer(model.error());
  earlier_.reset();
  forgetJob();
  forgetPlacement();
  found_.reset();
  prepared_.reset();
  forgetSpots();
  spotDirection_.reset();
  model_ = std::move(*model);
  camera_.setScene(model_->display->box());
  camera_.fitFromDefaultSide();
  proposeCentre();
  updateView();
  return describeModel();
}

void Engine::proposeCentre() {
  const PreparedModel& prepared = model_->engravable->prepared;
  const CameraView view = camera_.view();
  const double wanted = std::min(kProposedMm, kProposedShare * boundingBox(prepared.mesh).diagonal());
  centre_.reset();
  double largest = 0;
  const auto spots = proposeSpots(*pass_, model_->engravable->gpu, view, wanted, kSpotsTried);
  for (const Spot& spot : spots ? *spots : std::vector<Spot>{}) {
    const auto surface = closestPoint(prepared.mesh, spot.position);
    if (!surface) continue;
    const ProjectionFrame frame =
        makeFrame(surface->position, spot.normal, camera_.skyward(), request_.placement.eyeDistanceMm);
    const auto patch = findVisiblePatch(prepared.mesh, prepared.adjacency, frame, surface->triangle, wanted);
    const double fits = patch ? std::min(wanted, freeSize(patch->silhouette)) : 0;
    if (centre_ && fits <= largest) continue;
    centre_ = surface->position;
    largest = fits;
    if (fits >= kGoodFit * wanted) break;
  }
  if (centre_) return;
  const auto towardsCamera = closestPoint(prepared.mesh, view.eye());
  if (towardsCamera) centre_ = towardsCamera->position;
}

std::string Engine::describeModel() const {
  const PreparedModel& prepared = model_->engravable->prepared;
  return textOf({{"ok", true},
                 {"model",
                  {{"format", model_->format},
                   {"scaleToMm", model_->scaleToMm},
                   {"triangles", prepared.mesh.triangles.size()},
                   {"vertices", prepared.mesh.positions.size()},
                   {"sizeMm", jsonOf(boundingBox(prepared.mesh).size())},
                   {"shells", prepared.shells},
                   {"engravable", prepared.engravable().has_value()},
                   {"findings", jsonOf(model_->warnings, prepared.findings)},
                   {"centre", centre_ ? jsonOf(*centre_) : Json()}}}});
}

std::string Engine::configure(const std::string& settings) {
  auto request = readSettings(settings);
  if (!request) return answer(request.error());
  request_ = std::move(*request);
  symbol_ = encodeSymbol(request_.text, request_.symbol);
  return done();
}

std::optional<SurfacePoint> Engine::surfaceAt(double x, double y) const {
  if (!model_) return {};
  const Ray ray = camera_.ray(x, y);
  return firstHit(model_->engravable->prepared.mesh, ray.origin, ray.direction);
}

std::string Engine::chooseCentre(std::optional<SurfacePoint> point) {
  if (!point) return textOf({{"hit", false}});
  centre_ = point->position;
  spotDirection_.reset();
  forgetPlacement();
  showCarved_ = false;
  updateView();
  return textOf({{"hit", true}, {"centre", jsonOf(*centre_)}});
}

std::string Engine::pick(double x, double y) { return chooseCentre(surfaceAt(x, y)); }

std::string Engine::setCentre(double x, double y, double z) {
  if (!model_ || !std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) return chooseCentre({});
  return chooseCentre(closestPoint(model_->engravable->prepared.mesh, {x, y, z}));
}

EngraveRequest Engine::completeRequest() const {
  EngraveRequest request = request_;
  request.placement.centreMm = *centre_;
  request.placement.upHint = camera_.skyward();
  if (spotDirection_) request.placement.direction = spotDirection_;
  return request;
}

Result<std::unique_ptr<EngraveJob>> Engine::makeJob(const EngraveRequest& request, const PlacementSearch* placed) {
  if (!luminancePrograms_) {
    auto compiled = LuminancePrograms::create();
    if (!compiled) return tl::unexpected(compiled.error());
    luminancePrograms_ = std::move(*compiled);
  }
  return EngraveJob::create(model_->engravable, request, {placed, pass_, luminancePrograms_});
}

std::string Engine::prepareEngrave() {
  const auto report = [](bool done) { return textOf({{"ok", true}, {"done", done}}); };
  if (!model_ || !centre_ || !symbol_ || jobRuns_ || placing_ || timerQueries_) return report(true);
  EngraveRequest request = completeRequest();
  request.recordSearch = true;
  const PlacementSearch* placed = foundPlacement(request);
  if (prepared_ && !(placed && prepared_->request == request)) prepared_.reset();
  if (!placed || (prepared_ && prepared_->steps == kPreparedSteps)) return report(true);
  const auto start = Clock::now();
  if (!prepared_) {
    auto job = makeJob(request, placed);
    if (!job) return report(true);  // engraving says why
    prepared_ = {std::move(request), std::move(*job)};
  } else if (prepared_->job->advance()) {
    ++prepared_->steps;
  } else {
    prepared_.reset();
    return report(true);
  }
  prepared_->ms += millisecondsSince(start);
  return report(prepared_->steps == kPreparedSteps);
}

std::string Engine::startEngrave(const std::function<EngraveRequest(EngraveRequest)>& overridden) {
  showSizes_ = false;
  setCarvingAside();
  forgetJob();
  updateView();
  if (!model_) return answer(kNoModel);
  if (!centre_)
    return answer(ErrorKind::BadUsage, "no place has been chosen", "click on the model where the code should go");
  jobRequest_ = overridden ? overridden(completeRequest()) : completeRequest();
  jobRequest_.recordSearch = true;  // so that the inspector can show it, whenever it is opened
  const PlacementSearch* placed = overridden ? nullptr : foundPlacement(jobRequest_);
  jobMs_ = placed ? placed->directionMs() + placed->sizeMs() : 0;
  std::optional<Prepared> prepared = std::exchange(prepared_, std::nullopt);
  if (prepared && placed && !timerQueries_ && prepared->request == jobRequest_) {
    job_ = std::move(prepared->job);
    jobMs_ += prepared->ms;
  } else {
    auto job = makeJob(jobRequest_, placed);
    if (!job) return answer(job.error());
    job_ = std::move(*job);
  }
  if (timerQueries_) passTimings_ = std::make_unique<gl::PassTimings>(*timerQueries_);
  ++engravings_;
  jobRuns_ = true;
  return answer(job_->progress());
}

std::string Engine::advance() {
  if (!jobRuns_) return answer(ErrorKind::BadUsage, "no engraving is running", "");
  const auto start = Clock::now();
  if (passTimings_) passTimings_->listen();
  const Result<Progress> progress = job_->advance();
  if (passTimings_) passTimings_->stopListening();
  if (!progress) {
    forgetJob();
    return answer(progress.error());
  }
  if (progress->done) finishJob();
  jobMs_ += millisecondsSince(start);
  return answer(*progress);
}

void Engine::finishJob() {
  jobRuns_ = false;  // the job itself stays: the inspector shows its maps
  result_ = job_->takeResult();
  placement_ = result_->placement;
  if (auto code = exactCode(result_->symbol, jobRequest_, *placement_)) code_ = std::move(*code);
  carving_ = ++carvings_;
  updateView();
}

void Engine::makeCarvedDisplay() {
  if (carvedDisplay_ || !result_) return;
  const Placement& placement = result_->placement;
  DisplayMesh display = splitAtCreases(result_->mesh);
  const double edge = symbolPrint(result_->symbol, placement.frame, placement.symbolMm, jobRequest_).edgeMm;
  const auto before = pass_->render(*model_->display, placement.frame, {edge, kNormalTexels});
  if (before)
    takeSmoothNormals(display, result_->keptTriangles, placement.frame, before->window,
                      before->framebuffer.readRgba(1));
  GpuMesh carved(display.mesh, display.normals);
  carved.setValues(depthColours(*result_, display));
  carvedDisplay_ = std::make_shared<const GpuMesh>(std::move(carved));
}

void Engine::cancel() {
  if (jobRuns_) forgetJob();
}

void Engine::setCarvingAside() {
  if (!result_) return;
  earlier_ = Carving{
      carving_,          jobRequest_, jobMs_, std::move(*result_), std::move(carvedDisplay_), std::move(readBack_),
      std::move(reader_)};
  forgetJob();
}

bool Engine::useCarving(int number) {
  if (jobRuns_) return false;
  if (carving() != number) {
    if (!earlier_ || earlier_->number != number) return false;
    Carving wanted = std::move(*earlier_);
    earlier_.reset();
    setCarvingAside();
    carving_ = wanted.number;
    jobRequest_ = std::move(wanted.request);
    jobMs_ = wanted.ms;
    result_ = std::move(wanted.result);
    carvedDisplay_ = std::move(wanted.display);
    readBack_ = std::move(wanted.readBack);
    reader_ = std::move(wanted.reader);
  }
  showCarved(true);
  return true;
}

std::string Engine::report() const {
  if (!result_) return answer(kNoResult);
  ReportContext context;
  context.fileName = model_->fileName;
  context.format = model_->format;
  context.scaleToMm = model_->scaleToMm;
  context.readBack = readBack_;
  context.reader = reader_;
  context.gl = gl_;
  context.loadMs = model_->loadMs;
  context.prepareMs = model_->prepareMs;
  context.totalMs = model_->loadMs + model_->prepareMs + jobMs_;
  return makeReport(jobRequest_, *model_->engravable, *result_, context);
}

const GreyImage& Engine::readerImage() const {
  static const GreyImage kNone;
  return result_ ? result_->readerView.picture : kNone;
}

GreyImage Engine::readerImageFrom(double tiltDeg, double azimuthDeg) {
  if (!result_) return {};
  makeCarvedDisplay();
  const ProjectionFrame frame = tilted(result_->placement.frame, tiltDeg, azimuthDeg);
  auto seen = renderReaderView(*pass_, *carvedDisplay_, frame, result_->readerOptions, luminancePrograms_);
  return seen ? std::move(seen->picture) : GreyImage{};
}

void Engine::setReadBack(const std::string& text, const std::string& reader) {
  readBack_ = text;
  reader_ = reader;
}

std::vector<std::uint8_t> Engine::exportModel(const std::string& format) {
  if (!result_) return {};
  if (format == "stl") return result_->stl;
  const bool withInlay = format == "3mf-inlay";
  if (withInlay && !result_->inlay) {
    const Status made = addInlay(*model_->engravable, jobRequest_.surface, *result_);
    if (!made || !result_->inlaySolidity.solid()) return {};
  }
  const auto bytes =
      writeChecked(carvedObjects(*result_, model_->partNames, withInlay),
                   withInlay ? ModelFormat::ThreeMf : formatOfName("." + format), {.title = model_->fileName});
  return bytes ? *bytes : std::vector<std::uint8_t>();
}

void Engine::forgetPlacement() {
  placement_.reset();
  code_.reset();
  endHover();
}

void Engine::forgetJob() {
  job_.reset();
  jobRuns_ = false;
  result_.reset();
  carvedDisplay_.reset();
  showCarved_ = false;
  readBack_.clear();
  reader_.clear();
}

void Engine::updateView() {
  if (!viewer_) return;
  const bool carved = showCarved_ && carvedDisplay_;
  const bool sizes = !carved && showSizes_ && sizesDisplay_;
  viewer_->setMesh(carved ? carvedDisplay_ : sizes ? sizesDisplay_ : model_ ? model_->display : nullptr);
  viewer_->showHeat(sizes ? HeatShown::All : carved && showDepths_ ? HeatShown::AboveZero : HeatShown::None);
  viewer_->setPrint(carved || !code_ ? std::nullopt : std::optional(code_->print));
  viewer_->setGhost(carved || !hovered_ ? std::nullopt : std::optional(hovered_->print));
  viewer_->setMarker(carved || code_ ? std::nullopt : centre_);
  viewer_->setCut(cut());
}

}  // namespace qrelief
