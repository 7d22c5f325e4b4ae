// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace qrelief {

enum class ModelFormat { Unknown, Stl, Obj, Ply, Off, ThreeMf, Gltf };

/// As the user knows it: "STL", "3MF", …
std::string_view nameOf(ModelFormat format);

/// What the name's extension says; upper and lower case alike.
ModelFormat formatOfName(std::string_view fileName);

/// What the content plainly is, from its first words and, for binary STL, its size; Unknown if it is not plain.
/// Cost: looks at no more than the first hundred lines.
ModelFormat formatOfContent(std::span<const std::uint8_t> bytes);

/// "UTF-16 LE" or "UTF-16 BE" if it begins with text of that encoding, with or without byte order mark; else empty.
std::string_view wideEncodingOf(std::span<const std::uint8_t> bytes);

}  // namespace qrelief
