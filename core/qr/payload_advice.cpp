// SPDX-License-Identifier: GPL-3.0-or-later
#include "qr/payload_advice.h"

#include <algorithm>

#include "base/unicode.h"
#include "message_codes/text.h"

namespace qrelief {
namespace {

constexpr std::string_view kWifi = "WIFI:", kContact = "BEGIN:VCARD", kContactEnd = "END:VCARD";
constexpr std::size_t kLongestKey = 3;  // "PH2", the second phase of an enterprise network

bool begins(std::string_view text, std::string_view word) {
  return caseFolded(text.substr(0, word.size())) == caseFolded(word);
}

/// Returns the length of the first part of a Wi-Fi text, with the semicolon that ends it; 0: none does.
std::size_t partLength(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\\')
      ++i;
    else if (text[i] == ';')
      return i + 1;
  return 0;
}

/// Returns true for a part with a key, such as "S:name;".
bool hasKey(std::string_view part) {
  const std::string_view key = part.substr(0, part.find(':'));
  const auto isOfKey = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); };
  return key.size() < part.size() && !key.empty() && key.size() <= kLongestKey &&
         std::all_of(key.begin(), key.end(), isOfKey);
}

std::optional<Message> adviseWifi(std::string_view text) {
  if (!text.starts_with(kWifi)) return message<"wifi-small-letters">();
  text.remove_prefix(kWifi.size());
  bool isNamed = false;
  for (std::size_t number = 1; !text.empty() && text != ";"; ++number) {
    const std::size_t length = partLength(text);
    if (length == 0) return message<"wifi-part-without-end">(with::count<"part">(number));
    const std::string_view part = text.substr(0, length);
    if (!hasKey(part)) return message<"wifi-part-without-key">(with::count<"part">(number));
    isNamed |= part.starts_with("S:") && part.size() > 3;
    text.remove_prefix(length);
  }
  return isNamed ? std::nullopt : std::optional<Message>(message<"wifi-without-name">());
}

std::optional<Message> adviseContact(std::string_view text) {
  text = text.substr(0, text.find_last_not_of(" \t\r\n") + 1);
  const std::string_view last = text.substr(text.find_last_of("\r\n") + 1);
  if (last.size() == kContactEnd.size() && begins(last, kContactEnd)) return std::nullopt;
  return message<"contact-without-end">();
}

}  // namespace

std::optional<Message> advisePayload(std::string_view text) {
  if (begins(text, kWifi)) return adviseWifi(text);
  if (begins(text, kContact)) return adviseContact(text);
  return std::nullopt;
}

}  // namespace qrelief
