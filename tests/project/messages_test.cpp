// SPDX-License-Identifier: GPL-3.0-or-later
// Follows messages from the sources to the sentences: every message has words for all its values in each language.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace qrelief {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Names = std::set<std::string>;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

/// Place in the sources that makes a message.
struct Made {
  std::string code;
  Names values;
  std::string where;
  bool onPage = true;
  std::string complaint;  ///< why the values cannot be parsed; empty if they can
};

/// Folders whose messages the page shows; the others belong to the command.
const std::vector<std::string> kOfPage = {"core", "engine", "viewer", "inspector", "wasm", "web"};
const std::vector<std::string> kOfCommand = {"cli", "native", "study"};

bool isQuote(char c) { return c == '"' || c == '\'' || c == '`'; }

/// Returns the index after the literal that begins at `i`; a digit separator is no literal.
std::size_t pastLiteral(const std::string& text, std::size_t i) {
  const char quote = text[i];
  if (quote == '\'' && i > 0 && std::isalnum(static_cast<unsigned char>(text[i - 1]))) return i + 1;
  for (++i; i < text.size() && text[i] != quote; ++i)
    if (text[i] == '\\') ++i;
  return i + 1;
}

std::string withoutComments(const std::string& source) {
  std::string text;
  for (std::size_t i = 0; i < source.size();) {
    if (source.compare(i, 2, "//") == 0) {
      i = std::min(source.find('\n', i), source.size());
    } else if (source.compare(i, 2, "/*") == 0) {
      i = std::min(source.find("*/", i), source.size() - 2) + 2;
    } else if (source[i] == '"' || source[i] == '`') {
      const std::size_t end = std::min(pastLiteral(source, i), source.size());
      text.append(source, i, end - i);
      i = end;
    } else {
      text += source[i++];
    }
  }
  return text;
}

/// Returns the text between brackets, split at its commas. @param open place of the opening bracket
std::vector<std::string> partsWithin(const std::string& text, std::size_t open) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (std::size_t i = open + 1; i < text.size();) {
    const char c = text[i];
    if (isQuote(c)) {
      const std::size_t end = std::min(pastLiteral(text, i), text.size());
      parts.back().append(text, i, end - i);
      i = end;
      continue;
    }
    if (std::string("([{").find(c) != std::string::npos) ++depth;
    if (std::string(")]}").find(c) != std::string::npos && depth-- == 0) break;
    if (c == ',' && depth == 0)
      parts.emplace_back();
    else
      parts.back() += c;
    ++i;
  }
  for (std::string& part : parts) {
    const auto first = part.find_first_not_of(" \n");
    part = first == std::string::npos ? "" : part.substr(first, part.find_last_not_of(" \n") - first + 1);
  }
  if (parts.back().empty()) parts.pop_back();
  return parts;
}

/// @param args  the code, then with::kind("name", …)
void readCppValues(const std::vector<std::string>& args, Made& made) {
  static const std::regex kValue(R"re(with::\w+\(\s*"(\w+)"[\s\S]*)re");
  for (std::size_t i = 1; i < args.size(); ++i) {
    std::smatch found;
    if (std::regex_match(args[i], found, kValue))
      made.values.insert(found[1]);
    else
      made.complaint = "the value " + args[i] + " is no with::kind(\"name\", …)";
  }
}

/// @param args  the code, then an object by names, or nothing
void readJsValues(const std::vector<std::string>& args, Made& made) {
  static const std::regex kProperty(R"((\w+)(:[\s\S]*)?)");
  if (args.size() < 2) return;
  if (args[1].front() != '{') {
    made.complaint = "the values " + args[1] + " are no object";
    return;
  }
  for (const std::string& property : partsWithin(args[1], 0)) {
    std::smatch found;
    if (std::regex_match(property, found, kProperty))
      made.values.insert(found[1]);
    else
      made.complaint = "the value " + property + " has no name";
  }
}

std::vector<Made> messagesIn(const std::string& source, const std::string& where, bool onPage) {
  static const std::regex kMaker(R"(\bmessage\(\s*(["'])([a-z0-9-]+)\1)");
  const std::string text = withoutComments(source);
  std::vector<Made> all;
  for (std::sregex_iterator at(text.begin(), text.end(), kMaker), end; at != end; ++at) {
    Made made{(*at)[2], {}, where, onPage, {}};
    const auto args = partsWithin(text, text.find('(', static_cast<std::size_t>(at->position())));
    if ((*at)[1] == "\"")
      readCppValues(args, made);
    else
      readJsValues(args, made);
    all.push_back(std::move(made));
  }
  return all;
}

std::string contentsOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::vector<Made> messagesOfSources() {
  std::vector<Made> all;
  const fs::path root = QRELIEF_SOURCE_DIR;
  for (const bool onPage : {true, false})
    for (const std::string& folder : onPage ? kOfPage : kOfCommand)
      for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
        const std::string name = fs::relative(entry.path(), root).string();
        const std::string extension = entry.path().extension().string();
        if (extension != ".h" && extension != ".cpp" && extension != ".js") continue;
        if (name.find("test") != std::string::npos) continue;
        const auto found = messagesIn(contentsOf(entry.path()), name, onPage);
        all.insert(all.end(), found.begin(), found.end());
      }
  return all;
}

