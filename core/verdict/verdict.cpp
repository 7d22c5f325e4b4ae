// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict/verdict.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/self_intersection.h"
#include "message_codes/printing.h"
#include "message_codes/verdict.h"
#include "pipeline/engrave.h"
#include "pipeline/label_pockets.h"
#include "pipeline/verify.h"
#include "printing/build_direction.h"
#include "verdict/ink_advice.h"
#include "verdict/print_words.h"
#include "verdict/remedies.h"
#include "verdict/text_verdict.h"
#include "verification/grades.h"
#include "verification/printability.h"

namespace qrelief {
namespace {

/// Contrast of dark and light modules (ISO/IEC 29158, CC) that grade A requires.
constexpr double kGoodContrast = 0.3;
constexpr double kLeastGrade = 1;  // D
/// Distance of the symbol's corners from their places, in modules, beyond which the symbol is somewhere else.
constexpr double kMisplacedModules = 1.5;

/// What is known of a code besides its reading.
struct CodeFacts {
  std::optional<double> meanDepthMm;        ///< none: a code in colour, which is graded like ink on paper
  const SymbolGrades* grades = nullptr;     ///< null: nothing could be measured
  std::optional<double> shellBelowMm = {};  ///< see EngraveResult
  bool isInverted = false;                  ///< a code in colour that is lighter than its body
};

/// Returns the reasons why a code does not read; empty if it does.
std::vector<Message> readingFailures(const ReadingEvidence& reading, const std::string& expected,
                                     const CodeFacts& code) {
  const ReadingCount& count = reading.count;
  if (!reading.text.empty() && reading.text != expected)
    return {message<"other-text">(with::quoted<"found">(reading.text), with::quoted<"wanted">(expected))};
  if (count.enough()) return {};
  const auto reads = with::count<"reads">(count.reads);
  const auto tries = with::count<"tries">(count.tries);
  const auto needed = with::count<"needed">(count.needed());
  if (!code.meanDepthMm && code.isInverted) return {message<"inverted-ink-unreadable">(reads, tries, needed)};
  if (!code.meanDepthMm) return {message<"ink-unreadable">(reads, tries, needed)};
  const auto depth = with::lengthMm<"depth">(*code.meanDepthMm);
  if (code.shellBelowMm)
    return {
        message<"too-shallow-over-shell">(depth, with::lengthMm<"below">(*code.shellBelowMm), reads, tries, needed)};
  if (code.grades && code.grades->cellContrast.value < kGoodContrast)
    return {message<"too-shallow">(depth, with::fraction<"contrast">(code.grades->cellContrast.value), reads, tries,
                                   needed)};
  return {message<"unreadable">(reads, tries, needed)};
}

/// Returns the warning that must come with a code that is read under one lamp.
Message oneLightNeeded(const DirectionalLight& lamp) {
  const auto from = [&] {
    const double azimuth = lamp.azimuthDeg - 360 * std::floor(lamp.azimuthDeg / 360);
    switch (static_cast<int>(std::floor((azimuth + 22.5) / 45)) % 8) {
      case 0:
        return message<"light-from-right">();
      case 1:
        return message<"light-from-top-right">();
      case 2:
        return message<"light-from-top">();
      case 3:
        return message<"light-from-top-left">();
      case 4:
        return message<"light-from-left">();
      case 5:
        return message<"light-from-bottom-left">();
      case 6:
        return message<"light-from-bottom">();
      default:
        return message<"light-from-bottom-right">();
    }
  };
  return message<"needs-one-light">(with::cause<"from">(from()), with::angleDeg<"elevation">(lamp.elevationDeg));
}

Message readingSummary(const ReadingEvidence& reading, const std::string& expected, Level level) {
  if (reading.text.empty()) return message<"reads-not">();
  if (reading.text != expected) return message<"reads-wrong">(with::quoted<"text">(reading.text));
  if (level == Level::Bad) return message<"reads-not-reliably">();
  if (level == Level::Good) return message<"reads-as">(with::term<"text">(expected));
  return message<"barely-reads-as">(with::term<"text">(expected));
}

Aspect judgeReading(const ReadingEvidence& reading, const std::string& expected, const CodeFacts& code) {
  Aspect aspect;
  const SymbolGrades* const grades = code.grades;
  aspect.failed = readingFailures(reading, expected, code);
  const bool weak = grades && (code.meanDepthMm ? grades->iso29158 : grades->iso15415) < kLeastGrade;
  aspect.level = !aspect.passed() ? Level::Bad : weak ? Level::Barely : Level::Good;
  aspect.summary = readingSummary(reading, expected, aspect.level);
  if (reading.text.empty()) {
    aspect.reasons.push_back(message<"no-reader-found-it">());
    return aspect;
  }
  const ReadingCount& count = reading.count;
  aspect.reasons.push_back(
      reading.traced
          ? message<"tries-on-traced-pictures">(with::count<"reads">(count.reads), with::count<"tries">(count.tries),
                                                with::count<"needed">(count.needed()))
          : message<"tries-on-drawn-pictures">(with::count<"reads">(count.reads), with::count<"tries">(count.tries),
                                               with::count<"needed">(count.needed())));
  if (grades)
    aspect.reasons.push_back(
        message<"correction-left">(with::fraction<"left">(std::max(0.0, grades->unusedCorrection.value))));
  if (weak) aspect.reasons.push_back(message<"graded-weak">());
  return aspect;
}

/// Judges whether a code prints.
/// @param advice   warnings
/// @param because  reason for a print without warnings
/// @param printed  null: judge by the warnings alone
Aspect judgePrinting(std::vector<Message> advice, const Message& because, const Printer& printer,
                     const PrintedEvidence* printed, const std::string& expected) {
  if (printed) return judgePrinted(*printed, printer, expected, std::move(advice));
  Aspect aspect;
  aspect.reasons = std::move(advice);
  if (aspect.reasons.empty()) {
    aspect.summary = message<"prints">(with::lengthMm<"nozzle">(printer.nozzleMm));
    aspect.reasons.push_back(because);
  } else {
    aspect.level = Level::Barely;
    aspect.summary = message<"may-not-print">(with::lengthMm<"nozzle">(printer.nozzleMm));
  }
  return aspect;
}

/// Adds a warning that is none of the reasons.
void addUnlessReason(Aspect& aspect, std::optional<Message> warning) {
  if (warning && std::find(aspect.reasons.begin(), aspect.reasons.end(), *warning) == aspect.reasons.end())
    aspect.warnings.push_back(std::move(*warning));
}

Aspect judgePocketPrinting(const CarvedFeatures& features, const Printer& printer, double minWallMm,
                           const PrintedEvidence* printed, const std::string& expected) {
  const double layers = features.leastDepthMm / printer.layerMm;
  return judgePrinting(advisePrinting(features, printer, minWallMm),
                       message<"prints-because">(with::lengthMm<"pocket">(features.pocketMm),
                                                 with::count<"count">(std::floor(layers + 1e-9))),
                       printer, printed, expected);
}

Aspect judgeInkPrinting(const InkedCode& code, const PrintedEvidence* printed, const std::string& expected) {
  return judgePrinting(adviseInkPrinting(code),
                       message<"colour-prints-because">(with::lengthMm<"module">(code.moduleMm),
                                                        with::lengthMm<"line">(lineWidthMm(code.printer))),
                       code.printer, printed, expected);
}

/// @param inherited  pairs of crossing triangles that the model already had
Aspect judgeSolidity(const SolidityReport& solid, std::size_t inherited) {
  Aspect aspect;
  SolidityReport own = solid;
  own.selfIntersections -= std::min(inherited, solid.selfIntersections);
  for (const SolidityFinding& finding : own.findings())
    aspect.failed.push_back(
        finding.at ? message<"not-solid-at">(with::cause<"problem">(finding.message), with::place<"at">(*finding.at))
                   : message<"not-solid">(with::cause<"problem">(finding.message)));
  if (!aspect.passed()) {
    aspect.level = Level::Bad;
    aspect.summary = message<"solid-not">();
    aspect.reasons = aspect.failed;
  } else if (solid.selfIntersections > 0) {
    aspect.level = Level::Barely;
    aspect.summary = message<"solid-but-crossing">();
    const auto count = with::count<"count">(solid.selfIntersections);
    aspect.reasons.push_back(solid.selfIntersections < kMaxCrossingsListed
                                 ? message<"inherited-crossings">(count)
                                 : message<"many-inherited-crossings">(count));
  } else {
    aspect.summary = message<"solid">();
    aspect.reasons.push_back(message<"solid-because">(with::count<"count">(solid.triangles)));
  }
  return aspect;
}

/// Returns the faults in pose and depth of the code in a verified file.
std::vector<Message> shapeFailures(const VerifyResult& result) {
  const CarvingProfile& profile = result.profile;
  const double depth = profile.meanDepthMm;
  std::vector<Message> failed;
  switch (profile.pose) {
    case SymbolPose::AsWanted:
      break;
    case SymbolPose::Mirrored:
      failed.push_back(message<"mirrored">());
      break;
    case SymbolPose::Turned90:
    case SymbolPose::Turned180:
    case SymbolPose::Turned270:
      failed.push_back(message<"turned">(
          with::angleDeg<"turn">(90 * (static_cast<int>(profile.pose) - static_cast<int>(SymbolPose::AsWanted)))));
      break;
    case SymbolPose::None:
      // A decoder may still find a code: then its modules are not the expected ones, and nothing is known about them.
      if (!result.reading.frontal.enough()) failed.push_back(message<"no-code">());
      return failed;
  }
  if (depth < -kFlatMm)
    failed.push_back(message<"raised">(with::lengthMm<"height">(-depth)));
  else if (depth <= kFlatMm)
    failed.push_back(message<"not-carved">());
  return failed;
}

}  // namespace

Aspect judgePrinted(const PrintedEvidence& printed, const Printer& printer, const std::string& expected,
                    std::vector<Message> advice) {
  const ReadingCount& count = printed.reading.count;
  const bool some = printed.enough() && printed.reading.text == expected;
  Aspect aspect;
  const bool hangs = printed.facingDeg > kSteepestOverhangDeg;
  aspect.level = !some ? Level::Bad : count.enough() && !hangs ? Level::Good : Level::Barely;
  const Message how = facing(printed.facingDeg), by = printing(printer);
  if (aspect.level == Level::Good)
    aspect.summary = message<"reads-as-printed">(with::cause<"facing">(how), with::cause<"printing">(by));
  else if (some && count.enough())
    aspect.summary = message<"reads-as-printed-hanging">(with::cause<"facing">(how), with::cause<"printing">(by));
  else if (aspect.level == Level::Barely)
    aspect.summary = message<"barely-reads-as-printed">(with::cause<"facing">(how), with::cause<"printing">(by));
  else
    aspect.summary = message<"reads-not-as-printed">(with::cause<"facing">(how), with::cause<"printing">(by));
  aspect.reasons.push_back(message<"tries-on-printed-pictures">(
      with::count<"reads">(count.reads), with::count<"tries">(count.tries), with::count<"needed">(printed.needed())));
  if (!some)
    aspect.failed.push_back(message<"unreadable-as-printed">(
        with::cause<"facing">(how), with::cause<"printing">(by), with::count<"reads">(count.reads),
        with::count<"tries">(count.tries), with::count<"needed">(printed.needed())));
  if (hangs) aspect.reasons.push_back(message<"faces-down">());
  if (aspect.level != Level::Good) aspect.reasons.insert(aspect.reasons.end(), advice.begin(), advice.end());
  return aspect;
}

const char* levelName(Level level) {
  constexpr std::array<const char*, 3> kNames = {"good", "barely", "bad"};
  return kNames[static_cast<std::size_t>(level)];
}

std::vector<Message> Verdict::failed() const {
  std::vector<Message> all;
  for (const Aspect* aspect : {&solid, &reads, &prints})
    all.insert(all.end(), aspect->failed.begin(), aspect->failed.end());
  return all;
}

ReadingEvidence evidenceOf(const std::vector<std::string>& texts, const std::string& expected, bool traced) {
  ReadingEvidence evidence{{static_cast<int>(texts.size()), 0}, {}, traced};
  for (const std::string& text : texts) {
    if (text == expected) ++evidence.count.reads;
    if (evidence.text.empty() || text == expected) evidence.text = text.empty() ? evidence.text : text;
  }
  return evidence;
}

SymbolGrades gradesOf(const EngraveRequest& request, const EngraveResult& result) {
  return gradeSymbol(measureModules(result.symbol, request.marking.isInColour()
                                                       ? withoutInversion(result.luminance, request.marking.ink())
                                                       : result.luminance),
                     request.marking.surfaceAlbedo());
}

namespace {

/// Removes remedies that an aspect before it offers, if both fail.
void offerRemediesOnce(Verdict& verdict) {
  std::vector<Remedy> offered;
  for (Aspect* aspect : {&verdict.solid, &verdict.reads, &verdict.prints}) {
    if (aspect->passed()) continue;
    std::erase_if(aspect->remedies, [&](const Remedy& remedy) {
      return std::find(offered.begin(), offered.end(), remedy) != offered.end();
    });
    offered.insert(offered.end(), aspect->remedies.begin(), aspect->remedies.end());
  }
}

/// Judges whether a carved code reads and prints.
Verdict judgeCode(const EngraveRequest& request, const EngraveResult& result, const ReadingEvidence& reading,
                  const PrintedEvidence* printed) {
  const SymbolGrades grades = gradesOf(request, result);
  Verdict verdict;
  const bool isInColour = request.marking.isInColour();
  verdict.reads =
      judgeReading(reading, request.code.text,
                   {.meanDepthMm = isInColour ? std::nullopt : std::optional(summarise(result.depths).meanMm),
                    .grades = &grades,
                    .shellBelowMm = result.shellBelowMm,
                    .isInverted = isInColour && request.marking.ink().isInverted()});
  if (request.isForOneLight()) verdict.reads.warnings = {oneLightNeeded(request.lamps().front())};
  if (isInColour) verdict.reads.warnings = adviseInk(request.marking.ink());
  if (result.coversColours) verdict.reads.warnings.push_back(message<"spot-in-several-colours">());
  if (result.modulesLeftOut > 0)
    verdict.reads.warnings.push_back(message<"modules-left-out">(with::count<"count">(result.modulesLeftOut),
                                                                 with::lengthMm<"wall">(request.depth.minWallMm)));
  if (result.unfinishedSubmodules > 0)
    verdict.reads.warnings.push_back(message<"search-ended">(with::count<"count">(result.unfinishedSubmodules),
                                                             with::count<"passes">(result.searchIterations)));
  if (verdict.reads.level != Level::Good) {
    const std::size_t atLimit = result.limitedSubmodules - result.unfinishedSubmodules;
    if (atLimit > 0) verdict.reads.reasons.push_back(message<"submodules-limited">(with::count<"count">(atLimit)));
    if (result.shellBelowMm && verdict.reads.passed())
      verdict.reads.reasons.push_back(message<"shell-below">(with::lengthMm<"below">(*result.shellBelowMm)));
    verdict.reads.remedies = readingRemedies(request, result);
  }
  verdict.prints = isInColour ? judgeInkPrinting({request.marking.mark, result.placement.moduleMm, result.markDepthMm,
                                                  result.opaqueDepthMm, request.print.printer},
                                                 printed, request.code.text)
                              : judgePocketPrinting(featuresOf(result), request.print.printer, request.depth.minWallMm,
                                                    printed, request.code.text);
  if (const auto capitalMm = labelCapitalMm(request.code.label, result.symbol.size, result.placement.moduleMm))
    addUnlessReason(verdict.prints, adviseLabel(*capitalMm, request.print.printer));
  if (verdict.prints.level != Level::Good)
    verdict.prints.remedies = printingRemedies(request, result, printed != nullptr);
  return verdict;
}

}  // namespace

Verdict judge(const EngraveRequest& request, const EngraveResult& result, const ReadingEvidence& reading,
              const PrintedEvidence* printed) {
  Verdict verdict;
  if (request.code.isText())
    verdict = {judgeLegibility(request, result), judgeStrokes(request, result), {}};
  else
    verdict = judgeCode(request, result, reading, printed);
  verdict.solid = judgeSolidity(result.solidity, result.inheritedSelfIntersections);
  if (result.inlay)
    for (const Message& failure : judgeSolidity(result.inlaySolidity, 0).failed)
      verdict.solid.failed.push_back(message<"inlay-not-solid">(with::cause<"problem">(failure)));
  if (!verdict.solid.passed()) {
    verdict.solid.level = Level::Bad;
    verdict.solid.summary = message<"solid-not">();
    verdict.solid.reasons = verdict.solid.failed;
    verdict.solid.remedies = {anotherSpot()};
  }
  offerRemediesOnce(verdict);
  return verdict;
}

namespace {

/// Judges whether the code of a verified file reads and prints.
Verdict judgeFoundCode(const VerifyRequest& request, const VerifyResult& result, const PrintedEvidence* printed) {
  const ReadingSummary& reading = result.reading;
  const CarvingProfile& profile = result.profile;
  const ReadingEvidence evidence{reading.frontal, reading.frontal.reads > 0 ? request.text : reading.otherText,
                                 request.isTraced};
  const bool isInColour = request.mark != Mark::Shadow;
  Verdict verdict;
  verdict.reads = judgeReading(evidence, request.text,
                               {.meanDepthMm = isInColour ? std::nullopt : std::optional(profile.meanDepthMm),
                                .grades = result.grades ? &*result.grades : nullptr,
                                .isInverted = isInColour && request.ink().isInverted()});
  if (request.needsLamp) verdict.reads.warnings = {oneLightNeeded(request.lamps.front())};
  if (isInColour) verdict.reads.warnings = adviseInk(request.ink());
  if (request.mark == Mark::Paint) verdict.reads.warnings.push_back(message<"paint-not-checked">());
  std::vector<Message> failed = isInColour ? std::vector<Message>() : shapeFailures(result);
  const bool isExplained = !isInColour && (profile.pose == SymbolPose::Mirrored || profile.meanDepthMm <= kFlatMm);
  if (!reading.otherText.empty())
    failed.push_back(
        message<"other-text">(with::quoted<"found">(reading.otherText), with::quoted<"wanted">(request.text)));
  else if (!isExplained)
    failed.insert(failed.end(), verdict.reads.failed.begin(), verdict.reads.failed.end());
  if (reading.mirrored && profile.pose != SymbolPose::Mirrored) failed.push_back(message<"mirrored">());
  const bool otherPose = profile.pose != SymbolPose::AsWanted && profile.pose != SymbolPose::None;
  if (!otherPose && reading.cornerErrorModules.value_or(0) > kMisplacedModules)
    failed.push_back(message<"misplaced">(with::number<"modules">(std::round(10 * *reading.cornerErrorModules) / 10)));
  if (!failed.empty()) verdict.reads.level = Level::Bad;
  verdict.reads.failed = std::move(failed);
  if (isInColour)
    verdict.prints = judgeInkPrinting(
        {request.mark, request.symbolMm / request.symbol.size, request.markDepthMm, 0, request.printer}, printed,
        request.text);
  else if (result.features)
    verdict.prints = judgePocketPrinting(*result.features, request.printer, request.minWallMm, printed, request.text);
  if (const auto capitalMm = labelCapitalMm(request.label, request.symbol.size, request.symbolMm / request.symbol.size))
    addUnlessReason(verdict.prints, adviseLabel(*capitalMm, request.printer));
  return verdict;
}

}  // namespace

Verdict judge(const VerifyRequest& request, const VerifyResult& result, const PrintedEvidence* printed) {
  Verdict verdict;
  if (request.isText())
    verdict.reads.summary = message<"text-not-decoded">();
  else
    verdict = judgeFoundCode(request, result, printed);
  verdict.solid = judgeSolidity(result.solidity, request.inheritedSelfIntersections);
  return verdict;
}

std::optional<SettingChange> changeToTryNext(const EngraveRequest& request, const Verdict& verdict,
                                             const PrintedEvidence* printed) {
  if (!request.needsLight()) return std::nullopt;  // depth does not make ink darker, or letters larger
  const bool reads = verdict.reads.passed();
  if (reads && !(printed && verdict.prints.level == Level::Barely && !printed->reading.count.enough()))
    return std::nullopt;
  if (!reads && request.isForPrint()) return SettingChange{"carveFor", "design"};
  const bool mayGoDeeper = !request.depth.contrast && !request.depth.keepPreset;
  const std::optional<Preset> deeper = mayGoDeeper ? deeperPreset(request.depth.preset) : std::nullopt;
  return deeper ? std::optional(SettingChange{"preset", presetName(*deeper)}) : std::nullopt;
}

}  // namespace qrelief
