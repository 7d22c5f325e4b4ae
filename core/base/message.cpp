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
Message::Message(std::string_view named, std::initializer_list<const MessageValue*> holding) : code(named) {
  values.reserve(holding.size());
  for (const MessageValue* value : holding) values.push_back(*value);
}
Message::Message(const Message& other) = default;
Message::Message(Message&& other) noexcept = default;
Message& Message::operator=(const Message& other) = default;
Message& Message::operator=(Message&& other) noexcept = default;
Message::~Message() = default;
bool Message::operator==(const Message& other) const = default;

namespace with {

using Kind = MessageValue::Kind;

MessageValue numeric(const char* name, Kind kind, double a) { return {name, kind, {a}, {}}; }
MessageValue numeric(const char* name, Kind kind, double x, double y, double z) { return {name, kind, {x, y, z}, {}}; }
MessageValue textual(const char* name, Kind kind, std::string_view text) { return {name, kind, {}, text}; }

MessageValue chosen(const char* name, std::string_view key, std::string_view value) {
  MessageValue choice = textual(name, Kind::Choice, value);
  choice.key = key;
  return choice;
}

MessageValue listed(const char* name, std::vector<double> list) { return {name, Kind::Indices, std::move(list), {}}; }

MessageValue caused(const char* name, Message message) {
  MessageValue value{name, Kind::Cause, {}, {}};
  value.cause.push_back(std::move(message));
  return value;
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
