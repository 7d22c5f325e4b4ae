// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <string>

#include "messages/sentences.h"
#include "verdict/verdict.h"

namespace qrelief {

/// Describes a print that was tried: "Reads as printed, facing up (…); 40 of 72 tries".
inline std::string triedPrint(const Aspect& prints, const PrintedEvidence& printed) {
  const ReadingCount& count = printed.reading.count;
  return fmt::format("{}; {} of {} tries", sentence(prints.summary), count.reads, count.tries);
}

}  // namespace qrelief
