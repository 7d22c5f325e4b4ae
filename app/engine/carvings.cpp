// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/carvings.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/parse_json.h"
#include "batch/manifest.h"
#include "delivery/carved_file.h"
#include "delivery/carved_objects.h"
#include "delivery/maps_file.h"
#include "engine/ink_seen.h"
#include "engine/symbol_decal.h"
#include "io/write_checked.h"
#include "io/write_stl.h"
#include "pipeline/add_inlay.h"
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

constexpr std::size_t kCarvings = 2;  // to keep: more would cost memory without limit
constexpr std::size_t kPlaces = 2;    // to remember: of the placed code and the hovered one

}  // namespace

Engraver& Carvings::engraver(const Ground& ground) {
  if (!engraver_) engraver_ = std::make_unique<Engraver>(ground.model.engravable, kPlaces);
  engraver_->setDevice(timerQueries_ ? Device::Gpu : Device::Faster);  // timed passes need shaders
  return *engraver_;
}

bool Carvings::prepare(const Ground& ground, EngraveRequest request, const FoundPlacement* placed, bool withSearch) {
  if (timerQueries_ || !placed) return true;
  request.depth.recordSearch = true;
  Engraver& with = engraver(ground);
  with.remember(request, *placed);
  return with.prepare(request, withSearch);
}

const CarveJob* Carvings::prepared(EngraveRequest request) const {
  request.depth.recordSearch = true;
  return engraver_ ? engraver_->prepared(request) : nullptr;
}

void Carvings::start(const Ground& ground, EngraveRequest request, const EngravePlan::Options& options,
                     const FoundPlacement* placed) {
  request.depth.recordSearch = true;  // so that the inspector can show it whenever it is opened
  std::erase_if(carvings_, [&](const Carving& one) { return one.number != current_; });
  current_ = 0;
  engraving_.reset();
  Engraver& with = engraver(ground);
  if (placed) with.remember(request, *placed);
  engraving_.emplace(with, std::move(request), options);
}

Result<Engraving::Step> Carvings::advance() {
  const int before = engraving_->attemptOfJob();
  if (passTimings_) passTimings_->listen();
  const auto step = engraving_->advance();
  if (passTimings_) passTimings_->stopListening();
  if (!step) {
    engraving_.reset();
    current_ = 0;
    return step;
  }
  if (engraving_->attemptOfJob() != before) {
    ++started_;
    current_ = 0;
    passTimings_ = timerQueries_ ? std::make_unique<gl::PassTimings>(*timerQueries_) : nullptr;
  }
  if (*step == Engraving::Step::Done)
    makeCurrent(engraving_->best());
  else if (*step != Engraving::Step::Work)
    makeCurrent(engraving_->current());
  return step;
}

/// Makes a carving the current one, and forgets older ones.
void Carvings::makeCurrent(const std::shared_ptr<Engraved>& engraved) {
  const auto numberOf = [&](const std::shared_ptr<Engraved>& one) {
    const auto known = std::find_if(carvings_.begin(), carvings_.end(),
                                    [&](const Carving& carving) { return carving.engraved == one; });
    return known == carvings_.end() ? 0 : known->number;
  };
  current_ = numberOf(engraved);
  if (current_ == 0) {
    current_ = ++made_;
    carvings_.push_back({current_, engraved});
  }
  const int best = this->best();
  while (carvings_.size() > kCarvings) {
    const auto old = std::find_if(carvings_.begin(), carvings_.end(),
                                  [&](const Carving& one) { return one.number != current_ && one.number != best; });
    carvings_.erase(old);
  }
}

int Carvings::best() const {
  for (const Carving& one : carvings_)
    if (engraving_ && one.engraved == engraving_->best()) return one.number;
  return 0;
}

void Carvings::cancel() {
  if (!engraving_) return;
  const auto best = engraving_->best();
  engraving_.reset();
  current_ = 0;
  if (best) makeCurrent(best);
}

void Carvings::forgetAll() {
  engraving_.reset();
  engraver_.reset();
  carvings_.clear();
  current_ = 0;
}

bool Carvings::use(int number) {
  if (isRunning() || !carving(number)) return false;
  if (current_ != number && number != best()) engraving_.reset();
  current_ = number;
  return true;
}

