// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string_view>

#include "base/result.h"
#include "report/json_parts.h"
#include "verdict/verdict.h"

namespace qrelief {

/// Exit statuses, fixed by the contract.
enum ExitStatus { kEngraved = 0, kCheckFailed = 1, kBadUsage = 2, kBadInput = 3, kNoSolution = 4, kInternalError = 5 };

int exitStatusOf(ErrorKind code);

/// "qrelief: error: FILE: MESSAGE" and the hint on stderr. @returns the error's exit status
/// @param file  that the command works on; not named where the request itself makes no sense, or if it is empty
int printError(const Error& error, std::string_view file = {});

/// "qrelief: warning: FILE: MESSAGE" and the hint on stderr.
void printWarning(const Message& message, std::string_view file);

/// How reports word messages.
Wording commandWording();

/// The checks that a file did not pass, and what would help, on stderr. @returns kEngraved, or kCheckFailed
int printFailed(const Verdict& verdict);

/// Each adds its options to the program and returns what runs it.
std::function<int()> addBatchCommand(CLI::App& app);
std::function<int()> addEngraveCommand(CLI::App& app);
std::function<int()> addInfoCommand(CLI::App& app);
std::function<int()> addPlaceCommand(CLI::App& app);
std::function<int()> addVerifyCommand(CLI::App& app);

/// File units → mm by the two options that say so, if one does; `units` is one of mm, cm, m, in or empty.
Result<std::optional<double>> scaleFrom(std::optional<double> scale, const std::string& units);

}  // namespace qrelief
