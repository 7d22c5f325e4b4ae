// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "base/message.h"

namespace qrelief {

enum class ModelFormat { Unknown, Stl, Obj, Ply, Off, ThreeMf, Gltf };

/// Returns the name that users know: "STL", "3MF", …
std::string_view nameOf(ModelFormat format);

/// Returns true for the formats that writeModel() writes (io/write_model.h).
bool isWritable(ModelFormat format);

/// Returns the format that the name's extension implies, in upper or lower case.
ModelFormat formatOfName(std::string_view fileName);

/// Returns the format that the content implies by its first words and, for binary STL, by its size. Unknown if the
/// content is not clear. Every ZIP archive counts as 3MF.
/// Cost: looks at no more than the first hundred lines.
ModelFormat formatOfContent(std::span<const std::uint8_t> bytes);

/// Returns "UTF-16 LE" or "UTF-16 BE" if the bytes begin with text of that encoding, with or without byte order mark;
/// else empty.
std::string_view wideEncodingOf(std::span<const std::uint8_t> bytes);

/// Returns what a file is that holds no model we can read, such as a picture, a web page or G-code, for an error; none
/// if the file shows no sign of it.
///
/// Cost: looks at no more than the first kilobytes.
std::optional<Message> identifyFile(std::span<const std::uint8_t> bytes);

}  // namespace qrelief
