// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/message.h"

#include <ostream>
#include <utility>

namespace qrelief {

MessageValue::MessageValue(const char* named, Kind of, std::vector<double> values, std::string_view words)
    : name(named), kind(of), numbers(std::move(values)), text(words) {}
MessageValue::MessageValue(const MessageValue& other) = default;
MessageValue::MessageValue(MessageValue&& other) noexcept = default;
MessageValue& MessageValue::operator=(const MessageValue& other) = default;
MessageValue& MessageValue::operator=(MessageValue&& other) noexcept = default;
MessageValue::~MessageValue() = default;
bool MessageValue::operator==(const MessageValue& other) const = default;

Message::Message() = default;
Message::Message(std::string_view named, std::initializer_list<MessageValue> holding) : code(named), values(holding) {}
Message::Message(const Message& other) = default;
Message::Message(Message&& other) noexcept = default;
Message& Message::operator=(const Message& other) = default;
Message& Message::operator=(Message&& other) noexcept = default;
Message::~Message() = default;
bool Message::operator==(const Message& other) const = default;

namespace with {
namespace {

using Kind = MessageValue::Kind;

MessageValue textual(const char* name, Kind kind, std::string_view text) { return {name, kind, {}, text}; }

}  // namespace

MessageValue numeric(const char* name, Kind kind, double a) { return {name, kind, {a}, {}}; }
MessageValue numeric(const char* name, Kind kind, double x, double y, double z) { return {name, kind, {x, y, z}, {}}; }
MessageValue number(const char* name, double value) { return numeric(name, Kind::Number, value); }
MessageValue lengthMm(const char* name, double mm) { return numeric(name, Kind::LengthMm, mm); }
MessageValue angleDeg(const char* name, double deg) { return numeric(name, Kind::AngleDeg, deg); }
MessageValue fraction(const char* name, double part) { return numeric(name, Kind::Fraction, part); }
MessageValue quoted(const char* name, std::string_view text) { return textual(name, Kind::Quoted, text); }
MessageValue term(const char* name, std::string_view text) { return textual(name, Kind::Term, text); }
MessageValue setting(const char* name, std::string_view key) { return textual(name, Kind::Setting, key); }

MessageValue choice(const char* name, std::string_view key, std::string_view value) {
  MessageValue made = textual(name, Kind::Choice, value);
  made.key = key;
  return made;
}

MessageValue indices(const char* name, std::vector<double> list) { return {name, Kind::Indices, std::move(list), {}}; }

MessageValue cause(const char* name, Message message) {
  MessageValue made{name, Kind::Cause, {}, {}};
  made.cause.push_back(std::move(message));
  return made;
}

}  // namespace with

std::ostream& operator<<(std::ostream& stream, const Message& message) {
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
