// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "base/result.h"

namespace qrelief {

/// A file that a command reads or writes.
struct FileUse {
  std::string option;  ///< the option that names it, such as "-o"
  std::string path;    ///< empty: no such file
};

/// Checks the files that a command will write, before it does any work.
/// @param inputs   files that it reads
/// @param outputs  files that it writes
/// @returns BadUsage if an output is an input or another output, also if their names differ only in capitals; BadInput
///          if an output cannot be written: the folder is missing or read-only, the name is too long, or the path is a
///          pipe or a device
Status checkOutputs(std::span<const FileUse> inputs, std::span<const FileUse> outputs);

/// Checks the file of --json against the model (checkOutputs).
Status checkJson(const std::string& json, const std::string& model);

/// Returns true if both paths lead to one file, which need not exist.
bool isSameFile(const std::string& path, const std::string& other);

}  // namespace qrelief
