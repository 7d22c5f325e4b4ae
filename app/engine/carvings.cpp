// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/carvings.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "base/clock.h"
#include "base/parse_json.h"
#include "batch/manifest.h"
#include "engine/ink_seen.h"
#include "engine/symbol_decal.h"
#include "io/write_checked.h"
#include "pipeline/add_inlay.h"
#include "pipeline/carved_file.h"
#include "pipeline/carved_objects.h"
#include "settings/setting_json.h"
#include "verification/baked_light.h"
#include "verification/reading_variants.h"
#include "viewer/coloured_mesh.h"
#include "viewer/depth_colours.h"
#include "viewer/display_mesh.h"
#include "viewer/inked_surface.h"

namespace qrelief {
namespace {

constexpr int kNormalTexels = 768;  // for the smooth normals of a carved surface

/// Returns the number of steps of an engraving to do ahead: the surface, and the first passes of the search if there is
/// one.
int preparedSteps(const EngraveRequest& request) { return request.needsLight() ? 5 : 1; }

/// Returns the colours of a carved model's triangles; empty if the model has none. Walls have the colour at the code's
/// centre.
std::vector<std::optional<Colour>> carvedColours(const EngraveResult& result, const PreparedModel& model) {
  std::vector<std::optional<Colour>> colours;
  if (model.colours.empty()) return colours;
  colours.reserve(result.origins.size());
  for (const FacetOrigin& origin : result.origins)
    colours.push_back(model.colours[origin.facet == FacetOrigin::kNoFacet ? result.placement.seed : origin.facet]);
  return colours;
}

}  // namespace

Status Carvings::compilePrograms() {
  if (programs_) return {};
  auto compiled = LuminancePrograms::create();
  QRELIEF_TRY(compiled);
  programs_ = std::move(*compiled);
  return {};
}

Result<std::unique_ptr<EngraveJob>> Carvings::makeJob(const Ground& ground, const EngraveRequest& request,
                                                      const PlacementSearch* placed,
                                                      std::shared_ptr<PlacementMeasurement> measured) {
  const Device device = timerQueries_ ? Device::Gpu : Device::Faster;  // timed passes need shaders
  if (ground.model.engravable->usesShaders(device)) QRELIEF_TRY(compilePrograms());
  return EngraveJob::create(
      ground.model.engravable, request,
      {.placed = placed, .programs = programs_, .measured = std::move(measured), .device = device});
}

bool Carvings::prepare(const Ground& ground, EngraveRequest request, const PlacementSearch* placed) {
  if (timerQueries_) return true;
  request.depth.recordSearch = true;
  if (prepared_ && !(placed && prepared_->request == request)) prepared_.reset();
  if (!placed || (prepared_ && prepared_->steps >= preparedSteps(prepared_->request))) return true;
  const auto start = Clock::now();
  if (!prepared_) {
    auto job = makeJob(ground, request, placed, nullptr);  // the measured place still belongs to the shown carving
    if (!job) return true;                                 // the engraving itself reports the error
    prepared_ = {std::move(request), std::move(*job)};
  } else if (prepared_->job->advance()) {
    ++prepared_->steps;
  } else {
    prepared_.reset();
    return true;
  }
  prepared_->ms += millisecondsSince(start);
  return prepared_->steps >= preparedSteps(prepared_->request);
}

void Carvings::follow(EngravePlan plan) {
  plan_ = std::move(plan);
  kept_ = 0;
}

Result<Progress> Carvings::start(const Ground& ground, EngraveRequest request, const PlacementSearch* placed) {
  request.depth.recordSearch = true;  // so that the inspector can show it whenever it is opened
  current_.request = std::move(request);
  current_.ms = placed ? placed->directionMs() + placed->sizeMs() : 0;
  std::optional<Prepared> prepared = std::exchange(prepared_, std::nullopt);
  if (prepared && placed && !timerQueries_ && prepared->request == current_.request) {
    job_ = std::move(prepared->job);
    current_.ms += prepared->ms;
  } else {
    auto job = makeJob(ground, current_.request, placed, std::exchange(measured_, nullptr));
    if (!job) {
      if (plan_) plan_->notCarved(job.error());
      return tl::unexpected(job.error());
    }
    job_ = std::move(*job);
  }
  if (timerQueries_) passTimings_ = std::make_unique<gl::PassTimings>(*timerQueries_);
  ++started_;
  runs_ = true;
  return job_->progress();
}

Result<Progress> Carvings::advance() {
  const auto start = Clock::now();
  if (passTimings_) passTimings_->listen();
  const Result<Progress> progress = job_->advance();
  if (passTimings_) passTimings_->stopListening();
  if (!progress) {
    forgetCurrent();
    if (plan_) plan_->notCarved(progress.error());
    return progress;
  }
  if (progress->done) {
    runs_ = false;  // keep the job: the inspector shows its maps
    current_.result = job_->takeResult();
    measured_ = job_->placementMeasurement();
    current_.number = ++finished_;
  }
  current_.ms += millisecondsSince(start);
  return progress;
}

void Carvings::forgetCurrent() {
  job_.reset();
  runs_ = false;
  current_.result.reset();
  current_.display.reset();
  current_.reading = {};
  current_.printed.reset();
  current_.viewTrials.reset();
  current_.reader.clear();
}

void Carvings::setAside() {
  const bool isRejected = plan_ && kept_ > 0 && current_.number != kept_;
  if (current_.result && !isRejected) {
    const EngraveRequest request = current_.request;
    earlier_ = std::exchange(current_, {});
    current_.request = request;
  }
  forgetCurrent();
}

void Carvings::cancel() {
  plan_.reset();
  if (runs_) forgetCurrent();
}

void Carvings::forgetAll() {
  plan_.reset();
  earlier_.reset();
  prepared_.reset();
  measured_.reset();
  forgetCurrent();
}

bool Carvings::use(int carving) {
  if (runs_) return false;
  if (number() == carving) return true;
  if (!earlier_ || earlier_->number != carving) return false;
  Carving brought = std::move(*earlier_);
  earlier_.reset();
  setAside();
  current_ = std::move(brought);
  if (current_.number != kept_) plan_.reset();
  return true;
}

const std::shared_ptr<const GpuMesh>& Carvings::display(const Ground& ground) {
  if (current_.display || !current_.result || !ground.pass) return current_.display;
  const EngraveResult& result = *current_.result;
  const Placement& placement = result.placement;
  const auto inked = current_.request.marking.isInColour() ? std::optional(inkedSurface(result)) : std::nullopt;
  DisplayMesh display = splitAtCreases(inked ? inked->mesh : result.mesh);
  const double edge = symbolDecal(result.symbol, placement.frame, placement.symbolMm, current_.request).edgeMm;
  const auto before = ground.pass->render(*ground.model.display, placement.frame, {edge, kNormalTexels});
  if (before)
    takeSmoothNormals(display, result.keptTriangles, placement.frame, before->window, before->framebuffer.readRgba(1));
  const PreparedModel& model = ground.model.engravable->prepared;
  const auto ofFacets = inked ? inkedColours(*inked, result, model.colours) : carvedColours(result, model);
  const std::vector<Colour> colours = splitAtColours(display, ofFacets);
  const std::vector<float> values = inked ? std::vector<float>() : depthColours(result, display);
  GpuMesh carved(display.mesh, display.normals);
  if (!values.empty()) carved.setValues(values);
  if (!colours.empty()) carved.setColours(colours);
  current_.display = std::make_shared<const GpuMesh>(std::move(carved));
  return current_.display;
}

std::string Carvings::report(const LoadedModel& model, const gl::Capabilities& gl) const {
  ReportContext context;
  context.fileName = model.fileName;
  context.format = model.format;
  context.scaleToMm = model.scaleToMm;
  context.reading = current_.reading;
  context.printed = current_.printed;
  context.verdict = verdict();
  if (plan_) {
    context.tried = plan_->tried();
    context.delivered = plan_->kept();
  }
  context.reader = current_.reader;
  context.gl = gl;
  context.loadMs = model.loadMs;
  context.prepareMs = model.prepareMs;
  context.totalMs = model.loadMs + model.prepareMs + current_.ms;
  return makeReport(current_.request, *model.engravable, *current_.result, context);
}

GreyImage Carvings::readerImageFrom(const Ground& ground, double tiltDeg, double azimuthDeg) {
  if (!ground.pass || !compilePrograms()) return {};
  const EngraveResult& result = *current_.result;
  if (result.readerView.luminance.empty()) return {};  // a text alone
  const ProjectionFrame frame = tilted(result.placement.frame, tiltDeg, azimuthDeg);
  const bool isInColour = current_.request.marking.isInColour();
  // A code in colour lies in the surface of the model.
  auto seen = renderReaderView(*ground.pass, isInColour ? *ground.model.display : *display(ground), frame,
                               result.readerOptions, programs_);
  if (!seen) return {};
  if (!isInColour) return std::move(seen->picture);
  addInkSeen(seen->luminance, frame, result.readerOptions.extentMm, *ground.model.engravable->raster, result);
  return photographed(std::move(seen->luminance), result.readerOptions).picture;
}

Verdict Carvings::setReadings(const std::vector<std::string>& texts, const std::string& reader) {
  current_.reading = evidenceOf(texts, current_.request.code.text);
  current_.reader = reader;
  Verdict judged = verdict();
  if (plan_ && plan_->step() == EngravePlan::Step::Carve) {
    const int attempt = plan_->attempt();
    plan_->carved(judged, current_.reading.count, current_.result->placement.symbolMm);
    if (plan_->kept() == attempt) kept_ = current_.number;
  }
  return judged;
}

Verdict Carvings::verdict() const {
  Verdict judged = judge(current_.request, *current_.result, current_.reading, printed());
  return plan_ ? withRemediesLeft(std::move(judged), plan_->tried()) : judged;
}

Result<EngraveRequest> Carvings::printedAs(const std::string& changed) const {
  auto settings = nlohmann::ordered_json::parse(settingsJson(current_.request));
  const auto changes = parseJson(changed);
  QRELIEF_TRY(changes);
  if (changes->contains("process"))  // a process has its own
    for (const char* key : {"nozzleMm", "layerMm", "lineWidthMm"}) settings.erase(key);
  settings.update(*changes);
  return requestFromJson(settings.dump());
}

Result<std::optional<PrintedViewRequest>> Carvings::printedView(const std::string& changed) const {
  const auto request = printedAs(changed);
  QRELIEF_TRY(request);
  return printedViewOf(verifyRequestOf(*request, *printable()));
}

Result<Aspect> Carvings::judgePrint(const std::string& changed, const std::vector<std::string>& texts,
                                    double facingDeg) const {
  const auto request = printedAs(changed);
  QRELIEF_TRY(request);
  const PrintedEvidence printed{evidenceOf(texts, request->code.text, true), {}, facingDeg};
  return judge(*request, *current_.result, current_.reading, &printed).prints;
}

Verdict Carvings::setPrintedReadings(const std::vector<std::string>& texts, double facingDeg) {
  current_.printed = {evidenceOf(texts, current_.request.code.text, true),
                      std::string(namedPrinters()[*current_.request.print.process].name), facingDeg};
  Verdict judged = verdict();
  if (plan_ && plan_->step() == EngravePlan::Step::Print) {
    const int attempt = plan_->attempt();
    plan_->printed(judged, *current_.printed);
    if (plan_->kept() == attempt) kept_ = current_.number;
  }
  return judged;
}

Carvings::Row Carvings::row(double totalMs) const {
  Verdict judged = verdict();
  std::string details =
      describeRow({current_.request, *current_.result, current_.reading, current_.printed, judged, totalMs});
  return {std::move(judged), std::move(details)};
}

ViewTrials& Carvings::startViewTrials() {
  return current_.viewTrials.emplace(current_.result->readerView.pixelsPerModule);
}

std::vector<GreyImage> Carvings::viewTrialPictures(const Ground& ground) {
  if (!current_.viewTrials || current_.viewTrials->done()) return {};
  const ViewTrial& trial = current_.viewTrials->due();
  const ReaderView& seen = current_.result->readerView;
  if (trial.pixelsPerModule)
    return readingVariants(fromFarther(seen.picture, *trial.pixelsPerModule / seen.pixelsPerModule),
                           *trial.pixelsPerModule);
  const GreyImage aside = readerImageFrom(ground, trial.tiltDeg, trial.azimuthDeg);
  return aside.width > 0 ? readingVariants(aside, seen.pixelsPerModule) : std::vector<GreyImage>();
}

/// Makes the body that fills the pockets, unless it is there. @returns false if no solid body can fill them
bool Carvings::fillPockets(const LoadedModel& model, Carving& carving) {
  EngraveResult& result = *carving.result;
  if (result.inlay) return true;
  return addInlay(*model.engravable, result) && result.inlaySolidity.solid();
}

/// Returns the finished carving of that number; null: it is gone.
Carvings::Carving* Carvings::carving(int number) {
  if (current_.result && current_.number == number) return &current_;
  return earlier_ && earlier_->number == number ? &*earlier_ : nullptr;
}

std::vector<std::uint8_t> Carvings::exported(const LoadedModel& model, const std::string& format, Slicer slicer,
                                             int number) {
  Carving* const wanted = carving(number);
  if (!wanted) return {};
  const EngraveResult& result = *wanted->result;
  if (format == "stl") return result.stl;
  const bool isPainted = wanted->request.marking.mark == Mark::Paint;
  const bool withInlay = wanted->request.marking.mark == Mark::Inlay || (format == "3mf-inlay" && !isPainted);
  if (withInlay && !fillPockets(model, *wanted)) return {};
  const ModelFormat written = format == "3mf-inlay" ? ModelFormat::ThreeMf : formatOfName("." + format);
  if (!holdsColoursOf(wanted->request, written)) return {};
  if (written == ModelFormat::ThreeMf) {
    const auto file = writeCarved3mf(model.engravable->prepared, result, model.partNames, withInlay,
                                     {.title = model.fileName, .slicer = slicer});
    return file ? file->bytes : std::vector<std::uint8_t>();
  }
  const auto bytes = writeChecked(carvedObjects(result, model.partNames, withInlay, written == ModelFormat::ThreeMf),
                                  written, {.title = model.fileName});
  return bytes ? *bytes : std::vector<std::uint8_t>();
}

std::vector<NamedFile> Carvings::exportedFiles(const LoadedModel& model, const std::string& name, int number) {
  Carving* const wanted = carving(number);
  if (!wanted || !holdsColoursOf(wanted->request, formatOfName(name))) return {};
  if (wanted->request.marking.hasInlay() && !fillPockets(model, *wanted)) return {};
  auto encoded =
      encodeCarved(model.engravable->prepared, *wanted->result, name, model.partNames, {.title = model.fileName});
  return encoded ? std::move(encoded->files) : std::vector<NamedFile>();
}

const SearchRecord* Carvings::search() const {
  const SearchRecord* record = current_.result ? &current_.result->search
                               : job_          ? job_->inspectorMaps().search
                                               : nullptr;
  return record && !record->passes.empty() ? record : nullptr;
}

const Symbol* Carvings::symbol() const {
  return current_.result ? &current_.result->symbol : job_ ? job_->inspectorMaps().symbol : nullptr;
}

double Carvings::codeEdgeMm() const {
  return current_.result ? current_.result->placement.moduleMm * (current_.result->symbol.size + 2 * kQuietZoneModules)
                         : 0;
}

}  // namespace qrelief
