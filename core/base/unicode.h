// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace qrelief {

/// Returns the text in composed form, NFC [Unicode 15, 3.11]: u and U+0308 become ü. CJK compatibility ideographs stay
/// as they are. Bytes that are not UTF-8 stay, too. Cost: linear for common text.
std::string composed(std::string_view utf8);

/// Returns the text without distinctions of case, in composed form [Unicode 15, 3.13, D145]. Two names with the same
/// result are one file for macOS or Windows. The dotless i stays apart from i. Cost: as for composed().
std::string caseFolded(std::string_view utf8);

/// Returns UTF-16 as UTF-8, without a byte order mark; none for an odd number of bytes or half a surrogate pair.
std::optional<std::string> utf8FromUtf16(std::span<const std::uint8_t> bytes, bool isBigEndian);

/// Returns Windows-1252 as UTF-8; none if a byte has no character there.
std::optional<std::string> utf8FromWindows1252(std::string_view bytes);

/// Appends the character in UTF-8.
void appendUtf8(std::string& text, char32_t code);

/// Returns the characters of the text. A byte that is not UTF-8 becomes U+FFFD.
std::u32string charactersOf(std::string_view utf8);

/// Returns true for characters that only take room: spaces, breaks between lines, and fillers.
bool isSpace(char32_t c);

/// Returns true for characters that take no room: soft hyphens, zero-width spaces, marks of the writing direction.
bool isUnseen(char32_t c);

/// Returns true for a text of such characters only, and for an empty one.
bool isBlank(std::string_view utf8);

}  // namespace qrelief
