// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace qrelief {

/// A text with places to be filled: "https://example.org/p/{n:05}". `{name}` is a value as it is, `{name:05}` a whole
/// number with zeros before it up to that many digits, `{{` and `}}` are braces.
class TextTemplate {
 public:
  /// @returns BadUsage for a brace without its other half, an empty name, or something else behind the colon
  static Result<TextTemplate> parse(std::string_view text);

  /// Names of the places, each once, in the order of the text.
  const std::vector<std::string>& names() const { return names_; }

  /// @param valueOf  of each of the names
  /// @returns BadInput if a value that is to have zeros before it is no whole number
  Result<std::string> filled(const std::function<std::string(std::string_view)>& valueOf) const;

 private:
  struct Piece {
    std::string text;  ///< what stands there, or the place's name
    bool isPlace = false;
    std::size_t digits = 0;
  };
  std::vector<Piece> pieces_;
  std::vector<std::string> names_;
};

}  // namespace qrelief
