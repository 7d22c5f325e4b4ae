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

/// Exit statuses. Scripts rely on them.
enum ExitStatus { kEngraved = 0, kCheckFailed = 1, kBadUsage = 2, kBadInput = 3, kNoSolution = 4, kInternalError = 5 };

int exitStatusOf(ErrorKind code);

/// Prints "qrelief: error: FILE: MESSAGE" and the hint to stderr. @returns the error's exit status
/// @param file  the command's input; not printed if it is empty or the request itself makes no sense
int printError(const Error& error, std::string_view file = {});

/// Prints "qrelief: warning: FILE: MESSAGE" and the hint to stderr.
void printWarning(const Message& message, std::string_view file);

/// Prints "qrelief: note: MESSAGE" and the hint to stderr.
void printNote(const Message& message);

/// Returns the wording of messages in reports.
Wording commandWording();

/// Prints a file's failed checks and their remedies to stderr. @returns kEngraved, or kCheckFailed
int printFailed(const Verdict& verdict);

/// Each adds its options to the program and returns the function that runs the command.
std::function<int()> addBatchCommand(CLI::App& app);
std::function<int()> addEngraveCommand(CLI::App& app);
std::function<int()> addInfoCommand(CLI::App& app);
std::function<int()> addPlaceCommand(CLI::App& app);
std::function<int()> addVerifyCommand(CLI::App& app);

/// Returns the names that --units takes: "mm", "in", …
std::vector<std::string> unitNames();

/// Returns the factor from file units to mm, if one of the two options sets it; `units` is one of unitNames() or empty.
Result<std::optional<double>> scaleFrom(std::optional<double> scale, const std::string& units);

}  // namespace qrelief
