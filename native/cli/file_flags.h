// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "io/write_model.h"

namespace qrelief {

/// Flags of a command that say how 3MF files are written: --for and --palette.
class FileFlags {
 public:
  /// FileFlags must outlive the parsing.
  void add(CLI::App& command);
  /// @param output  name of a file that will be written
  /// @returns BadUsage for a palette in files of a program that reads none, or for a slicer without a 3MF file
  Status check(const std::string& output) const;
  WriteOptions writeOptions(const std::string& title, bool ascii = false) const;
  /// Returns the flags as text, to be hashed.
  std::string text() const;

 private:
  Slicer slicer_ = Slicer::Any;
  bool palette_ = false;
};

}  // namespace qrelief
