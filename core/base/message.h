// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace qrelief {

struct Message;

/// A named, typed value of a message. Whoever shows the message chooses digits, unit and language.
struct MessageValue {
  enum class Kind : std::uint8_t {
    Count,     ///< an integer
    Index,     ///< number of a line, a vertex or a version, or an id: no quantity, so its thousands are never separated
    Number,    ///< a number without a unit
    LengthMm,  ///< mm
    AngleDeg,  ///< degrees
    Fraction,  ///< 0 … 1, shown as per cent
    Place,     ///< a point, in the coordinates of the user's file
    ExtentMm,  ///< size of a box along x, y and z, mm
    Quoted,    ///< the user's own text, from a file or typed
    Term,      ///< an untranslated name: of a format, an element, a unit
    Setting,   ///< key of a setting (settings/settings.h)
    Choice,    ///< a setting's chosen value, with the setting's key
    Indices,   ///< a list of such numbers
    Cause      ///< a message quoted within this one
  };
  std::string name;
  Kind kind = Kind::Count;
  std::vector<double> numbers;  ///< one; Place and ExtentMm: three; Indices: any number
  std::string text;             ///< of Quoted, Term and Setting; of Choice: the value
  std::string key;              ///< of Choice: the setting
  std::vector<Message> cause;   ///< of Cause: one message

  MessageValue(const char* named, Kind of, std::vector<double> values, std::string_view words);
  // Defined in message.cpp, as are Message's: inlined at every call they would make the browser's module larger.
  MessageValue(const MessageValue& other);
  MessageValue(MessageValue&& other) noexcept;
  MessageValue& operator=(const MessageValue& other);
  MessageValue& operator=(MessageValue&& other) noexcept;
  ~MessageValue();
  bool operator==(const MessageValue& other) const;
};

/// A message to a person, without words: a code for its sentence, and the values in the sentence. The folder messages/
/// holds the sentences by code, in every language. message() makes one in the sources, and the compiler checks it; the
/// constructor takes a code that is known only at run time.
struct Message {
  std::string code;  ///< stable, such as "stl-cut-off"
  std::vector<MessageValue> values;

  Message();
  Message(std::string_view named, std::initializer_list<const MessageValue*> holding);
  Message(const Message& other);
  Message(Message&& other) noexcept;
  Message& operator=(const Message& other);
  Message& operator=(Message&& other) noexcept;
  ~Message();
  bool operator==(const Message& other) const;
};

/// Name of a value as a template argument: `with::count<"bytes">(83)`.
template <std::size_t kSize>
struct ValueName {
  char text[kSize] = {};

  consteval ValueName(const char (&name)[kSize]) {
    for (std::size_t i = 0; i < kSize; ++i) text[i] = name[i];
  }
};

/// A value whose name the compiler knows.
template <ValueName kValueName>
struct NamedValue {
  static constexpr std::string_view kName = kValueName.text;
  MessageValue value;
};

/// The names of the values in the words of the message `kCode`, as `kNames`. The build generates a header that defines
/// it for each part of the messages in locales/en.json: message_codes/files.h.
template <ValueName kCode>
struct ValuesOfMessage;

/// Returns true if both lists have the same names, in any order. No name occurs twice in a list.
consteval bool sameNames(std::span<const std::string_view> a, std::span<const std::string_view> b) {
  return a.size() == b.size() && std::all_of(a.begin(), a.end(), [&](std::string_view name) {
           return std::find(b.begin(), b.end(), name) != b.end();
         });
}

/// Makes a message: `message<"stl-cut-off">(with::count<"bytes">(83))`. Only a code in an included catalogue compiles,
/// with exactly the values in its words.
template <ValueName kCode, class... Values>
Message message(const Values&... values) {
  constexpr std::array<std::string_view, sizeof...(Values)> kNames = {Values::kName...};
  static_assert(sameNames(ValuesOfMessage<kCode>::kNames, kNames), "the message's words have other values");
  return {kCode.text, {&values.value...}};
}

/// Functions that make values. The name occurs in the sentence of the message or in its hint.
namespace with {

MessageValue numeric(const char* name, MessageValue::Kind kind, double a);
MessageValue numeric(const char* name, MessageValue::Kind kind, double x, double y, double z);
MessageValue textual(const char* name, MessageValue::Kind kind, std::string_view text);
MessageValue chosen(const char* name, std::string_view key, std::string_view value);
MessageValue listed(const char* name, std::vector<double> list);
MessageValue caused(const char* name, Message message);

template <ValueName kName, class Integer>
NamedValue<kName> count(Integer n) {
  return {numeric(kName.text, MessageValue::Kind::Count, static_cast<double>(n))};
}
template <ValueName kName, class Integer>
NamedValue<kName> index(Integer n) {
  return {numeric(kName.text, MessageValue::Kind::Index, static_cast<double>(n))};
}
template <ValueName kName>
NamedValue<kName> number(double value) {
  return {numeric(kName.text, MessageValue::Kind::Number, value)};
}
template <ValueName kName>
NamedValue<kName> lengthMm(double mm) {
  return {numeric(kName.text, MessageValue::Kind::LengthMm, mm)};
}
template <ValueName kName>
NamedValue<kName> angleDeg(double deg) {
  return {numeric(kName.text, MessageValue::Kind::AngleDeg, deg)};
}
template <ValueName kName>
NamedValue<kName> fraction(double part) {
  return {numeric(kName.text, MessageValue::Kind::Fraction, part)};
}
/// @param p  has members x, y and z
template <ValueName kName, class Vector>
NamedValue<kName> place(const Vector& p) {
  return {numeric(kName.text, MessageValue::Kind::Place, p.x, p.y, p.z)};
}
template <ValueName kName, class Vector>
NamedValue<kName> extentMm(const Vector& mm) {
  return {numeric(kName.text, MessageValue::Kind::ExtentMm, mm.x, mm.y, mm.z)};
}
template <ValueName kName>
NamedValue<kName> quoted(std::string_view text) {
  return {textual(kName.text, MessageValue::Kind::Quoted, text)};
}
template <ValueName kName>
NamedValue<kName> term(std::string_view text) {
  return {textual(kName.text, MessageValue::Kind::Term, text)};
}
template <ValueName kName>
NamedValue<kName> setting(std::string_view key) {
  return {textual(kName.text, MessageValue::Kind::Setting, key)};
}
template <ValueName kName>
NamedValue<kName> choice(std::string_view key, std::string_view value) {
  return {chosen(kName.text, key, value)};
}
template <ValueName kName>
NamedValue<kName> indices(std::vector<double> list) {
  return {listed(kName.text, std::move(list))};
}
template <ValueName kName>
NamedValue<kName> cause(Message message) {
  return {caused(kName.text, std::move(message))};
}

}  // namespace with

/// Writes a message for tests and debuggers, not for users: `stl-cut-off announced=12 bytes=83`.
std::ostream& operator<<(std::ostream& stream, const Message& message);

}  // namespace qrelief
