// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/mesh.h"

/// Small model files built in memory, each the simplest of its kind.
namespace qrelief::model_files {

using Bytes = std::vector<std::uint8_t>;

Bytes bytesOf(std::string_view text);

std::string asciiStl(const Mesh& mesh, std::string_view lineEnd = "\n");
std::string obj(const Mesh& mesh);
std::string off(const Mesh& mesh);

enum class PlyKind { Ascii, LittleEndian, BigEndian };
/// Writes float vertices, and faces as "list uchar int vertex_indices".
Bytes ply(const Mesh& mesh, PlyKind kind);

}  // namespace qrelief::model_files
