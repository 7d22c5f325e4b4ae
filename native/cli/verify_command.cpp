// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <fmt/format.h>

#include "base/clock.h"
#include "cli/command_settings.h"
#include "cli/commands.h"
#include "cli/model_input.h"
#include "cli/output_files.h"
#include "cli/progress_bar.h"
#include "cli/setting_flags.h"
#include "cli/tried_print.h"
#include "io/read_model.h"
#include "message_codes/command.h"
#include "message_codes/pipeline.h"
#include "message_codes/settings_errors.h"
#include "messages/sentences.h"
#include "native/files.h"
#include "native/read_carving.h"
#include "native/zxing_decoder.h"
#include "report/verify_report.h"
#include "settings/engrave_request.h"
#include "verdict/other_prints.h"

namespace qrelief {
namespace {

// Shares of the progress: before the print is simulated, and of the rest, before other prints are tried.
constexpr double kShareBeforePrint = 0.6, kShareBeforeTries = 0.2;

struct VerifyOptions {
  std::string path, units, report, json;
  SettingFlags flags;
  std::optional<double> scale;
  std::vector<double> at;
  bool quick = false, traced = false, tryPrints = false, quiet = false;
};

/// Returns place, size and text from the command line.
Result<VerifyRequest> requestFromFlags(const VerifyOptions& options, const EngraveRequest& settings) {
  const PlacementRequest& place = settings.placement;
  if (settings.code.text.empty() || options.at.empty() || !place.direction || place.sizeMode != SizeMode::Fixed)
    return fail(ErrorKind::BadUsage, message<"verify-place-unknown">());
  if (settings.code.isText()) return fail(ErrorKind::BadUsage, message<"verify-text-alone">());
  VerifyRequest request;
  request.text = settings.code.text;
  request.symbolMm = place.sizeMm;
  auto encoded = encodeSymbol(settings.code.text, settings.code.symbol);
  QRELIEF_TRY(encoded);
  request.symbol = std::move(*encoded);
  const Vec3 centre(options.at[0], options.at[1], options.at[2]);
  request.frame = makeFrame(centre, *place.direction, place.upHint, place.eyeDistanceMm);
  request.mark = settings.marking.mark;
  request.markDepthMm = settings.marking.markDepthMm.value_or(0);
  request.albedo = settings.marking.surfaceAlbedo();
  request.darkReflectance = settings.marking.darkReflectance;
  return request;
}

Result<VerifyRequest> requestFromFile(const std::string& report) {
  const auto bytes = readFile(report);
  QRELIEF_TRY(bytes);
  return requestFromReport({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
}

/// Refuses flags whose values a report gives.
Status checkFlags(const VerifyOptions& options) {
  if (options.report.empty()) return {};
  if (!options.at.empty()) return fail(ErrorKind::BadUsage, message<"report-gives-it">(with::term<"option">("--at")));
  const auto isAmong = [](const auto& keys, const std::string& key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  };
  for (const std::string& key : options.flags.given()) {
    const bool isOfPlace = isAmong(kVerifyPlaceKeys, key) || isAmong(kVerifyMarkKeys, key);
    if (isOfPlace || findSetting(key)->group == kVerifyGroups[0])
      return fail(ErrorKind::BadUsage, message<"report-gives-it">(with::setting<"option">(key)));
  }
  return {};
}

Status checkFiles(const VerifyOptions& options) {
  const FileUse inputs[] = {{"MODEL", options.path}, {"--report", options.report}};
  const FileUse output = {"--json", options.json};
  return checkOutputs(inputs, std::span(&output, 1));
}

Result<VerifyRequest> requestFrom(const VerifyOptions& options) {
  QRELIEF_TRY(checkFlags(options));
  QRELIEF_TRY(checkFiles(options));
  const auto settings = options.flags.request();
  QRELIEF_TRY(settings);
  auto request = options.report.empty() ? requestFromFlags(options, *settings) : requestFromFile(options.report);
  if (!request) return request;
  request->printer = settings->print.printer;
  request->process = settings->print.process;
  const std::vector<std::string> given = options.flags.given();
  if (options.report.empty() || std::find(given.begin(), given.end(), "buildUp") != given.end())
    request->buildUp = settings->print.buildUp.resolve(request->frame);
  request->minWallMm = settings->depth.minWallMm;
  if (!settings->depth.lights.empty()) {
    request->lamps = settings->depth.lights;
    request->needsLamp = request->needsLamp && request->lamps.size() == 1;
  }
  return request;
}

std::string rangeOf(const ReadingSummary& reading) {
  std::string words;
  const auto add = [&](std::string part) { words += (words.empty() ? "" : ", ") + std::move(part); };
  const auto tilt = [](double deg) { return deg > 0 ? fmt::format("tilted up to {:g}°", deg) : "straight ahead only"; };
  if (reading.tiltDeg) add(tilt(*reading.tiltDeg));
  if (reading.tiltDegLamp) add("with a lamp " + tilt(*reading.tiltDegLamp));
  if (reading.pixelsPerModule) add(fmt::format("from as far as {:g} pixels per module", *reading.pixelsPerModule));
  if (reading.blurModules) add(fmt::format("blurred by up to {:g} modules", *reading.blurModules));
  return words;
}

void printCode(const VerifyRequest& request, const VerifyResult& result, const Verdict& verdict, bool printed) {
  const ReadingSummary& reading = result.reading;
  if (verdict.reads.level == Level::Good)
    fmt::print("reads as: {}\n", request.text);
  else
    fmt::print("{}\n", sentence(verdict.reads.summary));
  fmt::print("{} of {} tries from the front decoded ({} needed)\n", reading.frontal.reads, reading.frontal.tries,
             reading.frontal.needed());
  for (const Aspect* aspect : {&verdict.reads, &verdict.prints})
    for (const Message& warning : aspect->warnings) fmt::print("{}\n", sentenceAndHint(warning));
  if (const std::string range = rangeOf(reading); reading.frontal.enough() && !range.empty())
    fmt::print("reads {}\n", range);
  if (result.features)
    fmt::print("pockets {:.2f} mm deep on average, {:.2f} mm wide, modules {:.2f} mm\n", result.features->meanDepthMm,
               result.features->pocketMm, result.features->moduleMm);
  if (result.grades)
    fmt::print("simulated grades: ISO/IEC 15415 {:g}, ISO/IEC 29158 {:g}; fixed pattern damage {:g}\n",
               result.grades->iso15415, result.grades->iso29158, result.grades->fixedPatternDamage.grade);
  if (printed || verdict.prints.level != Level::Good) fmt::print("{}\n", sentence(verdict.prints.summary));
  for (const Message& reason :
       verdict.prints.level == Level::Good && !printed ? std::vector<Message>() : verdict.prints.reasons)
    fmt::print("  {}\n", sentenceAndHint(reason));
}

void printResult(const std::string& name, const VerifyRequest& request, const VerifyResult& result,
                 const Verdict& verdict, bool printed) {
  const SolidityReport& solid = result.solidity;
  fmt::print("{}: {}, {}\n", name, solid.solid() ? "a closed solid" : "not a clean solid",
             counted(solid.triangles, "triangle", "triangles"));
  if (request.isText())
    fmt::print("{}\n", sentence(verdict.reads.summary));
  else
    printCode(request, result, verdict, printed);
  if (verdict.solid.passed() && verdict.solid.level != Level::Good)
    for (const Message& reason : verdict.solid.reasons) fmt::print("{}\n", sentence(reason));
}

/// Simulates other prints of the same model and prints a verdict on each.
Status tryOtherPrints(const VerifyRequest& request, const Mesh& carved, ProgressBar& bar) {
  fmt::print("this model, printed in other ways:\n");
  const std::vector<SettingChange> others = otherPrints(request);
  auto left = static_cast<double>(others.size());
  for (const SettingChange& other : others) {
    const VerifyRequest changed = printedOtherwise(request, other);
    bar.next(1 / left--);
    const auto printed = readPrinted(changed, carved, [&](const Progress& progress) { bar.show(progress); });
    bar.hide();
    QRELIEF_TRY(printed);
    const Aspect prints = judgePrinted(**printed, changed.printer, changed.text);
    fmt::print("  {} {}: {}\n", flagOf(other.setting), other.value, triedPrint(prints, **printed));
  }
  bar.finish();
  return {};
}

int verifyModel(const VerifyOptions& options) {
  const auto start = Clock::now();
  const JsonOutput output(options.json);
  auto request = requestFrom(options);
  if (!request) return printError(request.error(), options.report);
  request->ranges = !options.quick;
  request->isTraced = options.traced;
  const auto scale = scaleFrom(options.scale, options.units);
  if (!scale) return printError(scale.error());
  const std::string name = fileNameOf(options.path);
  const auto bytes = readFile(options.path);
  if (!bytes) return printError(bytes.error(), name);
  const auto soup = readModel(*bytes, options.path);
  if (!soup) return printError(soup.error(), name);
  auto mesh = meshAsFound(*soup, scale->value_or(soup->unitMm.value_or(1)));
  if (!mesh) return printError(mesh.error(), name);
  if (soup->format == "3MF") findInPose(*request, *mesh, soup->source.get());

  auto job = VerifyJob::create(*mesh, *request, zxingDecoders());
  if (!job) return printError(job.error(), name);
  ProgressBar bar(options.quiet, kShareBeforePrint);
  if (const Status done = runWithProgress(**job, bar); !done) return printError(done.error(), name);
  const VerifyResult result = (*job)->takeResult();

  std::optional<PrintedEvidence> printed;
  // A slicer does not make the intended solid from an open mesh, and without a carving there is nothing to decode.
  if (result.solidity.closed() && (result.features || request->mark != Mark::Shadow)) {
    bar.next(options.tryPrints ? kShareBeforeTries : 1);
    auto read = readPrinted(*request, *mesh, [&](const Progress& progress) { bar.show(progress); });
    bar.hide();
    if (!read) return printError(read.error(), name);
    printed = std::move(*read);
  }
  const Verdict verdict = judge(*request, result, printed ? &*printed : nullptr);
  const bool triesPrints = options.tryPrints && printed && verdict.prints.level != Level::Good;
  if (!triesPrints) bar.finish();
  printResult(name, *request, result, verdict, printed.has_value());
  if (triesPrints)
    if (const Status tried = tryOtherPrints(*request, *mesh, bar); !tried) return printError(tried.error(), name);
  const int status = printFailed(verdict);
  if (output.isWanted()) {
    const double total = millisecondsSince(start);
    const std::string report = makeVerifyReport(
        *request, result, {name, soup->format, zxingName(), total, printed, verdict, commandWording()});
    if (const Status written = output.write(report); !written) return printError(written.error());
  }
  return status;
}

}  // namespace

std::function<int()> addVerifyCommand(CLI::App& app) {
  auto o = std::make_shared<VerifyOptions>();
  CLI::App* c = app.add_subcommand("verify", "Check an engraved model: is it a solid, does it decode, does it print?");
  c->add_option("MODEL", o->path, fmt::format("{}; verify repairs nothing", kModelFormats))
      ->required()
      ->transform(standardInput);
  addScaleFlags(*c, o->scale, o->units);
  c->add_option("--report", o->report, "report that engrave wrote: gives placement, size, text and modules")
      ->transform(standardInput);
  constexpr const char* kWithoutReport = "without --report: ";
  o->flags.add(*c, "text", kWithoutReport);
  addCentreFlag(*c, o->at, "without --report: X,Y,Z, centre of the code on the surface before engraving, mm");
  for (const char* key : kVerifyPlaceKeys) o->flags.add(*c, key, kWithoutReport);
  o->flags.addGroup(*c, kVerifyGroups[0]);
  for (const char* key : kVerifyMarkKeys) o->flags.add(*c, key, kWithoutReport);
  o->flags.addGroup(*c, kVerifyGroups[1]);
  for (const std::string_view key : kVerifyKeys)
    o->flags.add(*c, key, key == "light" ? "instead of the report's lamps: " : "");
  c->add_flag("--quick", o->quick, "skip the search for the limits of distance, tilt and blur");
  c->add_flag("--traced", o->traced, "trace light paths with all bounces; the reference, but many times slower");
  c->add_flag(
      "--try-prints", o->tryPrints,
      "if the print does not decode reliably, simulate other orientations and finer processes and list the results");
  c->add_option("--json", o->json, "write all results as JSON; - writes to standard output");
  c->add_flag("--quiet", o->quiet, "do not show progress");
  return [o] { return verifyModel(*o); };
}

}  // namespace qrelief
