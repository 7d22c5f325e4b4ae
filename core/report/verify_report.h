// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "pipeline/verify.h"
#include "report/json_parts.h"
#include "verdict/verdict.h"

namespace qrelief {

/// Reads place, pose, size, text, modules, mark, colours and the one light that the code was carved for from an
/// engraver's report (core/report/report.h), of a code or of a text alone. Trusts nothing else in it.
/// @param json  the report
/// @returns BadInput naming the key that is missing or of the wrong kind
Result<VerifyRequest> requestFromReport(std::string_view json);

/// Returns the symbol with the modules listed in a report: some may have been made light on purpose (Symbol::flipped).
/// @param rows  '1' = dark, top row first; as many as the symbol has
/// @returns BadInput if the rows are malformed, or no code of the symbol's text, version, level and mask
Result<Symbol> withModules(Symbol symbol, const std::vector<std::string>& rows);

/// Contents of the report on a verified model in addition to the result itself.
struct VerifyReportContext {
  std::string fileName;
  std::string format;
  std::string reader;  ///< name of the decoder, "ZXing-C++"
  double totalMs = 0;
  std::optional<PrintedEvidence> printed;  ///< none: the print was not simulated
  Verdict verdict;                         ///< see verdict/verdict.h
  Wording wording;                         ///< wording of the messages
};

/// Makes the report as JSON. Keys are the same as in the report of `engrave` where they mean the same.
std::string makeVerifyReport(const VerifyRequest& request, const VerifyResult& result,
                             const VerifyReportContext& context);

}  // namespace qrelief
