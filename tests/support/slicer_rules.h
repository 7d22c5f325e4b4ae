// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "math/vec.h"

/// How slicers read 3MF files: the rules of their loaders, each with its source in slicer_rules.cpp. OrcaSlicer and
/// Bambu Studio cannot run where these tests run.
namespace qrelief::slicer_rules {

/// A volume as a slicer has it after opening a file.
struct Volume {
  std::string name, kind;
  unsigned filament = 1;
  std::vector<std::array<Vec3, 3>> triangles;
  std::vector<unsigned> paint;  ///< filament of each triangle's paint; 0: none
};

struct Object {
  std::string name;
  std::vector<Volume> volumes;
};

struct Project {
  std::vector<Object> objects;
  std::vector<std::string> filamentColours;  ///< those that the file lists
  bool asksAboutParts = false;               ///< a dialog asks whether the objects are parts of one
  std::string refused;                       ///< why the file does not open; empty if it does

  /// Returns the filaments that volumes and paint use, ascending, each once.
  std::vector<unsigned> filaments() const;
};

/// PrusaSlicer 2.5, and 2.6 to 2.9, which also follow paths and read `paint_color`.
enum class PrusaVersion { V2_5, V2_9 };
Project openInPrusaSlicer(std::span<const std::uint8_t> file, PrusaVersion version);

/// OrcaSlicer 2.3 and Bambu Studio 2.5, whose loaders agree on everything that is checked here.
Project openInBambuStudio(std::span<const std::uint8_t> file);

}  // namespace qrelief::slicer_rules
