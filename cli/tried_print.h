// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <string>

#include "messages/sentences.h"
#include "verdict/verdict.h"

namespace qrelief {

/// "Reads as printed, facing up (…); 40 of 72 tries", of a print that was tried.
inline std::string triedPrint(const Aspect& prints, const PrintedEvidence& printed) {
  const ReadingCount& count = printed.reading.count;
  return fmt::format("{}; {} of {} tries", sentence(prints.summary), count.reads, count.tries);
}

}  // namespace qrelief
