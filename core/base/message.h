// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace qrelief {

struct Message;

/// A named, typed value of a message. How it is written (digits, unit, language) is decided where it is told.
struct MessageValue {
  enum class Kind : std::uint8_t {
    Count,     ///< an integer: how many, or which one
    Number,    ///< without a unit
    LengthMm,  ///< mm
    AngleDeg,  ///< degrees
    Fraction,  ///< 0 … 1, told as per cent
    Place,     ///< a point, in the coordinates of the user's file
    ExtentMm,  ///< of a box along x, y and z, mm
    Quoted,    ///< text of the user's: of a file, or typed
    Term,      ///< a name that no language translates: of a format, an element, a unit
    Setting,   ///< key of a setting (settings/settings.h)
    Choice,    ///< value of a setting of choices, with its key
    Indices,   ///< a list of integers
    Cause      ///< a message, told within this one
  };
  std::string name;
  Kind kind = Kind::Count;
  std::vector<double> numbers;  ///< one; three of a place or an extent; any of Indices
  std::string text;             ///< of Quoted, Term and Setting; the choice's value
  std::string key;              ///< of Choice: the setting
  std::vector<Message> cause;   ///< one, of Cause

  bool operator==(const MessageValue&) const;
};

/// What is to be told to a person, without words: which sentence, and the values in it. The words stand in messages/,
/// by code, in every language; tests/project/messages_test.cpp holds that each message of the sources has them.
struct Message {
  std::string code;  ///< stable, "stl-cut-off"
  std::vector<MessageValue> values;

  bool operator==(const Message&) const;
};

inline bool MessageValue::operator==(const MessageValue&) const = default;
inline bool Message::operator==(const Message&) const = default;

/// The only maker of messages, so that a test finds them all in the sources: `message("stl-cut-off",
/// with::count("bytes", 83))`.
/// @param code  a string literal
template <class... Values>
Message message(const char* code, Values&&... values) {
  Message made{code, {}};
  (made.values.push_back(std::forward<Values>(values)), ...);
  return made;
}

/// Makers of the values; the name is a string literal that stands in the sentence or in its hint.
namespace with {

inline MessageValue numeric(const char* name, MessageValue::Kind kind, std::vector<double> numbers) {
  return {name, kind, std::move(numbers), {}, {}, {}};
}
inline MessageValue textual(const char* name, MessageValue::Kind kind, std::string_view text) {
  return {name, kind, {}, std::string(text), {}, {}};
}

template <class Integer>
MessageValue count(const char* name, Integer n) {
  return numeric(name, MessageValue::Kind::Count, {static_cast<double>(n)});
}
inline MessageValue number(const char* name, double value) {
  return numeric(name, MessageValue::Kind::Number, {value});
}
inline MessageValue lengthMm(const char* name, double mm) { return numeric(name, MessageValue::Kind::LengthMm, {mm}); }
inline MessageValue angleDeg(const char* name, double deg) {
  return numeric(name, MessageValue::Kind::AngleDeg, {deg});
}
inline MessageValue fraction(const char* name, double part) {
  return numeric(name, MessageValue::Kind::Fraction, {part});
}
/// @param p  has x, y and z, as do extents
template <class Vector>
MessageValue place(const char* name, const Vector& p) {
  return numeric(name, MessageValue::Kind::Place, {p.x, p.y, p.z});
}
template <class Vector>
MessageValue extentMm(const char* name, const Vector& mm) {
  return numeric(name, MessageValue::Kind::ExtentMm, {mm.x, mm.y, mm.z});
}
inline MessageValue quoted(const char* name, std::string_view text) {
  return textual(name, MessageValue::Kind::Quoted, text);
}
inline MessageValue term(const char* name, std::string_view text) {
  return textual(name, MessageValue::Kind::Term, text);
}
inline MessageValue setting(const char* name, std::string_view key) {
  return textual(name, MessageValue::Kind::Setting, key);
}
inline MessageValue choice(const char* name, std::string_view key, std::string_view value) {
  MessageValue made = textual(name, MessageValue::Kind::Choice, value);
  made.key = key;
  return made;
}
inline MessageValue indices(const char* name, std::vector<double> list) {
  return numeric(name, MessageValue::Kind::Indices, std::move(list));
}
inline MessageValue cause(const char* name, Message message) {
  return {name, MessageValue::Kind::Cause, {}, {}, {}, {std::move(message)}};
}

}  // namespace with

/// For tests and debuggers, not for users: `stl-cut-off announced=12 bytes=83`.
inline std::ostream& operator<<(std::ostream& stream, const Message& message) {
  stream << message.code;
  for (const MessageValue& value : message.values) {
    stream << ' ' << value.name << '=';
    for (const double number : value.numbers) stream << number << (value.numbers.size() > 1 ? ";" : "");
    stream << value.text;
    for (const Message& cause : value.cause) stream << '(' << cause << ')';
  }
  return stream;
}

}  // namespace qrelief