/// Returns a carving that is kept; null: it is gone.
const Carvings::Carving* Carvings::carving(int number) const {
  const auto found =
      std::find_if(carvings_.begin(), carvings_.end(), [&](const Carving& one) { return one.number == number; });
  return found == carvings_.end() ? nullptr : &*found;
}

const EngraveRequest& Carvings::request() const {
  return engraving_ ? engraving_->request() : current()->engraved->request;
}

std::shared_ptr<const GpuMesh> Carvings::display(const Ground& ground) {
  if (!current() || current()->display || !ground.pass) return madeDisplay();
  const EngraveRequest& request = current()->engraved->request;
  const EngraveResult& result = current()->engraved->result;
  const Placement& placement = result.placement;
  const auto inked = request.marking.isInColour() ? std::optional(inkedSurface(result)) : std::nullopt;
  DisplayMesh display = splitAtCreases(inked ? inked->mesh : result.mesh);
  const double edge = symbolDecal(result.symbol, placement.frame, placement.symbolMm, request).edgeMm;
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
  current()->display = std::make_shared<const GpuMesh>(std::move(carved));
  return current()->display;
}

std::string Carvings::report(const LoadedModel& model, const gl::Capabilities& gl) const {
  const Engraved& engraved = *current()->engraved;
  ReportContext context;
  context.fileName = model.fileName;
  context.format = model.format;
  context.scaleToMm = model.scaleToMm;
  context.reading = engraved.reading;
  context.printed = engraved.printed;
  context.verdict = engraved.verdict;
  context.tried = engraved.tried;
  context.delivered = engraved.attempt;
  context.reader = current()->reader;
  context.gl = gl;
  context.loadMs = model.loadMs;
  context.prepareMs = model.prepareMs;
  context.totalMs = model.loadMs + model.prepareMs + engraved.workMs;
  return makeReport(engraved.request, *model.engravable, engraved.result, context);
}

GreyImage Carvings::readerImageFrom(const Ground& ground, double tiltDeg, double azimuthDeg) {
  if (!ground.pass) return {};
  const auto programs = engraver(ground).programs();
  if (!programs) return {};
  const EngraveResult& result = current()->engraved->result;
  if (result.readerView.luminance.empty()) return {};  // a text alone
  const ProjectionFrame frame = tilted(result.placement.frame, tiltDeg, azimuthDeg);
  const bool isInColour = current()->engraved->request.marking.isInColour();
  // A code in colour lies in the surface of the model.
  auto seen = renderReaderView(*ground.pass, isInColour ? *ground.model.display : *display(ground), frame,
                               result.readerOptions, *programs);
  if (!seen) return {};
  if (!isInColour) return std::move(seen->picture);
  addInkSeen(seen->luminance, frame, result.readerOptions.extentMm, *ground.model.engravable->raster, result);
  return photographed(std::move(seen->luminance), result.readerOptions).picture;
}

const Verdict& Carvings::setReadings(const std::vector<std::string>& texts, const std::string& reader) {
  Engraved& engraved = *current()->engraved;
  current()->reader = reader;
  const ReadingEvidence reading = evidenceOf(texts, engraved.request.code.text);
  if (engraving_ && engraving_->awaitsReading() && engraving_->current() == current()->engraved) {
    engraving_->decoded(reading);
  } else {
    engraved.reading = reading;
    engraved.judgeAnew();
  }
  return engraved.verdict;
}

Result<EngraveRequest> Carvings::printedAs(const std::string& changed) const {
  auto settings =
      nlohmann::ordered_json::parse(settingsJson(isRunning() ? engraving_->request() : current()->engraved->request));
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
  return judge(*request, current()->engraved->result, current()->engraved->reading, &printed).prints;
}

const Verdict& Carvings::setPrintedReadings(const std::vector<std::string>& texts, double facingDeg) {
  Engraved& engraved = *current()->engraved;
  const EngraveRequest& request = engraved.request;
  const PrintedEvidence printed{evidenceOf(texts, request.code.text, true),
                                std::string(namedPrinters()[*request.print.process].name), facingDeg};
  if (engraving_ && engraving_->awaitsPrint() && engraving_->current() == current()->engraved) {
    engraving_->printed(printed);
  } else {
    engraved.printed = printed;
    engraved.judgeAnew();
  }
  return engraved.verdict;
}

const PrintedEvidence* Carvings::printed() const {
  return current() && current()->engraved->printed ? &*current()->engraved->printed : nullptr;
}