/// Returns all files of messages/ as one object.
Json words(std::vector<std::string>& complaints) {
  Json all = Json::object();
  for (const auto& entry : fs::directory_iterator(fs::path(QRELIEF_SOURCE_DIR) / "messages")) {
    if (entry.path().extension() != ".json") continue;
    const Json file = Json::parse(contentsOf(entry.path()));
    for (const auto& [code, said] : file.items()) {
      if (all.contains(code)) complaints.push_back(code + " stands twice, the second time in " + entry.path().string());
      all[code] = said;
    }
  }
  return all;
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

std::vector<std::string> complaintsAbout(const Made& made, const Json& words) {
  const std::string which = made.code + " (" + made.where + ")";
  if (!made.complaint.empty()) return {which + ": " + made.complaint};
  if (!words.contains(made.code)) return {which + " has no words in messages/"};
  std::vector<std::string> complaints;
  const Json& entry = words.at(made.code);
  for (const std::string language : {"en", "de"}) {
    if (!entry.contains(language)) {
      if (made.onPage || language == "en") complaints.push_back(which + " has no sentence in " + language);
      continue;
    }
    Names used = placeholders(entry.at(language));
    if (entry.contains("hint")) {
      if (entry.at("hint").contains(language))
        used.merge(placeholders(entry.at("hint").at(language)));
      else if (made.onPage)
        complaints.push_back(which + " has no hint in " + language);
    }
    for (const std::string& name : made.values)
      if (!used.contains(name))
        complaints.push_back(which + " gives " + name + ", which its " + language + " leaves out");
    for (const std::string& name : used)
      if (!made.values.contains(name))
        complaints.push_back(which + " lacks " + name + ", which its " + language + " tells");
  }
  return complaints;
}

TEST(Messages, OfTheSourcesHaveWordsForTheirValuesInEachLanguage) {
  std::vector<std::string> complaints;
  const Json said = words(complaints);
  for (const Made& made : messagesOfSources()) {
    const auto found = complaintsAbout(made, said);
    complaints.insert(complaints.end(), found.begin(), found.end());
  }
  EXPECT_THAT(complaints, IsEmpty());
}

TEST(Messages, AreAllMadeSomewhere) {
  Names made;
  for (const Made& one : messagesOfSources()) made.insert(one.code);
  EXPECT_GT(made.size(), 50U) << "the sources are written differently now";
  std::vector<std::string> complaints;
  const Json all = words(complaints);
  for (const auto& [code, said] : all.items())
    if (!made.contains(code)) complaints.push_back(code + " is said nowhere");
  EXPECT_THAT(complaints, IsEmpty());
}

TEST(Messages, AreFoundInBothLanguagesOfTheSources) {
  const auto cpp = messagesIn(R"cpp(
                                // message("commented", with::count("x", 1))
                                return fail(ErrorKind::BadInput,
                                            message("outer", with::quoted("name", f(a, "b, )")),
                                                    with::cause("why", message("inner", with::count("n", list[0])))));
                                message("bare");
                                1'000;
                                message("loose", at);)cpp",
                              "x.cpp", true);
  ASSERT_EQ(cpp.size(), 4U);
  EXPECT_EQ(cpp[0].values, (Names{"name", "why"}));
  EXPECT_EQ(cpp[1].values, Names{"n"});
  EXPECT_EQ(cpp[2].values, Names{});
  EXPECT_THAT(cpp[3].complaint, HasSubstr("at is no with::kind"));
  const auto js = messagesIn(R"js(
      /** `message('commented')` */
      refuse(message('outer', { name: { term: `a, ${b}` }, from, why: { cause: message('inner', {}) } }));)js",
                             "x.js", true);
  ASSERT_EQ(js.size(), 2U);
  EXPECT_EQ(js[0].values, (Names{"name", "from", "why"}));
  EXPECT_EQ(js[1].values, Names{});
}

TEST(Messages, AreComplainedAboutIfTheirWordsDoNotFit) {
  const Json said = Json::parse(R"({"a": {"en": "{x}", "de": "{x}", "hint": {"en": "Do", "de": "Tun"}},
      "b": {"en": "B"}, "n": {"en": {"one": "a hole", "other": "{count} holes"}, "de": "{count} mal"}})");
  const auto about = [&](const std::string& source, bool onPage = true) {
    const auto made = messagesIn(source, "x.cpp", onPage);
    return complaintsAbout(made.at(0), said);
  };
  EXPECT_THAT(about(R"(message("a", with::count("x", 1)))"), IsEmpty());
  EXPECT_THAT(about(R"(message("n", with::count("count", 1)))"), IsEmpty());
  EXPECT_THAT(about(R"(message("a"))"), Contains(HasSubstr("lacks x, which its de tells")));
  EXPECT_THAT(about(R"(message("a", with::count("x", 1), with::count("y", 1)))"),
              Contains(HasSubstr("gives y, which its en leaves out")));
  EXPECT_THAT(about(R"(message("b"))"), Contains(HasSubstr("no sentence in de")));
  EXPECT_THAT(about(R"(message("b"))", false), IsEmpty());
  EXPECT_THAT(about(R"(message("c"))"), Contains(HasSubstr("no words")));
}

}  // namespace
}  // namespace qrelief
