// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "base/colour.h"
#include "io/zip_archive.h"

namespace qrelief {

/// Reads a colour such as "#0A7FFF" or "#0A7FFFFF", whose opacity does not count. None for any other text.
std::optional<Colour> colourFrom(std::string_view text);

/// The colours of a slicer's filaments.
class FilamentColours {
 public:
  FilamentColours() = default;
  /// Reads them from the settings of Bambu Studio and OrcaSlicer, or of PrusaSlicer; unreadable settings have none.
  /// @param maxBytes  unpacked size of a file
  FilamentColours(const ZipArchive& archive, std::uint64_t maxBytes);

  /// Returns the colour of a filament; none if the file says none.
  /// @param number  from 1
  std::optional<Colour> of(std::uint32_t number) const;
  /// Returns one of eight colours, to tell filaments apart whose colours are unknown.
  static Colour standIn(std::uint32_t number);

 private:
  std::vector<std::optional<Colour>> colours_;
};

}  // namespace qrelief
