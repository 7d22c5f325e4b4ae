// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <fmt/format.h>

#include "base/clock.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "cli/model_input.h"
#include "cli/progress_bar.h"
#include "cli/symbol_flags.h"
#include "io/write_checked.h"
#include "native/egl_context.h"
#include "native/png_file.h"
#include "native/zxing_reader.h"
#include "pipeline/carved_objects.h"
#include "pipeline/place.h"
#include "pipeline/preset.h"
#include "pipeline/report.h"

namespace qrelief {
namespace {

struct EngraveOptions {
  ModelFlags model;
  std::string output, report, preview, size = "free", direction = "depth-balanced";
  double maxDepth = 0;
  SymbolFlags symbol;
  std::vector<double> at, up;
  std::string preset = "balanced", pattern, finderPattern, solver = "fast", objective = "contrast",
              surface = "preserved";
  std::optional<double> contrast;
  std::vector<std::string> lights;
  bool noQuietZone = false, ascii = false, quiet = false, keepPreset = false;
  EngraveRequest request;
};

void choosePreset(EngraveOptions& options, Preset preset) {
  options.preset = presetName(preset);
  options.request.preset = preset;
}

Result<double> numberFrom(const std::string& text, const char* what) {
  try {
    std::size_t used = 0;
    const double value = std::stod(text, &used);
    if (used == text.size()) return value;
  } catch (const std::exception&) {
  }
  return fail(ErrorKind::BadUsage, fmt::format("{} is \"{}\"", what, text), "See qrelief engrave --help");
}

Status readSize(const std::string& text, PlacementRequest& placement) {
  if (const std::optional<SizeMode> mode = sizeModeByName(text)) {
    placement.sizeMode = *mode;
    return {};
  }
  const Result<double> size = numberFrom(text, "The size");
  if (!size) return fail(ErrorKind::BadUsage, toldText(size.error().message), "Give mm, or free, oriented or best");
  placement.sizeMode = SizeMode::Fixed;
  placement.sizeMm = *size;
  return {};
}

Status readDirection(const std::string& text, PlacementRequest& placement) {
  if (const std::optional<DirectionMethod> method = directionMethodByName(text)) {
    placement.directionMethod = *method;
    return {};
  }
  Vec3 vector(0);
  std::size_t begin = 0;
  for (int k = 0; k < 3; ++k) {
    const std::size_t end = k < 2 ? text.find(',', begin) : text.size();
    const Result<double> value = end == std::string::npos
                                     ? fail(ErrorKind::BadUsage, fmt::format("The direction is \"{}\"", text))
                                     : numberFrom(text.substr(begin, end - begin), "A number of the direction");
    if (!value)
      return fail(ErrorKind::BadUsage, toldText(value.error().message),
                  "Give mean-normal, depth-balanced, pca, optimal, or a vector X,Y,Z");
    vector[k] = *value;
    begin = end + 1;
  }
  placement.direction = vector;
  return {};
}

/// @param text  AZIMUTH,ELEVATION[,STRENGTH]
Result<DirectionalLight> readLight(const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const Result<double> value = numberFrom(text.substr(begin, end - begin), "A number of the light");
    if (!value)
      return fail(ErrorKind::BadUsage, toldText(value.error().message), "Give AZIMUTH,ELEVATION,STRENGTH: 90,45,1");
    numbers.push_back(*value);
    begin = end + 1;
  }
  if (numbers.size() != 2 && numbers.size() != 3)
    return fail(ErrorKind::BadUsage, fmt::format("The light \"{}\" has {} numbers", text, numbers.size()),
                "Give AZIMUTH,ELEVATION,STRENGTH: 90,45,1");
  DirectionalLight light{.azimuthDeg = numbers[0], .elevationDeg = numbers[1]};
  if (numbers.size() == 3) light.strength = numbers[2];
  return light;
}

/// For the check of -o; empty if such a file can be written.
std::string whyNotWritable(const std::string& path) {
  const ModelFormat format = formatOfName(path);
  const bool writable = format == ModelFormat::Stl || format == ModelFormat::Obj || format == ModelFormat::Ply ||
                        format == ModelFormat::ThreeMf;
  return writable ? std::string() : fmt::format("{}: only .stl, .obj, .ply and .3mf files can be written", path);
}

Status completeRequest(EngraveOptions& options) {
  EngraveRequest& request = options.request;
  PlacementRequest& placement = request.placement;
  if (const Status read = readSize(options.size, placement); !read) return read;
  if (const Status read = readDirection(options.direction, placement); !read) return read;
  if (!options.up.empty()) placement.upHint = {options.up[0], options.up[1], options.up[2]};
  placement.quietZone = !options.noQuietZone;
  if (options.ascii && formatOfName(options.output) != ModelFormat::Stl)
    return fail(ErrorKind::BadUsage, fmt::format("--ascii is for STL, and the output is {}", options.output),
                "Leave it out, or name the output .stl");
  if (request.inlay && formatOfName(options.output) != ModelFormat::ThreeMf)
    return fail(ErrorKind::BadUsage,
                fmt::format("--inlay needs two bodies in a file, and the output is {}", options.output),
                "Name the output .3mf, or leave it out");
  choosePreset(options, *presetByName(options.preset));
  request.contrast = options.contrast;
  if (!options.pattern.empty()) request.modulePattern = *modulePatternByName(options.pattern);
  if (!options.finderPattern.empty()) request.finderPattern = *finderPatternByName(options.finderPattern);
  request.surface = *surfaceModeByName(options.surface);
  request.objective = options.objective == "reading" ? DepthObjective::Reading : DepthObjective::Contrast;
  request.solver = options.solver == "fast" ? ContrastSolver::Fast : ContrastSolver::PaperSteps;
  request.symbol = symbolOptionsFrom(options.symbol);
  for (const std::string& text : options.lights) {
    const Result<DirectionalLight> light = readLight(text);
    if (!light) return tl::unexpected(light.error());
    request.lights.push_back(*light);
  }
  if (options.maxDepth > 0) request.maxDepthMm = options.maxDepth;
  return {};
}

/// Without --at: the best spot for the size asked for, or the one that takes the largest.
Status chooseSpot(std::shared_ptr<const EngravableModel> model, EngraveOptions& options, double scaleToMm) {
  EngraveRequest& request = options.request;
  const auto symbol = encodeSymbol(request.text, request.symbol);
  if (!symbol) return tl::unexpected(symbol.error());
  auto job = PlaceJob::create(std::move(model), {.placement = searchedPlacement(request, symbol->size),
                                                 .modules = symbol->size,
                                                 .minWallMm = request.minWallMm,
                                                 .count = 3,
                                                 .scaleToMm = scaleToMm});
  if (!job) return tl::unexpected(job.error());
  if (const Status done = runWithProgress(**job, options.quiet); !done) return done;
  const OfferedSpot spot = (*job)->takeResult().spots.front();
  request.placement.centreMm = spot.centreMm;
  if (spot.needsDirection) request.placement.direction = spot.direction;
  const int decimals = centreDecimals(scaleToMm);
  fmt::print("placed at {:.{}f},{:.{}f},{:.{}f}\n", spot.centreFileUnits.x, decimals, spot.centreFileUnits.y, decimals,
             spot.centreFileUnits.z, decimals);
  return {};
}

Result<EngraveResult> runJob(std::shared_ptr<const EngravableModel> model, const EngraveOptions& options) {
  auto job = EngraveJob::create(std::move(model), options.request);
  if (!job) return tl::unexpected(job.error());
  if (const Status done = runWithProgress(**job, options.quiet); !done) return tl::unexpected(done.error());
  return (*job)->takeResult();
}

struct Carved {
  EngraveResult result;
  std::string readBack;  // empty: no reader found the code
};

Result<Carved> carve(std::shared_ptr<const EngravableModel> model, const EngraveOptions& options) {
  auto result = runJob(std::move(model), options);
  if (!result) return tl::unexpected(result.error());
  const auto reading = Clock::now();
  std::string readBack = readWithZxing(result->readerView);
  result->timingsMs.verify += millisecondsSince(reading);
  return Carved{std::move(*result), std::move(readBack)};
}

/// With the preset asked for, or the next deeper ones where the code does not read with it; `options` then name that.
/// Where it reads with none of them, as asked for.
Result<Carved> carveToRead(std::shared_ptr<const EngravableModel> model, EngraveOptions& options) {
  auto asked = carve(model, options);
  const bool mayGoDeeper =
      !options.contrast && !options.keepPreset && options.request.objective == DepthObjective::Contrast;
  if (!asked || !asked->readBack.empty() || !mayGoDeeper) return asked;
  EngraveOptions deeper = options;
  for (auto next = deeperPreset(*presetByName(options.preset)); next; next = deeperPreset(*next)) {
    choosePreset(deeper, *next);
    auto carved = carve(model, deeper);
    if (!carved) break;  // what is asked for can be carved: better than nothing
    if (carved->readBack.empty()) continue;
    fmt::print("carved as {}: as {} no reader found the code in the simulated picture\n", deeper.preset,
               options.preset);
    options = std::move(deeper);
    return carved;
  }
  return asked;
}

/// The carved model in the format that the output's name asks for.
Result<std::vector<std::uint8_t>> encodeModel(const EngraveOptions& options, const EngraveResult& result,
                                              const std::vector<std::string>& partNames) {
  const ModelFormat format = formatOfName(options.output);
  if (format == ModelFormat::Stl && !options.ascii) return result.stl;
  return writeChecked(carvedObjects(result, partNames, options.request.inlay), format,
                      {.title = fileNameOf(options.model.path), .ascii = options.ascii});
}

Status writeOutputs(const EngraveOptions& options, const EngravableModel& model, const EngraveResult& result,
                    const std::vector<std::string>& partNames, ReportContext& context, Clock::time_point start) {
  const auto writing = Clock::now();
  const auto bytes = encodeModel(options, result, partNames);
  if (!bytes) return tl::unexpected(bytes.error());
  if (const Status written = writeFileAtomically(options.output, *bytes); !written) return written;
  if (!options.preview.empty()) {
    const auto png = encodePng(result.readerView.clean);
    if (!png) return tl::unexpected(png.error());
    if (const Status written = writeFileAtomically(options.preview, *png); !written) return written;
  }
  context.writeMs = millisecondsSince(writing);
  context.totalMs = millisecondsSince(start);
  if (options.report.empty()) return {};
  return writeFileAtomically(options.report, makeReport(options.request, model, result, context));
}

void printSummary(const EngraveOptions& options, const EngraveResult& result, const ReportContext& context) {
  const DepthSummary depth = summarise(result.depths);
  fmt::print("{}: version {} code, {:.4g} mm wide ({:.3g} mm modules), {:.2g} mm deep on average, {:.2g} mm at most\n",
             options.output, result.symbol.version, result.placement.symbolMm, result.placement.moduleMm, depth.meanMm,
             depth.maxMm);
  if (result.limitedSubmodules > 0)
    fmt::print("{} submodules could not be carved deep enough (maximum depth, or wall thickness)\n",
               result.limitedSubmodules);
  if (!context.readBack.empty()) fmt::print("reads as: {}\n", context.readBack);
}

int engraveModel(EngraveOptions& options) {
  const auto start = Clock::now();
  if (const Status completed = completeRequest(options); !completed) return printError(completed.error());
  ReportContext context;
  context.fileName = fileNameOf(options.model.path);
  auto input = loadEngravable(options.model);
  if (!input) return printError(input.error(), context.fileName);
  context.format = input->format;
  context.scaleToMm = input->scaleToMm;
  context.loadMs = input->loadMs;
  if (!options.at.empty())
    options.request.placement.centreMm = Vec3(options.at[0], options.at[1], options.at[2]) * input->scaleToMm;

  const auto uploading = Clock::now();
  const auto gl = EglContext::create();
  if (!gl) return printError(gl.error());
  const auto capabilities = gl::queryCapabilities();
  if (!capabilities) return printError(capabilities.error());
  context.gl = *capabilities;
  const auto model = EngravableModel::upload(std::move(input->prepared));
  context.prepareMs = input->prepareMs + millisecondsSince(uploading);

  const auto choosing = Clock::now();
  if (options.at.empty()) {
    if (const Status chosen = chooseSpot(model, options, input->scaleToMm); !chosen)
      return printError(chosen.error(), context.fileName);
    context.spotMs = millisecondsSince(choosing);
  }
  const std::string askedPreset = options.preset;
  auto carved = carveToRead(model, options);
  if (!carved) return printError(carved.error(), context.fileName);
  const EngraveResult& result = carved->result;
  context.readBack = carved->readBack;
  context.reader = zxingName();
  if (!options.contrast) context.presets = {askedPreset, options.preset};

  if (const Status written = writeOutputs(options, *model, result, input->partNames, context, start); !written)
    return printError(written.error());
  printSummary(options, result, context);
  const std::vector<std::string> failed = failedChecks(options.request, result, context.readBack);
  for (const std::string& check : failed) fmt::print(stderr, "qrelief: check not passed: {}\n", check);
  return failed.empty() ? kEngraved : kCheckFailed;
}

}  // namespace

