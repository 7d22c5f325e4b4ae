// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <initializer_list>
#include <iosfwd>
#include <string>
#include <string_view>
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

  MessageValue(const char* named, Kind of, std::vector<double> values, std::string_view words);
  // These stand in message.cpp, as do those of Message: written out at every call they would make the browser's module
  // larger.
  MessageValue(const MessageValue& other);
  MessageValue(MessageValue&& other) noexcept;
  MessageValue& operator=(const MessageValue& other);
  MessageValue& operator=(MessageValue&& other) noexcept;
  ~MessageValue();
  bool operator==(const MessageValue& other) const;
};

/// What is to be told to a person, without words: which sentence, and the values in it. The words stand in messages/,
/// by code, in every language; tests/project/messages_test.cpp holds that each message of the sources has them.
struct Message {
  std::string code;  ///< stable, "stl-cut-off"
  std::vector<MessageValue> values;

  Message();
  Message(std::string_view named, std::initializer_list<MessageValue> holding);
  Message(const Message& other);
  Message(Message&& other) noexcept;
  Message& operator=(const Message& other);
  Message& operator=(Message&& other) noexcept;
  ~Message();
  bool operator==(const Message& other) const;
};

/// The only maker of messages, so that a test finds them all in the sources: `message("stl-cut-off",
/// with::count("bytes", 83))`.
/// @param code  a string literal
template <class... Values>
Message message(const char* code, const Values&... values) {
  return {code, {values...}};
}

/// Makers of the values; the name is a string literal that stands in the sentence or in its hint.
namespace with {

MessageValue numeric(const char* name, MessageValue::Kind kind, double a);
MessageValue numeric(const char* name, MessageValue::Kind kind, double x, double y, double z);

template <class Integer>
MessageValue count(const char* name, Integer n) {
  return numeric(name, MessageValue::Kind::Count, static_cast<double>(n));
}
MessageValue number(const char* name, double value);
MessageValue lengthMm(const char* name, double mm);
MessageValue angleDeg(const char* name, double deg);
MessageValue fraction(const char* name, double part);
/// @param p  has x, y and z, as do extents
template <class Vector>
MessageValue place(const char* name, const Vector& p) {
  return numeric(name, MessageValue::Kind::Place, p.x, p.y, p.z);
}
template <class Vector>
MessageValue extentMm(const char* name, const Vector& mm) {
  return numeric(name, MessageValue::Kind::ExtentMm, mm.x, mm.y, mm.z);
}
MessageValue quoted(const char* name, std::string_view text);
MessageValue term(const char* name, std::string_view text);
MessageValue setting(const char* name, std::string_view key);
MessageValue choice(const char* name, std::string_view key, std::string_view value);
MessageValue indices(const char* name, std::vector<double> list);
MessageValue cause(const char* name, Message message);

}  // namespace with

/// For tests and debuggers, not for users: `stl-cut-off announced=12 bytes=83`.
std::ostream& operator<<(std::ostream& stream, const Message& message);

}  // namespace qrelief
