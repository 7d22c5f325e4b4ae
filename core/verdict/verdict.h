// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/engrave.h"
#include "pipeline/verify.h"
#include "settings/settings.h"
#include "verification/frontal_reading.h"

namespace qrelief {

enum class Level : std::uint8_t { Good, Barely, Bad };

/// "good", "barely", "bad": names that scripts rely on.
const char* levelName(Level level);

/// What would help, as something to be done with one press.
struct Remedy {
  Message message;      ///< "Allow 45 mm"
  std::string setting;  ///< key of the setting that it changes; empty: another place has to be chosen
  std::string value;    ///< that setting's new value, as settings files write it; empty: its default
};

/// One of the three questions about a carved code.
struct Aspect {
  Level level = Level::Good;
  Message summary;                ///< "Reads as …"
  std::vector<Message> warnings;  ///< to be told whatever the level
  std::vector<Message> reasons;   ///< what the summary rests on
  std::vector<Message> failed;    ///< checks that did not pass; empty: passed
  std::vector<Remedy> remedies;   ///< empty if the level is Good

  bool passed() const { return failed.empty(); }
};

/// What decoders made of the pictures of frontalPictures().
struct ReadingEvidence {
  ReadingCount count;
  std::string text;     ///< that a try gave: the wanted one if any did, else another; empty: none
  bool traced = false;  ///< the pictures' light was traced path by path; else found on height maps
};

/// What decoders made of frontalPictures() of the surface that a printer leaves (pipeline/printed_view.h).
struct PrintedEvidence {
  ReadingEvidence reading;
  std::string process;   ///< how it was printed: the name of one of namedPrinters()
  double facingDeg = 0;  ///< see PrintedView
};

/// Whether a carved code reads, prints and is a solid. `engrave`, `verify`, the report and the page all say this.
///
/// - It reads if at least ReadingCount::needed() tries succeed and none gives another text. It barely reads if fewer
///   do, or if a verifier would grade it F (ISO/IEC 29158).
/// - It prints if it still reads as the printer leaves it, by the same rule. It barely prints if at least one in six
///   tries succeeds; fewer are luck. Where that was not found out, it prints if
///   nothing of what published prints say stands against it (verification/printability.h). Either is advice and no
///   check: it passes always.
/// - It is a solid if the whole file is closed, manifold and free of crossing triangles, but for those that the model
///   brought along, which are said and passed.
struct Verdict {
  Aspect reads, prints, solid;

  bool passed() const { return reads.passed() && solid.passed(); }
  std::vector<Message> failed() const;  ///< of all three
};

/// Counts the tries. @param texts  what each try gave, empty if nothing; a mirrored code is nothing
ReadingEvidence evidenceOf(const std::vector<std::string>& texts, const std::string& wanted, bool traced = false);

/// What was carved, with remedies among the request's settings.
/// @param printed  null: it was not found out
Verdict judge(const EngraveRequest& request, const EngraveResult& result, const ReadingEvidence& reading,
              const PrintedEvidence* printed = nullptr);

/// A file that was verified.
Verdict judge(const VerifyRequest& request, const VerifyResult& result, const PrintedEvidence* printed = nullptr);

/// What a print comes to by itself; no remedies.
/// @param printer  it was printed with
/// @param wanted   text
/// @param advice   what published prints say against it
Aspect judgePrinted(const PrintedEvidence& printed, const Printer& printer, const std::string& wanted,
                    std::vector<Message> advice = {});

/// The change to try next, if the request allows it; none: nothing is left to try.
///
/// - Where the code does not read: carving for the design alone, then the next deeper presets. Carving for the print
///   makes some modules deeper than walls let others be, and can cost the design.
/// - Where it reads, but its print barely does: the next deeper preset. A print that no try reads is not mended so.
///
/// @param printed  null: the print is not known
std::optional<SettingChange> changeToTryNext(const EngraveRequest& request, const Verdict& verdict,
                                             const PrintedEvidence* printed = nullptr);

}  // namespace qrelief
