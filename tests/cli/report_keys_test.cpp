// SPDX-License-Identifier: GPL-3.0-or-later
// Compares docs/report.md with reports and manifests of every kind.
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "command_fixture.h"
#include "io/write_stl.h"
#include "support/paths.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using Json = nlohmann::json;
/// Types by the path of a key: "mesh.findings[].at" → {"list", "null"}.
using Keys = std::map<std::string, std::set<std::string>>;

bool isMessage(const Json& json) { return json.is_object() && json.contains("code") && json.contains("values"); }

std::string typeOf(const Json& json) {
  if (json.is_null()) return "null";
  if (json.is_boolean()) return "boolean";
  if (json.is_number_integer()) return "integer";
  if (json.is_number()) return "number";
  if (json.is_string()) return "string";
  if (json.is_array()) return "list";
  return isMessage(json) ? "message" : "object";
}

/// Adds the keys of a value and of everything in it.
void collect(const Json& json, const std::string& path, Keys& keys) {
  if (!path.empty() && !path.ends_with("[]")) keys[path].insert(typeOf(json));
  if (isMessage(json)) return;
  if (json.is_object())
    for (const auto& [key, value] : json.items()) collect(value, path.empty() ? key : path + "." + key, keys);
  if (json.is_array())
    for (const Json& entry : json)
      if (entry.is_object()) collect(entry, path + "[]", keys);
}

/// Expands braces: "size.{a,b}" → "size.a", "size.b".
std::vector<std::string> expanded(const std::string& pattern) {
  const std::size_t open = pattern.find('{'), close = pattern.find('}');
  if (open == std::string::npos) return {pattern};
  std::vector<std::string> paths;
  std::istringstream names(pattern.substr(open + 1, close - open - 1));
  for (std::string name; std::getline(names, name, ',');)
    for (const std::string& path : expanded(pattern.substr(0, open) + name + pattern.substr(close + 1)))
      paths.push_back(path);
  return paths;
}

/// Returns the keys in the table under a heading of docs/report.md.
Keys documented(const std::string& heading) {
  static const std::regex kRow(R"(\| `([^`]+)` \| ([a-z ]+) \| [^|]+ \|)");
  std::istringstream lines(contentOf(sourceFolder() / "docs/report.md"));
  Keys keys;
  bool isUnder = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("## ")) isUnder = line == "## " + heading;
    std::smatch row;
    if (!isUnder || !std::regex_match(line, row, kRow)) continue;
    std::set<std::string> types;
    std::istringstream words(row[2]);
    for (std::string word; words >> word;)
      if (word != "or") types.insert(word);
    for (const std::string& path : expanded(row[1])) EXPECT_TRUE(keys.emplace(path, types).second) << path;
  }
  return keys;
}

bool allows(const std::set<std::string>& types, const std::string& type) {
  return types.contains(type) || (type == "integer" && types.contains("number"));
}

/// Expects every key of the reports to be documented with its type.
void expectDocumented(const Keys& reported, const Keys& known) {
  for (const auto& [path, types] : reported) {
    const auto key = known.find(path);
    if (key == known.end()) {
      // An object needs no row if its keys have rows.
      const auto next = known.lower_bound(path + ".");
      EXPECT_TRUE(types == std::set<std::string>{"object"} && next != known.end() &&
                  next->first.starts_with(path + "."))
          << path << " is not in docs/report.md";
      continue;
    }
    for (const std::string& type : types) EXPECT_TRUE(allows(key->second, type)) << path << " is of type " << type;
  }
}

/// Expects every documented key in one of the reports, with a value.
void expectReported(const Keys& known, const Keys& reported) {
  for (const auto& [path, types] : known) {
    const auto key = reported.find(path);
    ASSERT_NE(key, reported.end()) << path << " is in no report";
    if (types != std::set<std::string>{"null"}) {
      EXPECT_NE(key->second, std::set<std::string>{"null"}) << path;
    }
  }
}

