// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace qrelief {

/// Makes a name safe for a line of text: control characters become blanks. Trailing backslashes are removed, because in
/// OBJ they would join the next line.
inline std::string oneLine(std::string_view text) {
  std::string line(text);
  for (char& c : line)
    if ((c >= 0 && c < ' ') || c == 127) c = ' ';
  while (!line.empty() && (line.back() == '\\' || line.back() == ' ')) line.pop_back();
  return line;
}

}  // namespace qrelief
