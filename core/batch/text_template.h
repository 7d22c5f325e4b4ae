// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace qrelief {

/// A text with placeholders: "https://example.org/p/{n:05}". `{name}` becomes the value as it is, `{name:05}` a whole
/// number padded with zeros to that many digits, `{{` and `}}` are braces.
class TextTemplate {
 public:
  /// @returns BadUsage for an unmatched brace, an empty name, or an invalid width after the colon
  static Result<TextTemplate> parse(std::string_view text);

  /// Returns the names of the placeholders, each once, in the order of the text.
  const std::vector<std::string>& names() const { return names_; }

  /// Fills the placeholders.
  /// @param valueOf  returns the value for a name
  /// @returns BadInput if a value to be padded is not a whole number
  Result<std::string> filled(const std::function<std::string(std::string_view)>& valueOf) const;

 private:
  struct Piece {
    std::string text;  ///< literal text, or the placeholder's name
    bool isPlace = false;
    std::size_t digits = 0;
  };
  std::vector<Piece> pieces_;
  std::vector<std::string> names_;
};

}  // namespace qrelief
