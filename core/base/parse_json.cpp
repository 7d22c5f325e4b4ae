// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/parse_json.h"

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "message_codes/files.h"

namespace qrelief {
namespace {

using Json = nlohmann::ordered_json;

/// Builds a value from the events of nlohmann's parser, which does not recurse. Stops at the first fault.
class Builder : public nlohmann::json_sax<Json> {
 public:
  explicit Builder(JsonNumbers numbers) : numbers_(numbers) {}

  Json take() { return std::move(root_); }
  Message takeProblem() { return std::move(problem_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return addNumber(value, std::to_string(value)); }
  bool number_unsigned(number_unsigned_t value) override { return addNumber(value, std::to_string(value)); }
  bool number_float(number_float_t value, const string_t& text) override { return addNumber(value, text); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t& value) override { return add(Json(std::move(value))); }

  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    if (!open_.back().keys.insert(name).second) {
      problem_ = message<"json-key-twice">(with::quoted<"key">(name));
      return false;
    }
    key_ = std::move(name);
    return true;
  }

  bool parse_error(std::size_t byte, const std::string& token, const nlohmann::detail::exception& error) override {
    constexpr int kNumberTooLarge = 406;  // of nlohmann's exceptions
    problem_ = error.id == kNumberTooLarge ? message<"json-number-too-large">(with::quoted<"number">(token))
                                           : message<"json-malformed">(with::index<"byte">(byte));
    return false;
  }

 private:
  /// An open array or object. Its parent does not grow before it is closed, so pointers to it stay valid.
  struct Open {
    Json* value;
    std::set<std::string> keys;
  };

  Json& place(Json value) {
    if (open_.empty()) return root_ = std::move(value);
    Json& parent = *open_.back().value;
    if (parent.is_array()) return parent.get_ref<Json::array_t&>().emplace_back(std::move(value));
    // Avoids operator[], which searches all keys.
    return parent.get_ref<Json::object_t&>().emplace_back(std::move(key_), std::move(value)).second;
  }

  bool add(Json value) {
    place(std::move(value));
    return true;
  }

  bool addNumber(Json value, const std::string& text) {
    if (numbers_ == JsonNumbers::Values) return add(std::move(value));
    return add(Json(Json::binary_t({text.begin(), text.end()})));
  }

  bool open(Json value) {
    if (open_.size() == kMaxJsonDepth) {
      problem_ = message<"json-too-deep">(with::count<"limit">(kMaxJsonDepth));
      return false;
    }
    open_.push_back({&place(std::move(value)), {}});
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  JsonNumbers numbers_;
  Json root_;
  std::vector<Open> open_;
  std::string key_;
  Message problem_;
};

}  // namespace

Result<Json> parseJson(std::string_view text, JsonNumbers numbers) {
  Builder builder(numbers);
  if (!Json::sax_parse(text.begin(), text.end(), &builder)) return badInput(builder.takeProblem());
  return builder.take();
}

std::string numberText(const Json& number) {
  const Json::binary_t& text = number.get_binary();
  return {text.begin(), text.end()};
}

}  // namespace qrelief
