// SPDX-License-Identifier: GPL-3.0-or-later
#include "qr/link_advice.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "base/unicode.h"
#include "message_codes/text.h"
#include "qr/payload_advice.h"

namespace qrelief {
namespace {

constexpr std::size_t kLongLink = 60;  // characters; longer links need version 5 or more

std::string utf8Of(std::u32string_view characters) {
  std::string text;
  for (const char32_t c : characters) appendUtf8(text, c);
  return text;
}

bool isQuote(char32_t c) {
  return c == U'"' || c == U'\'' || c == U'`' || c == U'<' || c == U'>' || c == U'\u00AB' || c == U'\u00BB' ||
         (c >= U'\u2018' && c <= U'\u201F') || c == U'\u2039' || c == U'\u203A';
}

bool isDigit(char32_t c) { return c >= U'0' && c <= U'9'; }
bool isAsciiLetter(char32_t c) { return (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z'); }

/// Returns true for letters; beyond Latin, Greek and Cyrillic roughly: for all that is no sign or picture.
bool isLetter(char32_t c) {
  if (c < 0x80) return isAsciiLetter(c);
  const bool isSign = c < 0xC0 || c == 0xD7 || c == 0xF7 || (c >= 0x2000 && c < 0x2C00) ||
                      (c >= 0x3000 && c < 0x3040) || (c >= 0xFE00 && c < 0xFE70) || (c >= 0xFF00 && c < 0xFF10) ||
                      (c >= 0x1F000 && c < 0x20000);
  return !isSign;
}

template <class Is>
std::u32string_view trimmed(std::u32string_view text, Is is) {
  while (!text.empty() && is(text.front())) text.remove_prefix(1);
  while (!text.empty() && is(text.back())) text.remove_suffix(1);
  return text;
}

/// Returns the text within a pair of brackets that enclose all of it. A single bracket may be part of a link.
std::u32string_view withinBrackets(std::u32string_view text) {
  constexpr std::u32string_view kPairs = U"()[]{}\uFF08\uFF09\u3010\u3011\u300C\u300D";
  for (std::size_t i = 0; i < kPairs.size(); i += 2)
    if (text.size() > 2 && text.front() == kPairs[i] && text.back() == kPairs[i + 1])
      return text.substr(1, text.size() - 2);
  return text;
}

/// A link in its parts. `rest` begins with its slash, question mark or number sign.
struct WebAddress {
  std::string_view scheme;  ///< with "://"
  std::string_view host;    ///< with user and port
  std::string_view rest;
};

std::optional<WebAddress> splitWebAddress(std::string_view text) {
  for (const std::string_view scheme : {"https://", "http://"}) {
    if (caseFolded(text.substr(0, scheme.size())) != scheme) continue;
    const std::size_t end = std::min(text.find_first_of("/?#", scheme.size()), text.size());
    return WebAddress{text.substr(0, scheme.size()), text.substr(scheme.size(), end - scheme.size()), text.substr(end)};
  }
  return std::nullopt;
}

/// Returns true for an address without scheme: host[:port][/path…], labels of letters, digits and hyphens, the last one
/// a possible top-level domain.
bool isBareAddress(std::u32string_view text) {
  if (std::any_of(text.begin(), text.end(), isSpace)) return false;
  const std::u32string_view authority = text.substr(0, text.find_first_of(U"/?#"));
  const std::size_t colon = authority.find(U':');
  if (colon != authority.npos) {
    const std::u32string_view port = authority.substr(colon + 1);
    if (port.empty() || port.size() > 5 || !std::all_of(port.begin(), port.end(), isDigit)) return false;
  }
  std::u32string_view host = authority.substr(0, colon), label;
  std::size_t labels = 0;
  while (true) {
    label = host.substr(0, host.find(U'.'));
    const auto isPart = [](char32_t c) { return isLetter(c) || isDigit(c) || c == U'-'; };
    if (label.empty() || !std::all_of(label.begin(), label.end(), isPart)) return false;
    if (label.front() == U'-' || label.back() == U'-') return false;
    ++labels;
    if (label.size() == host.size()) break;
    host.remove_prefix(label.size() + 1);
  }
  const bool isTopLevel = label.size() >= 2 && (std::all_of(label.begin(), label.end(), isLetter) ||
                                                caseFolded(utf8Of(label)).starts_with("xn--"));
  return labels >= 2 && isTopLevel;
}

/// Returns true for what looks like an address but is more often a file name.
bool isFileName(std::string_view text) {
  if (text.find_first_of("/?#") != text.npos) return false;
  constexpr std::array<std::string_view, 21> kEndings = {"stl", "obj",  "ply",  "off",  "3mf",  "txt",  "pdf",
                                                         "png", "jpg",  "jpeg", "svg",  "json", "zip",  "gcode",
                                                         "doc", "docx", "xls",  "xlsx", "htm",  "html", "md"};
  const std::string ending = caseFolded(text.substr(text.rfind('.') + 1));
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

/// Returns the text after a scheme that is misspelt, such as "htps://" or "https:/"; empty if there is none.
std::string_view afterMisspeltScheme(std::string_view text) {
  constexpr std::array<std::string_view, 14> kWords = {"http", "https", "htp", "htps", "htpp",  "htpps",  "httsp",
                                                       "hhtp", "hhtps", "ttp", "ttps", "htttp", "htttps", "httpss"};
  std::size_t letters = 0;
  while (letters < text.size() && isAsciiLetter(static_cast<unsigned char>(text[letters]))) ++letters;
  const std::string word = caseFolded(text.substr(0, letters));
  if (std::find(kWords.begin(), kWords.end(), word) == kWords.end()) return {};
  const std::size_t end = std::min(text.find_first_not_of(":;./\\", letters), text.size());
  const std::string_view between = text.substr(letters, end - letters);
  const bool isSeparator = between.size() >= 2 && between.find_first_of("/\\") != between.npos;
  return isSeparator ? text.substr(end) : std::string_view();
}

/// Returns true if a browser can open the host: a name with a dot, a number in brackets or localhost, and a port.
bool isHost(std::string_view host) {
  if (const std::size_t at = host.rfind('@'); at != host.npos) host.remove_prefix(at + 1);
  const std::size_t colon = host.ends_with(']') ? host.npos : host.rfind(':');
  if (colon != host.npos) {
    const std::string_view port = host.substr(colon + 1);
    const bool isNumber = port.size() <= 5 && std::all_of(port.begin(), port.end(), [](char c) {
                            return isDigit(static_cast<unsigned char>(c));
                          });
    if (!isNumber || (!port.empty() && std::stoi(std::string(port)) > 65535)) return false;
    host = host.substr(0, colon);
  }
  if (host.starts_with('[')) return host.ends_with(']') && host.size() > 3;
  if (host.find_first_of("%<>^`{|}\\\"[]: ") != host.npos) return false;
  return caseFolded(host) == "localhost" || (host.find('.') != host.npos && !host.starts_with('.'));
}

/// Encodes the characters of a label beyond ASCII [RFC 3492].
std::string punycode(std::u32string_view label) {
  constexpr std::uint32_t kBase = 36, kTMin = 1, kTMax = 26, kSkew = 38, kDamp = 700;
  std::string output;
  for (const char32_t c : label)
    if (c < 0x80) output += static_cast<char>(c);
  const auto basic = static_cast<std::uint32_t>(output.size());
  if (basic > 0) output += '-';
  std::uint32_t n = 0x80, delta = 0, bias = 72, handled = basic;
  while (handled < label.size()) {
    char32_t least = 0x110000;
    for (const char32_t c : label)
      if (c >= n) least = std::min(least, c);
    delta += (static_cast<std::uint32_t>(least) - n) * (handled + 1);
    n = static_cast<std::uint32_t>(least);
    for (const char32_t c : label) {
      if (c < n) ++delta;
      if (c != n) continue;
      std::uint32_t q = delta;
      for (std::uint32_t k = kBase;; k += kBase) {
        const std::uint32_t t = k <= bias ? kTMin : k >= bias + kTMax ? kTMax : k - bias;
        const std::uint32_t digit = q < t ? q : t + (q - t) % (kBase - t);
        output += static_cast<char>(digit < 26 ? 'a' + digit : '0' + (digit - 26));
        if (q < t) break;
        q = (q - t) / (kBase - t);
      }
      delta = handled == basic ? delta / kDamp : delta / 2;
      delta += delta / (handled + 1);
      std::uint32_t k = 0;
      for (; delta > (kBase - kTMin) * kTMax / 2; k += kBase) delta /= kBase - kTMin;
      bias = k + (kBase - kTMin + 1) * delta / (delta + kSkew);
      delta = 0;
      ++handled;
    }
    ++delta;
    ++n;
  }
  return output;
}

/// Returns the host in ASCII, as browsers write it: each label in its own letters becomes xn--….
std::string asciiHost(std::string_view host) {
  std::string ascii;
  const std::u32string characters = charactersOf(caseFolded(host));
  for (std::size_t begin = 0; begin <= characters.size();) {
    const std::size_t end = std::min(characters.find(U'.', begin), characters.size());
    const std::u32string_view label = std::u32string_view(characters).substr(begin, end - begin);
    const bool isAscii = std::all_of(label.begin(), label.end(), [](char32_t c) { return c < 0x80; });
    ascii += isAscii ? utf8Of(label) : "xn--" + punycode(label);
    if (end < characters.size()) ascii += '.';
    begin = end + 1;
  }
  return ascii;
}

/// Returns true for parameters that only tell the site where a visitor came from; the page is the same without them.
bool isTracking(std::string_view name) {
  constexpr std::array<std::string_view, 24> kNames = {
      "fbclid",  "gclid",     "gclsrc", "dclid",  "gbraid", "wbraid",  "msclkid",     "twclid",
      "ttclid",  "li_fat_id", "yclid",  "igshid", "igsh",   "mc_cid",  "mc_eid",      "mkt_tok",
      "srsltid", "_hsenc",    "_hsmi",  "_ga",    "_gl",    "vero_id", "oly_anon_id", "oly_enc_id"};
  const std::string low = caseFolded(name);
  return (low.starts_with("utm_") && low.size() > 4) || std::find(kNames.begin(), kNames.end(), low) != kNames.end();
}

std::string withoutTracking(std::string_view link) {
  const std::size_t jump = std::min(link.find('#'), link.size());
  const std::size_t query = link.substr(0, jump).find('?');
  if (query == link.npos) return std::string(link);
  std::string kept;
  std::string_view left = link.substr(query + 1, jump - query - 1);
  while (true) {
    const std::string_view parameter = left.substr(0, left.find('&'));
    if (!isTracking(parameter.substr(0, parameter.find('=')))) kept.append(kept.empty() ? "" : "&").append(parameter);
    if (parameter.size() == left.size()) break;
    left.remove_prefix(parameter.size() + 1);
  }
  std::string clean(link.substr(0, query));
  if (!kept.empty()) clean += "?" + kept;
  return clean.append(link.substr(jump));
}

bool isAscii(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

/// Advises on a link without anything around it.
std::vector<TextAdvice> adviseLink(const std::string& link) {
  using Severity = TextAdvice::Severity;
  const std::u32string characters = charactersOf(link);
  if (std::any_of(characters.begin(), characters.end(), isSpace)) {
    std::string fixed;
    for (std::size_t i = 0; i < characters.size(); ++i) {
      if (!isSpace(characters[i]))
        appendUtf8(fixed, characters[i]);
      else if (i == 0 || !isSpace(characters[i - 1]))
        fixed += "%20";
    }
    return {{Severity::Warning, message<"link-spaces">(with::quoted<"fixed">(fixed)), fixed}};
  }
  const auto parts = splitWebAddress(link);
  if (!parts || !isHost(parts->host)) return {{Severity::Warning, message<"link-incomplete">(), {}}};
  constexpr std::string_view kPunctuation = ".,;!";
  if (const std::size_t end = link.find_last_not_of(kPunctuation) + 1; end < link.size()) {
    const std::string fixed = link.substr(0, end);
    return {{Severity::Warning, message<"link-punctuation">(with::quoted<"fixed">(fixed)), fixed}};
  }
  std::vector<TextAdvice> advice;
  if (!isAscii(parts->host)) {
    const std::size_t colon = parts->host.rfind(':');
    const std::string ascii = asciiHost(parts->host.substr(0, colon));
    const std::string port(colon == parts->host.npos ? std::string_view() : parts->host.substr(colon));
    const std::string fixed = std::string(parts->scheme) + ascii + port + std::string(parts->rest);
    advice.push_back({Severity::Note, message<"link-other-letters">(with::term<"host">(ascii)), fixed});
  }
  if (const std::string clean = withoutTracking(link); clean != link)
    advice.push_back({characters.size() > kLongLink ? Severity::Warning : Severity::Note,
                      message<"link-tracking">(with::count<"count">(characters.size() - charactersOf(clean).size()),
                                               with::quoted<"fixed">(clean)),
                      clean});
  return advice;
}

/// Returns the link with a scheme.
std::string withScheme(const std::string& address) { return splitWebAddress(address) ? address : "https://" + address; }

}  // namespace

std::vector<TextAdvice> adviseText(std::string_view text) {
  using Severity = TextAdvice::Severity;
  if (auto fault = advisePayload(text)) return {{Severity::Warning, std::move(*fault), {}}};
  const std::u32string whole = charactersOf(text);
  std::u32string seen = whole;
  seen.erase(std::remove_if(seen.begin(), seen.end(), isUnseen), seen.end());
  const std::u32string_view within = trimmed(std::u32string_view(seen), isSpace);
  std::u32string_view core = trimmed(withinBrackets(trimmed(within, isQuote)), isSpace);
  // A quotation that ends with the link belongs to it, like brackets.
  if (std::any_of(core.begin(), core.end(), isQuote)) core = within;
  const std::string bare = utf8Of(core);
  const bool hasScheme = splitWebAddress(bare).has_value();
  if (!hasScheme) {
    const std::string_view after = afterMisspeltScheme(bare);
    if (!after.empty() && isBareAddress(charactersOf(after))) {
      const std::string fixed = "https://" + std::string(after);
      return {{Severity::Warning, message<"link-scheme-misspelt">(with::quoted<"fixed">(fixed)), fixed}};
    }
    if (!isBareAddress(core) || isFileName(bare)) return {};
  }
  const std::string fixed = withScheme(bare);
  const auto warning = [&](Message message) {
    return std::vector<TextAdvice>{{Severity::Warning, std::move(message), fixed}};
  };
  if (seen.size() != whole.size()) return warning(message<"link-unseen">(with::quoted<"fixed">(fixed)));
  if (core.size() != within.size()) return warning(message<"link-quoted">(with::quoted<"fixed">(fixed)));
  if (!hasScheme) return warning(message<"link-without-scheme">(with::quoted<"fixed">(fixed)));
  if (within.size() != whole.size()) return warning(message<"link-ends">(with::quoted<"fixed">(fixed)));
  return adviseLink(bare);
}

const char* shorterFormName(ShorterForm::Kind kind) {
  constexpr std::array<const char*, 3> kNames = {"capitals", "www", "highlight"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::vector<ShorterForm> shorterForms(std::string_view link) {
  using Kind = ShorterForm::Kind;
  const auto parts = splitWebAddress(link);
  const std::u32string characters = charactersOf(link);
  if (!parts || std::any_of(characters.begin(), characters.end(), isSpace) || !isAscii(parts->host) ||
      parts->host.find('@') != parts->host.npos)
    return {};
  const auto inCapitals = [&](std::string_view host) {
    std::string text = std::string(parts->scheme) + std::string(host);
    for (char& c : text)
      if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return parts->rest == "/" ? text : text.append(parts->rest);
  };
  std::vector<ShorterForm> forms = {{Kind::Capitals, inCapitals(parts->host)}};
  constexpr std::string_view kWww = "www.";
  if (caseFolded(parts->host).starts_with(kWww) && parts->host.find('.', kWww.size() + 1) != parts->host.npos)
    forms.push_back({Kind::WithoutWww, inCapitals(parts->host.substr(kWww.size()))});
  if (const std::size_t jump = parts->rest.find("#:~:text="); jump != parts->rest.npos)
    forms.push_back({Kind::WithoutHighlight, std::string(link.substr(0, link.size() - parts->rest.size() + jump))});
  forms.erase(std::remove_if(forms.begin(), forms.end(), [&](const ShorterForm& form) { return form.text == link; }),
              forms.end());
  return forms;
}

std::optional<Message> adviseCapitals(std::string_view text, const SymbolOptions& options) {
  const std::vector<ShorterForm> forms = shorterForms(text);
  if (options.version || forms.empty() || forms.front().kind != ShorterForm::Kind::Capitals) return std::nullopt;
  VersionsByLength versions(options.errorCorrection, options.eci);
  const int version = versions.smallest(text), smaller = versions.smallest(forms.front().text);
  if (smaller == 0 || smaller >= version) return std::nullopt;
  return message<"link-in-capitals">(with::count<"smaller">(smaller), with::index<"version">(version),
                                     with::quoted<"fixed">(forms.front().text));
}

}  // namespace qrelief
