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

/// A named, typed value of a message. Whoever shows the message chooses digits, unit and language.
struct MessageValue {
  enum class Kind : std::uint8_t {
    Count,     ///< an integer: a count or an index
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
    Indices,   ///< a list of integers
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
/// holds the sentences by code, in every language; tests/project/messages_test.cpp checks that every message in the
/// sources has them.
struct Message {
  std::string code;  ///< stable, such as "stl-cut-off"
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

/// Makes a message. Nothing else makes one, so a test finds them all in the sources: `message("stl-cut-off",
/// with::count("bytes", 83))`.
/// @param code  a string literal
template <class... Values>
Message message(const char* code, const Values&... values) {
  return {code, {values...}};
}

/// Functions that make values. The name is a string literal that occurs in the sentence or in its hint.
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
/// @param p  has members x, y and z
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

/// Writes a message for tests and debuggers, not for users: `stl-cut-off announced=12 bytes=83`.
std::ostream& operator<<(std::ostream& stream, const Message& message);

}  // namespace qrelief
