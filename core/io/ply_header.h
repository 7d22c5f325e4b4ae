// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace qrelief {

enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

std::size_t sizeOf(PlyType type);
bool isFloating(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float32;   ///< type of the value or of the list items
  std::optional<PlyType> countType;  ///< type of the list length; empty for a scalar
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  std::optional<std::size_t> find(std::string_view property) const;
};

enum class PlyFormat { Ascii, LittleEndian, BigEndian };

struct PlyHeader {
  PlyFormat format = PlyFormat::Ascii;
  std::vector<PlyElement> elements;
  std::size_t bytes = 0;  ///< offset of the data from the start of the file
  std::size_t lines = 0;  ///< number of header lines
};

/// Parses the header at the start of a PLY file.
/// @param text  the whole file, without byte order mark
Result<PlyHeader> parsePlyHeader(std::string_view text);

}  // namespace qrelief
