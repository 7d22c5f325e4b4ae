// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "mesh/mesh.h"

namespace qrelief {

/// Writes binary STL: 80-byte header, count, 50 bytes per triangle, little endian; positions bit for bit.
/// @param title  goes into the header, cut to 80 bytes; never begins with "solid"
std::vector<std::uint8_t> writeStl(const Mesh& mesh, std::string_view title = "QRelief");

/// Writes ASCII STL. Numbers are the shortest that give the same 32-bit floats.
/// @param title  the solid's name
std::vector<std::uint8_t> writeAsciiStl(const Mesh& mesh, std::string_view title = "QRelief");

}  // namespace qrelief
