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
  /// @returns BadUsage for a palette in files of a program that reads none
  Status check() const;
  WriteOptions writeOptions(const std::string& title, bool ascii = false) const;
  /// Returns the flags as text, to be hashed.
  std::string text() const;

 private:
  Slicer slicer_ = Slicer::Any;
  bool palette_ = false;
};

}  // namespace qrelief