Carvings::Row Carvings::row(double totalMs) const {
  const Engraved& engraved = *current()->engraved;
  return {engraved.verdict, describeRow({engraved.request, engraved.result, engraved.reading, engraved.printed,
                                         engraved.verdict, totalMs})};
}

ViewTrials& Carvings::startViewTrials() {
  return current()->viewTrials.emplace(current()->engraved->result.readerView.pixelsPerModule);
}

ViewTrials* Carvings::viewTrials() { return current() && current()->viewTrials ? &*current()->viewTrials : nullptr; }

std::vector<GreyImage> Carvings::viewTrialPictures(const Ground& ground) {
  if (!viewTrials() || viewTrials()->done()) return {};
  const ViewTrial& trial = viewTrials()->due();
  const ReaderView& seen = current()->engraved->result.readerView;
  if (trial.pixelsPerModule)
    return readingVariants(fromFarther(seen.picture, *trial.pixelsPerModule / seen.pixelsPerModule),
                           *trial.pixelsPerModule);
  const GreyImage aside = readerImageFrom(ground, trial.tiltDeg, trial.azimuthDeg);
  return aside.width > 0 ? readingVariants(aside, seen.pixelsPerModule) : std::vector<GreyImage>();
}

/// Makes the body that fills the pockets, unless it is there. @returns false if no solid body can fill them
bool Carvings::fillPockets(const LoadedModel& model, Engraved& engraved) {
  EngraveResult& result = engraved.result;
  if (result.inlay) return true;
  return addInlay(*model.engravable, result) && result.inlaySolidity.solid();
}

std::vector<std::uint8_t> Carvings::exported(const LoadedModel& model, const std::string& format, Slicer slicer,
                                             int number) {
  if (!carving(number)) return {};
  Engraved& engraved = *carving(number)->engraved;
  const EngraveResult& result = engraved.result;
  if (format == "stl") return writeStl(result.mesh);
  const bool isPainted = engraved.request.marking.mark == Mark::Paint;
  const bool withInlay = engraved.request.marking.mark == Mark::Inlay || (format == "3mf-inlay" && !isPainted);
  if (withInlay && !fillPockets(model, engraved)) return {};
  const ModelFormat written = format == "3mf-inlay" ? ModelFormat::ThreeMf : formatOfName("." + format);
  if (!holdsColoursOf(engraved.request, written)) return {};
  if (written == ModelFormat::ThreeMf) {
    const auto file = writeCarved3mf(model.engravable->prepared, result, model.partNames, withInlay,
                                     {.title = model.fileName, .slicer = slicer});
    return file ? file->bytes : std::vector<std::uint8_t>();
  }
  const auto bytes = writeChecked(carvedObjects(result, model.partNames, withInlay, written == ModelFormat::ThreeMf),
                                  written, {.title = model.fileName});
  return bytes ? *bytes : std::vector<std::uint8_t>();
}

std::vector<NamedFile> Carvings::exportedFiles(const LoadedModel& model, const std::string& name, int number) const {
  if (!carving(number)) return {};
  const Engraved& engraved = *carving(number)->engraved;
  if (!holdsColoursOf(engraved.request, formatOfName(name))) return {};
  auto encoded =
      encodeCarved(model.engravable->prepared, engraved.result, name, model.partNames, {.title = model.fileName});
  return encoded ? std::move(encoded->files) : std::vector<NamedFile>();
}

std::vector<std::uint8_t> Carvings::exportedMaps(const LoadedModel& model, int number) const {
  if (!carving(number)) return {};
  const EngraveResult& result = carving(number)->engraved->result;
  if (result.request.code.isText()) return {};
  return encodeMaps(*model.engravable, result).value_or(std::vector<std::uint8_t>());
}

const SearchRecord* Carvings::search() const {
  const SearchRecord* record = result() ? &result()->search : job() ? job()->inspectorMaps().search : nullptr;
  return record && !record->passes.empty() ? record : nullptr;
}

const Symbol* Carvings::symbol() const {
  return result() ? &result()->symbol : job() ? job()->inspectorMaps().symbol : nullptr;
}

double Carvings::codeEdgeMm() const {
  return result() ? result()->placement.moduleMm * (result()->symbol.size + 2 * kQuietZoneModules) : 0;
}

}  // namespace qrelief