class ReportKeys : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    plate_ = writeModel("plate.stl", shapes::plate({60, 60}, 5, 4, 4));
  }

  Json jsonOf(const std::string& name) const { return Json::parse(contentOf(path(name))); }

  /// Engraves the plate and returns the report, out.json.
  Json engrave(const std::vector<std::string>& more, const std::string& output = "out.3mf",
               const std::string& text = "HELLO") const {
    std::vector<std::string> arguments = {"engrave",    plate_,     "--text",         text,     "-o",
                                          path(output), "--report", path("out.json"), "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return jsonOf("out.json");
  }

  /// Verifies a file against out.json and returns the report.
  Json verify(const std::string& output, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"verify", path(output),          "--report", path("out.json"),
                                          "--json", path("verified.json"), "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    run(arguments);
    return jsonOf("verified.json");
  }

  std::string plate_;
  const std::vector<std::string> centre_ = {"--at", "0,0,5", "--up", "0,1,0", "--size", "25"};
  std::vector<std::string> at(const std::vector<std::string>& more) const {
    std::vector<std::string> all = centre_;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
};

TEST_F(ReportKeys, OfEngravingAndVerifyingAreDocumented) {
  Keys engraved, verified;
  collect(engrave({"--label", "No. 1", "--build-up", "code-up"}), "", engraved);
  collect(engrave(at({"--label", "No. 1"})), "", engraved);
  collect(verify("out.3mf"), "", verified);
  collect(engrave(at({"--light", "45,40", "--contrast", "0.4", "--process", "none"})), "", engraved);
  collect(verify("out.3mf", {"--process", "none", "--quick"}), "", verified);
  collect(engrave(at({"--mark", "paint", "--process", "none"})), "", engraved);
  collect(engrave(at({"--mark", "inlay", "--build-up", "code-up"})), "", engraved);
  collect(verify("out.3mf", {"--quick"}), "", verified);
  collect(engrave(at({"--process", "none", "--pattern-mask", "00100/01110/11111/01110/00100"}), "out.stl",
                  "Gr\u00FC\u00DFe"),
          "", engraved);
  collect(engrave(at({"--content", "text"}), "out.stl", "Rev B"), "", engraved);
  collect(verify("out.stl"), "", verified);
  plate_ = writeModel("thin.stl", shapes::plate({60, 60}, 0.7, 4, 4));
  collect(engrave({"--mark", "auto"}), "", engraved);  // no shadow can be carved
  Mesh open = shapes::plate({60, 60}, 5, 4, 4);
  open.triangles.pop_back();
  writeModel("open.stl", open);
  collect(verify("open.stl", {"--process", "none", "--quick"}), "", verified);

  const Keys ofEngraving = documented("Engraving");
  expectDocumented(engraved, ofEngraving);
  expectReported(ofEngraving, engraved);

  Keys ofVerifying, own = documented("Verifying");
  std::erase_if(own, [](const auto& key) { return key.second.contains("above"); });
  ofVerifying = own;
  ofVerifying.insert(ofEngraving.begin(), ofEngraving.end());
  for (const auto& [path, types] : ofEngraving) {
    if (path.starts_with("depth.features.")) ofVerifying.emplace("carving" + path.substr(5), types);
    if (path.starts_with("depth.lights[]")) ofVerifying.emplace(path.substr(6), types);
  }
  expectDocumented(verified, ofVerifying);
  expectReported(own, verified);
}

TEST_F(ReportKeys, OfManifestsAreDocumented) {
  Keys keys;
  const auto batch = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"batch", plate_, "-o", path("out"), "--quiet", "--text", "p/{n}"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    run(arguments);
    std::istringstream lines(contentOf(path("out/manifest.jsonl")));
    for (std::string line; std::getline(lines, line);) collect(Json::parse(line), "", keys);
    std::filesystem::remove_all(path("out"));
  };
  batch(at({"--count", "1", "--mark", "inlay", "--name", "{n}.stl", "--build-up", "code-up"}));
  batch(at({"--count", "2", "--per-plate", "2", "--name", "{n}.3mf", "--process", "none"}));
  batch(at({"--count", "1", "--content", "text"}));
  batch(at({"--count", "1", "--min-wall", "4.9", "--process", "none"}));  // too thin
  const Keys known = documented("Manifest of a batch");
  expectDocumented(keys, known);
  expectReported(known, keys);
}

}  // namespace
}  // namespace qrelief
