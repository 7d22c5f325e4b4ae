// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "pipeline/verify.h"
#include "report/json_parts.h"
#include "verdict/verdict.h"

namespace qrelief {

/// What an engraver's report (core/report/report.h) says of place, size, text and modules, and of the one light that it
/// was carved for; nothing else of it is believed.
/// @param json  the report
/// @returns BadInput naming the key that is missing or of the wrong kind
Result<VerifyRequest> requestFromReport(std::string_view json);

/// The symbol with the modules that a report lists: some may have been made light on purpose (Symbol::flipped).
/// @param rows  '1' = dark, top row first; as many as the symbol has
Result<Symbol> withModules(Symbol symbol, const std::vector<std::string>& rows);

/// What is said about a verified model beside the result itself.
struct VerifyReportContext {
  std::string fileName;
  std::string format;
  std::string reader;  ///< which reader, "ZXing-C++"
  double totalMs = 0;
  std::optional<PrintedEvidence> printed;  ///< none: it was not found out
  Verdict verdict;                         ///< see verdict/verdict.h
  Wording wording;                         ///< of the messages
};

/// The result as JSON. Keys as in the report of `engrave` where they mean the same.
std::string makeVerifyReport(const VerifyRequest& request, const VerifyResult& result,
                             const VerifyReportContext& context);

}  // namespace qrelief
