// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "math/vec.h"
#include "verification/reader_view.h"

namespace qrelief {

/// A symbol that a decoder found in a picture.
struct SymbolRead {
  std::string text;  ///< UTF-8
  bool mirrored = false;
  std::array<Vec2, 4> corners{};  ///< px from the picture's top left: the symbol's top left, then clockwise
};

/// A QR Code decoder, supplied by the program around the core. Takes a picture and returns a symbol or nothing.
using Decoder = std::function<std::optional<SymbolRead>(const GreyImage&)>;

}  // namespace qrelief
