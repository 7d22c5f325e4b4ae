// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "qr/symbol.h"

namespace qrelief {

/// Advice on a text.
struct TextAdvice {
  enum class Severity : std::uint8_t { Warning, Note };
  Severity severity = Severity::Warning;
  Message message;
  std::string fixed;  ///< the corrected text; empty: there is none
};

/// Checks a text that is, or was meant to be, a link: unseen characters, quotation marks and spaces around it, a
/// missing or misspelt scheme, an incomplete address, a host in other letters, parameters that only track visitors.
/// Checks the data of a Wi-Fi network or a contact as well (qr/payload_advice.h).
///
/// Cost: linear.
/// @param text  UTF-8
/// @returns none for good ones, and for all other texts
std::vector<TextAdvice> adviseText(std::string_view text);

/// Another way to write a link that may need a smaller symbol.
struct ShorterForm {
  enum class Kind : std::uint8_t { Capitals, WithoutWww, WithoutHighlight };
  Kind kind = Kind::Capitals;
  std::string text;
};

/// Returns "capitals", "www" or "highlight".
const char* shorterFormName(ShorterForm::Kind kind);

/// Returns other forms of a link, the safest first. Scheme and host mean the same in capitals [RFC 3986, 6.2.2.1],
/// which take fewer bits. An empty path means the same as a lone slash [6.2.3]. The other forms open another address.
std::vector<ShorterForm> shorterForms(std::string_view link);

/// Returns a note if a link's scheme and host in capitals would give a smaller symbol. Cost: milliseconds.
std::optional<Message> adviseCapitals(std::string_view text, const SymbolOptions& options);

}  // namespace qrelief
