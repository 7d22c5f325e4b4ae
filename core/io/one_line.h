// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace qrelief {

/// A name as it may stand in a line of text: control characters become blanks, and no backslash is left at the end,
/// which would join the next line in OBJ.
inline std::string oneLine(std::string_view text) {
  std::string line(text);
  for (char& c : line)
    if ((c >= 0 && c < ' ') || c == 127) c = ' ';
  while (!line.empty() && (line.back() == '\\' || line.back() == ' ')) line.pop_back();
  return line;
}

}  // namespace qrelief
