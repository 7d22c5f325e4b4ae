// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the messages in locales/. The compiler checks that each message in C++ has words for exactly its values
// (base/message.h), and `npm run lint` does the same for JavaScript (script/message_rule.js).
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "base/message.h"
#include "message_codes/files.h"
#include "support/paths.h"

namespace qrelief {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Names = std::set<std::string>;
using testing::IsEmpty;

/// Folders whose messages the page shows; the others belong to the command.
const std::vector<std::string> kOfPage = {"core", "app", "wasm", "web"};
const std::vector<std::string> kOfCommand = {"native", "study"};

/// The part of the messages that only the command makes, in English only.
constexpr const char* kCommandPart = "command";

std::string contentsOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Returns the English messages by part and code.
Json english() { return Json::parse(contentsOf(sourceFolder() / "locales/en.json")).at("messages"); }

/// Returns the names of the values in a text, or in its two forms, of which `count` chooses one.
Names placeholders(const Json& forms) {
  static const std::regex kValue(R"(\{(\w+)\})");
  if (forms.is_object()) {
    Names names = {"count"};
    for (const auto& form : forms) names.merge(placeholders(form));
    return names;
  }
  Names names;
  const std::string text = forms.get<std::string>();
  for (std::sregex_iterator at(text.begin(), text.end(), kValue), end; at != end; ++at) names.insert((*at)[1]);
  return names;
}

/// Returns the names of the values in the sentence and the hint of an entry.
Names valuesOf(const Json& entry) {
  Names names = placeholders(entry.at("says"));
  if (entry.contains("hint")) names.merge(placeholders(entry.at("hint")));
  return names;
}

/// Tells whether the command's own words, if an entry has any, have only the values of the others.
bool fitsTheCommand(const Json& entry) {
  const Names names = valuesOf(entry);
  for (const Json& words : entry.value("command", Json::object())) {
    const Names used = placeholders(words);
    if (!std::includes(names.begin(), names.end(), used.begin(), used.end())) return false;
  }
  return true;
}

/// Returns the codes of all messages made in the sources of some folders, and of the stages of jobs
/// (base/job_stages.h). A search for text suffices, because the compiler and the linter let no unknown code pass.
Names codesMadeIn(const std::vector<std::string>& folders) {
  static const std::regex kMaker(
      R"re((?:\bmessage(?:<|\(\s*)["']([a-z0-9-]+)["']|\{"([a-z0-9-]+)",[^{}"]*&State::))re");
  Names codes;
  for (const std::string& folder : folders)
    for (const auto& entry : fs::recursive_directory_iterator(sourceFolder() / folder)) {
      const std::string name = entry.path().filename().string(), extension = entry.path().extension().string();
      if ((extension != ".h" && extension != ".cpp" && extension != ".js") || name.find("test") != std::string::npos)
        continue;
      const std::string source = contentsOf(entry.path());
      for (std::sregex_iterator at(source.begin(), source.end(), kMaker), end; at != end; ++at)
        codes.insert((*at)[(*at)[1].matched ? 1 : 2]);
    }
  return codes;
}

// web/i18n/locales.test.js compares the languages.
TEST(Messages, HaveNoOtherValuesOnTheCommandLine) {
  const Json all = english();
  for (const auto& [part, entries] : all.items())
    for (const auto& [code, entry] : entries.items()) EXPECT_TRUE(fitsTheCommand(entry)) << code;
  EXPECT_FALSE(fitsTheCommand(Json::parse(R"({"says": "{a}", "command": {"says": "{b}"}})")));
  EXPECT_TRUE(fitsTheCommand(Json::parse(R"({"says": "{a}", "hint": "{b}", "command": {"says": "{b}"}})")));
}

TEST(Messages, HaveFormsForTheNounOfTheirCount) {
  static const std::regex kCounted(R"(\{count\} [a-z]+s\b)");
  // Such a count is never one.
  const Names many = {
      "list-cell-too-long",       "name-too-long",        "3mf-several-starts",      "zip-several-models",
      "storage-too-small",        "model-no-thickness",   "crossing-pairs-at-least", "overlapping-pairs-at-least",
      "many-inherited-crossings", "one-light-has-several"};
  std::vector<std::string> without;
  const Json all = english();
  for (const auto& [part, entries] : all.items())
    for (const auto& [code, entry] : entries.items())
      if (entry.at("says").is_string() && !many.contains(code) &&
          std::regex_search(entry.at("says").get<std::string>(), kCounted))
        without.push_back(code);
  EXPECT_THAT(without, IsEmpty());
}

// The build generates what the compiler knows of the messages (script/cmake/embed_message_codes.cmake).
TEST(Messages, AreKnownToTheCompilerWithTheValuesOfSentenceAndHint) {
  const Json files = english().at("files");
  const auto known = [](std::span<const std::string_view> names) { return Names(names.begin(), names.end()); };
  EXPECT_EQ(known(ValuesOfMessage<"file-empty">::kNames), valuesOf(files.at("file-empty")));
  EXPECT_EQ(known(ValuesOfMessage<"file-no-face">::kNames), valuesOf(files.at("file-no-face")));
  EXPECT_EQ(known(ValuesOfMessage<"stl-cut-off">::kNames), valuesOf(files.at("stl-cut-off")));
  EXPECT_EQ(known(ValuesOfMessage<"3mf-slices">::kNames), valuesOf(files.at("3mf-slices")));
}

TEST(Messages, AreAllUsed) {
  Names used = codesMadeIn(kOfPage);
  used.merge(codesMadeIn(kOfCommand));
  std::vector<std::string> unused;
  const Json all = english();
  for (const auto& [part, entries] : all.items())
    for (const auto& [code, entry] : entries.items())
      if (!used.contains(code)) unused.push_back(code);
  EXPECT_THAT(unused, IsEmpty());
}

TEST(Messages, OfThePageAreNotAmongTheCommands) {
  const Names onPage = codesMadeIn(kOfPage);
  const Json ofCommand = english().at(kCommandPart);
  for (const auto& [code, entry] : ofCommand.items())
    EXPECT_FALSE(onPage.contains(code)) << code << " is on the page, so it belongs in another part";
}

}  // namespace
}  // namespace qrelief
