// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the words in messages/. The compiler checks that each message in C++ has words for exactly its values
// (base/message.h), and `npm run lint` does the same for JavaScript (script/message_rule.js).
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <span>
#include <string>
#include <utility>
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

/// Words of messages that only the command makes, in English only.
constexpr const char* kCommandWords = "command.json";

std::string contentsOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Returns the files of messages/ by name.
std::map<std::string, Json> catalogues() {
  std::map<std::string, Json> files;
  for (const auto& entry : fs::directory_iterator(sourceFolder() / "messages"))
    if (entry.path().extension() == ".json")
      files[entry.path().filename().string()] = Json::parse(contentsOf(entry.path()));
  return files;
}

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
Names valuesOf(const Json& entry, const std::string& language) {
  Names names = placeholders(entry.at(language));
  if (entry.contains("hint")) names.merge(placeholders(entry.at("hint").at(language)));
  return names;
}

std::vector<std::string> complaintsAbout(const std::string& code, const Json& entry, bool isOnPage) {
  if (!entry.contains("en")) return {code + " has no English"};
  if (!isOnPage) return {};
  if (!entry.contains("de")) return {code + " has no German"};
  if (entry.contains("hint") && !entry.at("hint").contains("de")) return {code + " has no German hint"};
  std::vector<std::string> complaints;
  const Names english = valuesOf(entry, "en");
  if (valuesOf(entry, "de") != english) complaints.push_back(code + " has other values in German");
  if (entry.contains("command")) {
    const Names used = placeholders(entry.at("command"));
    if (!std::includes(english.begin(), english.end(), used.begin(), used.end()))
      complaints.push_back(code + " has other values on the command line");
  }
  return complaints;
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

TEST(Messages, HaveTheSameValuesInEveryLanguage) {
  std::vector<std::string> complaints;
  for (const auto& [file, entries] : catalogues())
    for (const auto& [code, entry] : entries.items()) {
      const auto found = complaintsAbout(code, entry, file != kCommandWords);
      complaints.insert(complaints.end(), found.begin(), found.end());
    }
  EXPECT_THAT(complaints, IsEmpty());
}

// The build generates what the compiler knows of messages/ (script/cmake/embed_message_codes.cmake).
TEST(Messages, AreKnownToTheCompilerWithTheValuesOfSentenceAndHint) {
  const Json files = catalogues().at("files.json");
  const auto known = [](std::span<const std::string_view> names) { return Names(names.begin(), names.end()); };
  EXPECT_EQ(known(ValuesOfMessage<"file-empty">::kNames), valuesOf(files.at("file-empty"), "en"));
  EXPECT_EQ(known(ValuesOfMessage<"file-no-face">::kNames), valuesOf(files.at("file-no-face"), "en"));
  EXPECT_EQ(known(ValuesOfMessage<"stl-cut-off">::kNames), valuesOf(files.at("stl-cut-off"), "en"));
  EXPECT_EQ(known(ValuesOfMessage<"3mf-slices">::kNames), valuesOf(files.at("3mf-slices"), "en"));
}

TEST(Messages, AreAllUsed) {
  Names used = codesMadeIn(kOfPage);
  used.merge(codesMadeIn(kOfCommand));
  std::vector<std::string> unused;
  for (const auto& [file, entries] : catalogues())
    for (const auto& [code, entry] : entries.items())
      if (!used.contains(code)) unused.push_back(code);
  EXPECT_THAT(unused, IsEmpty());
}

TEST(Messages, OfThePageAreNotAmongTheCommandsWords) {
  const Names onPage = codesMadeIn(kOfPage);
  const Json commandWords = catalogues().at(kCommandWords);
  for (const auto& [code, entry] : commandWords.items())
    EXPECT_FALSE(onPage.contains(code)) << code << " needs German, so it belongs in another file";
}

TEST(Messages, AreReportedIfTheirWordsDoNotFit) {
  const auto about = [](const std::string& entry, bool isOnPage = true) {
    return complaintsAbout("x", Json::parse(entry), isOnPage);
  };
  EXPECT_THAT(about(R"({"en": "{a}", "de": "{a}", "hint": {"en": "Do", "de": "Tun"}})"), IsEmpty());
  EXPECT_THAT(about(R"({"en": {"one": "a hole", "other": "{count} holes"}, "de": "{count} mal"})"), IsEmpty());
  EXPECT_THAT(about(R"({"en": "A"})", false), IsEmpty());
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {R"({"de": "A"})", "x has no English"},
      {R"({"en": "A"})", "x has no German"},
      {R"({"en": "A", "de": "A", "hint": {"en": "Do"}})", "x has no German hint"},
      {R"({"en": "{a}", "de": "{b}"})", "x has other values in German"},
      {R"({"en": "{a}", "de": "{a}", "command": "{b}"})", "x has other values on the command line"}};
  for (const auto& [entry, complaint] : wrong) EXPECT_THAT(about(entry), testing::ElementsAre(complaint));
}

}  // namespace
}  // namespace qrelief
