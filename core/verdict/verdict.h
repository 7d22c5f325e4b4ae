// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "settings/settings.h"
#include "verification/frontal_reading.h"
#include "verification/grades.h"

namespace qrelief {

struct EngraveRequest;
struct EngraveResult;
struct Printer;
struct VerifyRequest;
struct VerifyResult;

enum class Level : std::uint8_t { Good, Barely, Bad };

/// Returns "good", "barely" or "bad": names that scripts rely on.
const char* levelName(Level level);

/// A suggestion that the user can apply with one press.
struct Remedy {
  Message message;                     ///< "Allow 45 mm"
  std::vector<SettingChange> changes;  ///< with an empty value for the default; empty: the user chooses another spot

  bool operator==(const Remedy&) const = default;
};

/// One of the three questions about a carved code.
struct Aspect {
  Level level = Level::Good;      ///< Bad exactly if a check did not pass
  Message summary;                ///< "Reads as …"
  std::vector<Message> warnings;  ///< shown at every level
  std::vector<Message> reasons;   ///< grounds for the summary
  std::vector<Message> failed;    ///< checks that did not pass; empty: passed
  std::vector<Remedy> remedies;   ///< empty if the level is Good; without those of another aspect that failed

  bool passed() const { return failed.empty(); }
};

/// Decoding results of the pictures of frontalPictures().
struct ReadingEvidence {
  ReadingCount count;
  std::string text;     ///< decoded text: the wanted one if any try gave it, else another; empty: none
  bool traced = false;  ///< true: light traced path by path; false: light computed on height maps
};

/// Decoding results of frontalPictures() of the printed surface (pipeline/printed_view.h).
struct PrintedEvidence {
  ReadingEvidence reading;
  std::string process;   ///< the printing process: the name of one of namedPrinters()
  double facingDeg = 0;  ///< see PrintedView

  /// Returns the number of tries that must succeed for the print to pass: at least one in six, as fewer are luck. Fewer
  /// than three of five families of decoders read 23 of 27 such prints (bench/printing).
  int needed() const { return (reading.count.tries + 5) / 6; }
  bool enough() const { return reading.count.tries > 0 && reading.count.reads >= needed(); }
};

/// The answer to three questions: does a carved code read, does it print, is it a solid? `engrave`, `verify`, the
/// report and the page all use it.
///
/// A code in colour is judged by the same rules, as ink: by ISO/IEC 15415, and with warnings about its colours.
/// A text alone is not decoded: it reads if its letters are large, and prints if the printer makes their strokes.
///
/// - The code reads if at least ReadingCount::needed() tries succeed; in `verify`, also no try may give another text.
///   It barely reads if it passes, but a verifier would grade it F (ISO/IEC 29158). One that does not pass is never
///   said to read.
/// - It prints if at least PrintedEvidence::needed() tries on the simulated print succeed. It barely prints if these
/// are
///   fewer than the first rule asks for, or if it faces down by more than kSteepestOverhangDeg. If the print was not
///   simulated, published prints give the answer (verification/printability.h). That is advice and always passes.
/// - It is a solid if the whole file is closed, manifold and free of crossing triangles. Crossings that the model
///   already had are reported, but pass.
struct Verdict {
  Aspect reads, prints, solid;

  bool passed() const { return reads.passed() && prints.passed() && solid.passed(); }
  std::vector<Message> failed() const;  ///< failed checks of all three
};

/// Counts the tries.
/// @param texts  text of each try, empty for none; a mirrored code counts as none
ReadingEvidence evidenceOf(const std::vector<std::string>& texts, const std::string& expected, bool traced = false);

/// Grades the luminances at the end of the depth search, not a picture.
SymbolGrades gradesOf(const EngraveRequest& request, const EngraveResult& result);

/// Judges a carved code, with remedies among the request's settings.
/// @param printed  null: the print was not simulated
Verdict judge(const EngraveRequest& request, const EngraveResult& result, const ReadingEvidence& reading,
              const PrintedEvidence* printed = nullptr);

/// Judges a file that was verified; of a text alone only the solid.
Verdict judge(const VerifyRequest& request, const VerifyResult& result, const PrintedEvidence* printed = nullptr);

/// Judges a print by itself, without remedies.
/// @param printer   the printer that made it
/// @param expected  the code's text
/// @param advice    warnings from published prints
Aspect judgePrinted(const PrintedEvidence& printed, const Printer& printer, const std::string& expected,
                    std::vector<Message> advice = {});

/// Returns the change to try next, if the request allows one; none: nothing is left to try.
///
/// - If the code does not read: first carve for the design alone, then try the next deeper presets. Carving for the
///   print makes some modules deeper than walls allow for others, which can spoil the design.
/// - If the code reads but its print barely does: try the next deeper preset. If the print does not even barely read, a
///   deeper preset does not help.
///
/// @param printed  null: the print is not known
std::optional<SettingChange> changeToTryNext(const EngraveRequest& request, const Verdict& verdict,
                                             const PrintedEvidence* printed = nullptr);

}  // namespace qrelief
