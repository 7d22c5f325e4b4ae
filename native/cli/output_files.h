// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"

namespace qrelief {

/// A file that a command reads or writes.
struct FileUse {
  std::string option;  ///< the option that names it, such as "-o"
  std::string path;    ///< empty: no such file; kStandardStream: an output's results go to standard output
};

/// The name of standard output among outputs, and of standard input among inputs.
inline constexpr std::string_view kStandardStream = "-";

/// Checks the files that a command will write, before it does any work.
/// @param inputs   files that it reads
/// @param outputs  files that it writes
/// @returns BadUsage if an output is an input or another output, also if their names differ only in capitals; BadInput
///          if an output cannot be written: the folder is missing or read-only, the name is too long, or the path is a
///          pipe or a device
Status checkOutputs(std::span<const FileUse> inputs, std::span<const FileUse> outputs);

/// Checks the file of --json against the model (checkOutputs).
Status checkJson(const std::string& json, const std::string& model);

/// The JSON that a command writes: a file or standard output. In the second case, everything else that the command
/// prints goes to standard error.
class JsonOutput {
 public:
  /// Nothing may have been printed before.
  /// @param path  empty: no JSON; kStandardStream: standard output
  explicit JsonOutput(std::string path);

  bool isWanted() const { return !path_.empty(); }

  /// BadInput if it cannot be written.
  Status write(std::string_view json) const;

 private:
  std::string path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> standardOutput_;
};

/// Returns true if both paths lead to one file, which need not exist.
bool isSameFile(const std::string& path, const std::string& other);

}  // namespace qrelief
