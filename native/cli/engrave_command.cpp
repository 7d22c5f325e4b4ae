// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <fmt/format.h>
#include <functional>

#include "base/clock.h"
#include "base/unicode.h"
#include "cli/choose_spot.h"
#include "cli/commands.h"
#include "cli/file_flags.h"
#include "cli/model_input.h"
#include "cli/output_files.h"
#include "cli/progress_bar.h"
#include "cli/setting_flags.h"
#include "cli/tried_print.h"
#include "cli/unused_flags.h"
#include "delivery/carved_file.h"
#include "delivery/carved_objects.h"
#include "delivery/maps_file.h"
#include "io/sniff_format.h"
#include "io/write_files.h"
#include "message_codes/command.h"
#include "messages/sentences.h"
#include "native/engrave.h"
#include "native/files.h"
#include "native/graphics.h"
#include "native/png_file.h"
#include "native/zxing_decoder.h"
#include "qr/link_advice.h"
#include "report/report.h"
#include "settings/preset.h"
#include "settings/settings.h"
#include "verdict/other_prints.h"

namespace qrelief {
namespace {

constexpr double kShareBeforeTries = 0.3;  // of the progress, if other prints may be tried

struct EngraveOptions {
  ModelFlags model;
  std::string output, report, preview, maps;
  SettingFlags flags;
  std::vector<double> at;
  FileFlags file;
  bool ascii = false, tryPrints = false, quiet = false;
  EngraveRequest request;
};

/// Checks the value of -o. Empty if such a file can be written.
std::string whyNotWritable(const std::string& path) {
  return isWritable(formatOfName(path)) ? std::string()
                                        : fmt::format("{}: choose a name that ends in .stl, .obj, .ply or .3mf", path);
}

/// Returns a check that a name has the ending of its format.
std::function<std::string(const std::string&)> endsIn(const char* ending) {
  return [ending](const std::string& path) {
    return caseFolded(path).ends_with(ending) ? std::string()
                                              : fmt::format("{}: choose a name that ends in {}", path, ending);
  };
}

Status checkFiles(const EngraveOptions& options) {
  const MarkRequest& marking = options.request.marking;
  std::vector<FileUse> outputs;
  for (const std::string& file : fileNames(options.output, marking.isInColour() || marking.isOpen))
    outputs.push_back({outputs.empty() ? "-o" : "the second file of -o", file});
  outputs.push_back({"--report", options.report});
  outputs.push_back({"--preview", options.preview});
  outputs.push_back({"--maps", options.maps});
  const FileUse model = {"MODEL", options.model.path};
  return checkOutputs(std::span(&model, 1), outputs);
}

Status completeRequest(EngraveOptions& options) {
  auto request = options.flags.request();
  QRELIEF_TRY(request);
  options.request = std::move(*request);
  QRELIEF_TRY(options.file.check(options.output));
  for (const auto& [flag, file] : {std::pair("--preview", options.preview), std::pair("--maps", options.maps)})
    if (options.request.code.isText() && !file.empty())
      return fail(ErrorKind::BadUsage, message<"text-has-no-preview">(with::term<"option">(flag)));
  options.request.depth.recordSearch = !options.maps.empty();
  if (options.ascii && formatOfName(options.output) != ModelFormat::Stl)
    return fail(ErrorKind::BadUsage, message<"ascii-is-for-stl">(with::term<"output">(options.output)));
  if (!holdsColoursOf(options.request, formatOfName(options.output)))
    return fail(ErrorKind::BadUsage,
                message<"colour-has-no-place">(with::setting<"setting">("mark"),
                                               with::term<"mark">(markName(options.request.marking.mark)),
                                               with::term<"output">(options.output)));
  return checkFiles(options);
}

/// The files of a carving.
struct EncodedCarving {
  int attempt = 0;  ///< Engraved::attempt
  Result<CarvedFiles> files;
  double ms = 0;  ///< time it took
};

EncodedCarving encode(const EngraveOptions& options, const EngravableModel& model, const Engraved& carved,
                      const std::vector<std::string>& partNames) {
  const auto start = Clock::now();
  auto files = encodeCarved(model.prepared, carved.result, options.output, partNames,
                            options.file.writeOptions(fileNameOf(options.model.path), options.ascii));
  return {carved.attempt, std::move(files), millisecondsSince(start)};
}

Status writeOutputs(const EngraveOptions& options, const EngravableModel& model, const EngraveResult& result,
                    const EncodedCarving& encoded, const JsonOutput& report, ReportContext& context,
                    Clock::time_point start) {
  const auto writing = Clock::now();
  QRELIEF_TRY(encoded.files);
  if (encoded.files->notKept) printWarning(message<"3mf-not-kept">(with::cause<"cause">(*encoded.files->notKept)), {});
  for (const NamedFile& file : encoded.files->files) QRELIEF_TRY(writeFileAtomically(file.name, file.bytes));
  if (!options.preview.empty()) {
    const auto png = encodePng(result.readerView.clean);
    QRELIEF_TRY(png);
    QRELIEF_TRY(writeFileAtomically(options.preview, *png));
  }
  if (!options.maps.empty()) {
    const auto maps = encodeMaps(model, result);
    QRELIEF_TRY(maps);
    QRELIEF_TRY(writeFileAtomically(options.maps, *maps));
  }
  context.writeMs = encoded.ms + millisecondsSince(writing);
  context.totalMs = millisecondsSince(start);
  if (!report.isWanted()) return {};
  return report.write(makeReport(options.request, model, result, context));
}

std::string depthInWords(const EngraveResult& result) {
  if (result.request.marking.mark == Mark::Paint) return "painted";
  if (result.request.marking.mark == Mark::Inlay)
    return fmt::format("an inlay {} deep", lengthInWords(result.markDepthMm));
  const DepthSummary depth = pocketDepths(result);
  if (result.request.code.isText()) return fmt::format("{} deep", lengthInWords(depth.maxMm));
  return fmt::format("{} deep on average, {} at most", lengthInWords(depth.meanMm), lengthInWords(depth.maxMm));
}

void printSummary(const EngraveOptions& options, const EngraveResult& result, const ReportContext& context) {
  if (result.request.code.isText())
    fmt::print("{}: text, {} across, {}\n", options.output, lengthInWords(result.placement.symbolMm, 4),
               depthInWords(result));
  else
    fmt::print("{}: version {} code, {} wide ({} modules), {}\n", options.output, result.symbol.version,
               lengthInWords(result.placement.symbolMm, 4), lengthInWords(result.placement.moduleMm),
               depthInWords(result));
  if (const std::size_t atLimit = result.limitedSubmodules - result.unfinishedSubmodules; atLimit > 0)
    fmt::print("{} shallower than needed: stopped by the maximum depth or the minimum wall\n",
               counted(atLimit, "submodule is", "submodules are"));
  if (context.verdict.reads.passed() && !context.reading.text.empty())
    fmt::print("reads as: {}\n", context.reading.text);
  for (const Aspect* aspect : {&context.verdict.reads, &context.verdict.prints})
    for (const Message& warning : aspect->warnings) fmt::print("{}\n", sentenceAndHint(warning));
  for (const Aspect* aspect : {&context.verdict.reads, &context.verdict.prints, &context.verdict.solid}) {
    const bool foundOut = aspect != &context.verdict.solid &&
                          (result.request.code.isText() || (aspect == &context.verdict.prints && context.printed));
    if (!foundOut && (aspect->level == Level::Good || !aspect->passed())) continue;
    fmt::print("{}\n", sentence(aspect->summary));
    for (const Message& reason : aspect->reasons) fmt::print("  {}\n", sentenceAndHint(reason));
  }
}

/// Prints what was carved instead of the request, and why.
void tellWhatWasCarved(const EngraveRequest& asked, const Engraved& carved) {
  const char* const reason = carved.tried.front().failure ? "it could not be carved"
                             : asked.code.isText()        ? "the text would not have printed or read well"
                                                          : "the code or its print did not decode reliably";
  std::string flags;
  for (const SettingChange& change : carved.tried[carved.attempt].changes) {
    if (change.setting == "mark")
      fmt::print("made as {}: as a shadow, {}\n", change.value, reason);
    else if (change.setting == "preset")
      fmt::print("engraved with preset {}: with {}, {}\n", change.value, presetName(asked.depth.preset), reason);
    else if (change.setting == "carveFor")
      fmt::print(
          "engraved for the design only: when engraved for the print as well, the code did not decode reliably\n");
    else
      flags += fmt::format(" {} {}", flagOf(change.setting), change.value);
  }
  if (!flags.empty()) fmt::print("engraved with{}: as asked, {}\n", flags, reason);
}

/// Carves the code for other ways of printing and prints a verdict on each. Writes no files.
Status tryOtherPrints(Engraver& engraver, const EngraveOptions& options, const EngraveResult& result,
                      ProgressBar& bar) {
  fmt::print("engraved for other ways of printing:\n");
  const std::vector<SettingChange> others = otherPrints(verifyRequestOf(options.request, result));
  auto left = static_cast<double>(others.size());
  for (const SettingChange& other : others) {
    EngraveRequest changed = options.request;
    apply(other, changed);
    bar.next(1 / left--);
    const auto carved =
        engrave(engraver, changed, {.mayChange = false}, [&](const Progress& progress) { bar.show(progress); });
    bar.hide();
    QRELIEF_TRY(carved);
    fmt::print("  {} {}: {}\n", flagOf(other.setting), other.value,
               triedPrint(carved->verdict.prints, *carved->printed));
  }
  bar.finish();
  return {};
}

/// Prints advice on the text before it is carved.
void tellOfText(const EngraveOptions& options) {
  const CodeRequest& code = options.request.code;
  if (code.isText()) return;
  for (const TextAdvice& advice : adviseText(code.text))
    if (advice.severity == TextAdvice::Severity::Warning)
      printWarning(advice.message, {});
    else if (!options.quiet)
      printNote(advice.message);
  if (const auto smaller = adviseCapitals(code.text, code.symbol); smaller && !options.quiet) printNote(*smaller);
}

int engraveModel(EngraveOptions& options) {
  const auto start = Clock::now();
  const JsonOutput report(options.report);
  if (const Status completed = completeRequest(options); !completed) return printError(completed.error());
  for (const Message& unused : unusedFlags(options.flags, options.request)) printWarning(unused, {});
  tellOfText(options);
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
  const Graphics graphics = Graphics::open();
  context.gl = graphics.capabilities;
  const auto model = EngravableModel::create(std::move(input->prepared), graphics.pass);
  context.prepareMs = input->prepareMs + millisecondsSince(uploading);

  Engraver engraver(model);
  const EngraveRequest asked = options.request;
  ProgressBar bar(options.quiet, options.tryPrints ? kShareBeforeTries : 1);
  std::optional<EncodedCarving> encoded;
  auto carved = engrave(
      engraver, asked,
      {.mayMove = options.at.empty(),
       .offersMarks = true,
       .chosen = options.flags.given(),
       .otherMarks = marksInColour(formatOfName(options.output))},
      [&](const Progress& progress) { bar.show(progress); },
      [&](const Engraved& printing) { encoded = encode(options, *model, printing, input->partNames); });
  bar.hide();
  if (!carved) return printError(carved.error(), context.fileName);
  const bool triesPrints = options.tryPrints && carved->printed && carved->verdict.prints.level != Level::Good;
  if (!triesPrints) bar.finish();
  options.request = carved->request;
  if (options.at.empty()) printSpot(options.request.placement.centreMm, input->scaleToMm, stdout);
  tellWhatWasCarved(asked, *carved);
  context.tried = carved->tried;
  context.delivered = carved->attempt;
  context.spotMs = carved->spotMs;
  const EngraveResult& result = carved->result;
  context.printed = carved->printed;
  context.reading = carved->reading;
  context.verdict = carved->verdict;
  context.askedPreset = asked.depth.preset;
  context.wording = commandWording();
  context.reader = zxingName();

  if (!encoded || encoded->attempt != carved->attempt) encoded = encode(options, *model, *carved, input->partNames);
  if (const Status written = writeOutputs(options, *model, result, *encoded, report, context, start); !written)
    return printError(written.error());
  printSummary(options, result, context);
  if (!options.at.empty())
    if (const auto moved = centreMoved(asked.placement.centreMm, result.placement))
      printWarning(*moved, context.fileName);
  if (triesPrints)
    if (const Status tried = tryOtherPrints(engraver, options, result, bar); !tried) return printError(tried.error());
  return printFailed(context.verdict);
}

}  // namespace

std::function<int()> addEngraveCommand(CLI::App& app) {
  auto o = std::make_shared<EngraveOptions>();
  CLI::App* c = app.add_subcommand("engrave", "Engrave a QR code, or a text");
  addModelFlags(*c, o->model);
  o->flags.add(*c, "text").required();
  c->add_option("-o", o->output, "engraved model in mm: .stl, .obj, .ply or .3mf")->required()->check(whyNotWritable);
  c->add_flag("--ascii", o->ascii, "write the STL as text");
  addCentreFlag(
      *c, o->at,
      "X,Y,Z: centre of the code in file units; QRelief moves it to the nearest point of the surface [best spot]");
  o->flags.addAll(*c);
  o->file.add(*c);
  c->add_option("--report", o->report,
                "write a report of all results and measurements as JSON; - writes to standard output");
  c->add_option("--preview", o->preview, "write a picture of the result, as a phone sees it, as PNG")
      ->check(endsIn(".png"));
  c->add_option("--maps", o->maps,
                "write normal, height and luminance maps, and the depths of every pass, as NumPy arrays (.npz)")
      ->check(endsIn(".npz"));
  c->add_flag(
      "--try-prints", o->tryPrints,
      "if the print does not decode reliably, engrave for other orientations and finer processes and list the results");
  c->add_flag("--quiet", o->quiet, "do not show progress");
  return [o] { return engraveModel(*o); };
}

}  // namespace qrelief