std::function<int()> addEngraveCommand(CLI::App& app) {
  auto o = std::make_shared<EngraveOptions>();
  EngraveRequest& request = o->request;
  CLI::App* c = app.add_subcommand("engrave", "Engrave a QR code");
  addModelFlags(*c, o->model);
  c->add_option("--text", request.text, "what the code says, UTF-8")->required();
  c->add_option("-o", o->output, "carved model in mm, .stl, .obj, .ply or .3mf")->required()->check(whyNotWritable);
  c->add_flag("--ascii", o->ascii, "write the STL as text");
  c->add_flag("--inlay", request.inlay,
              "add the body that fills the pockets, in a second colour, to be printed with the model (.3mf)");
  c->add_option("--at", o->at, "X,Y,Z: centre in file units, moved to the nearest surface point [best spot found]")
      ->delimiter(',')
      ->expected(3);
  c->add_option("--size", o->size, "MM, free, oriented or best: edge of the symbol without quiet zone [free]");
  c->add_option("--max-size", request.placement.maxSizeMm, "upper bound for a found size, mm [60]");
  c->add_option("--up", o->up, "X,Y,Z: where the symbol's top points [0,0,1]")->delimiter(',')->expected(3);
  c->add_option("--rotate", request.placement.rotateDeg, "degrees anticlockwise from there [0]");
  c->add_option("--direction", o->direction,
                "mean-normal, depth-balanced, pca, optimal or X,Y,Z towards the reader [depth-balanced]");
  c->add_option("--eye-distance", request.placement.eyeDistanceMm, "mm [250]");
  addSymbolFlags(*c, o->symbol);
  c->add_flag("--no-quiet-zone", o->noQuietZone, "the light margin need not fit");
  c->add_option(
       "--preset", o->preset,
       fmt::format("shallow, balanced or robust: --contrast {:g}, {:g} or {:g}; the next deeper one where the code "
                   "does not read so [balanced]",
                   presetContrast(Preset::Shallow), presetContrast(Preset::Balanced), presetContrast(Preset::Robust)))
      ->check(CLI::IsMember({"shallow", "balanced", "robust"}));
  c->add_flag("--keep-preset", o->keepPreset, "carve no deeper than --preset says, whether the code reads or not");
  c->add_option("--pattern", o->pattern, "carved part of a dark module [thick-plus]")
      ->check(CLI::IsMember({"none", "square", "thin-plus", "diamond", "thick-plus"}));
  c->add_option("--finder-pattern", o->finderPattern,
                "the same for the three finder patterns; thick-plus rounds their corners, thick-plus-sharp does not "
                "[thick-plus-sharp]")
      ->check(CLI::IsMember({"none", "as-modules", "diamond", "thick-plus", "thick-plus-sharp"}));
  c->add_option("--contrast", o->contrast, "how much darker carved submodules must be [that of --preset]");
  c->add_option("--objective", o->objective,
                "contrast: every carved submodule that much darker, as published; reading: every module as a blurred "
                "picture shows it [contrast]")
      ->check(CLI::IsMember({"contrast", "reading"}));
  c->add_option("--data-contrast", request.reading.dataContrast,
                fmt::format("reading: how much darker data modules must be [{:g}]", request.reading.dataContrast))
      ->check(CLI::Range(0.01, 0.9));
  c->add_option("--finder-contrast", request.reading.finderContrast,
                fmt::format("reading: the same for the finder patterns [{:g}]", request.reading.finderContrast))
      ->check(CLI::Range(0.01, 0.9));
  c->add_option(
       "--light", o->lights,
       "AZIMUTH,ELEVATION[,STRENGTH]: a lamp beside the sky; degrees round the code from its right anticlockwise "
       "and over its plane; strength 1 is that of the sky; at most 2 [none]")
      ->allow_extra_args(false);
  c->add_option("--max-depth", o->maxDepth, "mm [1.2 modules]")->check(CLI::PositiveNumber);
  c->add_option("--nozzle", request.nozzleMm, "of the printer, mm, for advice [0.4]")->check(CLI::Range(0.01, 10.0));
  c->add_option("--min-wall", request.minWallMm, "material that must remain, mm [0.8]");
  c->add_option("--solver", o->solver,
                "how the depth for --contrast is found: fast, or paper-steps as published [fast]")
      ->check(CLI::IsMember({"fast", "paper-steps"}));
  c->add_option("--layer", request.layerMm, "height of a printed layer, mm [0.1]");
  c->add_option("--surface", o->surface, "what happens to the model's own facets [preserved]")
      ->check(CLI::IsMember({"preserved", "resampled"}));
  c->add_option("--report", o->report, "write everything that was found and measured as JSON");
  c->add_option("--preview", o->preview, "write the result as the reader sees it as PNG");
  c->add_flag("--quiet", o->quiet, "no progress");
  return [o] { return engraveModel(*o); };
}

}  // namespace qrelief
