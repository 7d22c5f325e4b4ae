// SPDX-License-Identifier: GPL-3.0-or-later
// Enforces the layers of ARCHITECTURE.md: the includes that core/ and the folders above it may have.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "support/paths.h"

namespace qrelief {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

/// Layers, lowest first: a folder includes only itself and the folders listed before it.
const std::vector<std::string> kLayers = {"base",     "math",     "mesh",     "io",           "qr",
                                          "light",    "gl",       "render",   "projection",   "label",
                                          "depth",    "carving",  "printing", "verification", "settings",
                                          "pipeline", "delivery", "verdict",  "report",       "batch"};

/// Headers that the build generates from shaders/ and the font of labels; those of locales/ are in message_codes/.
const std::vector<std::string> kGeneratedHeaders = {"shaders.h", "label_font.h"};

bool isGenerated(const std::string& path) {
  return path.starts_with("message_codes/") ||
         std::find(kGeneratedHeaders.begin(), kGeneratedHeaders.end(), path) != kGeneratedHeaders.end();
}

std::ptrdiff_t layerOf(const std::string& folder) {
  const auto it = std::find(kLayers.begin(), kLayers.end(), folder);
  return it == kLayers.end() ? -1 : it - kLayers.begin();
}

/// Returns why a file of core/`folder` must not include `path`; nothing if it may.
std::optional<std::string> whyForbidden(const std::string& folder, const std::string& path, bool quoted) {
  static const std::regex kOutside(
      "(EGL/|emscripten|imgui|backends/imgui|GLFW/|SDL|X11/|CLI/|viewer/|engine/|inspector/|wasm/|cli/|native/"
      "|messages/).*");
  if (std::regex_match(path, kOutside)) return "core knows no window, browser, command line or GL context";
  if (!quoted || isGenerated(path)) return std::nullopt;
  const std::string target = path.substr(0, path.find('/'));
  if (path.find('/') == std::string::npos || layerOf(target) < 0) return "no folder of core";
  if (layerOf(target) > layerOf(folder)) return target + " is a higher layer than " + folder;
  const bool knowsMeshes = target == "mesh" || target == "io";
  if ((folder == "qr" || folder == "gl") && knowsMeshes) return folder + " knows no mesh";
  return std::nullopt;
}

/// Folders that each room may include besides itself. A room is a folder above core/, at the top level or in a folder
/// of kBuildings.
const std::map<std::string, std::vector<std::string>> kRooms = {
    {"viewer", {"core"}},
    {"engine", {"core", "viewer"}},
    {"inspector", {"core", "viewer", "engine"}},
    {"wasm", {"core", "viewer", "engine", "inspector", "messages"}},
    {"native", {"core"}},
    {"messages", {"core"}},
    {"generate", {"core", "messages", "cli"}},
    {"cli", {"core", "native", "messages"}},
    {"study", {"core", "native", "messages", "support"}}};

const std::vector<std::string> kBuildings = {"", "app", "native", "script"};

/// Returns the folder of a room, from the top level.
std::string folderOf(const std::string& room) {
  for (const std::string& building : kBuildings)
    if (fs::exists(sourceFolder() / building / room)) return (fs::path(building) / room).string();
  return room;
}

/// Returns the target of a quoted include: "core", another top-level folder, or "" for a header in the file's own
/// folder.
std::string roomOf(const std::string& path) {
  const std::string folder = path.substr(0, path.find('/'));
  if (isGenerated(path) || layerOf(folder) >= 0) return "core";
  return path.find('/') == std::string::npos ? "" : folder;
}

/// Returns why a file of a room must not include `path`; nothing if it may.
std::optional<std::string> whyForbiddenTo(const std::string& room, const std::string& path, bool quoted) {
  static const std::regex kBrowser("emscripten.*"), kWindow("(backends/)?imgui.*");
  if (std::regex_match(path, kBrowser) && room != "wasm") return "only wasm knows the browser";
  if (std::regex_match(path, kWindow) && room != "inspector") return "only inspector draws windows";
  if (!quoted) return std::nullopt;
  const std::string target = roomOf(path);
  const std::vector<std::string>& known = kRooms.at(room);
  if (target.empty() || target == room || std::find(known.begin(), known.end(), target) != known.end())
    return std::nullopt;
  return room + " knows nothing of " + target;
}

template <class WhyForbidden>
std::vector<std::string> violationsIn(const std::string& name, const std::string& text, WhyForbidden whyForbidden) {
  static const std::regex kInclude("(?:^|\n)[ \t]*#[ \t]*include[ \t]*([<\"])([^>\"]+)[>\"]");
  std::vector<std::string> violations;
  for (std::sregex_iterator at(text.begin(), text.end(), kInclude), end; at != end; ++at) {
    const std::string path = (*at)[2];
    if (const auto why = whyForbidden(path, (*at)[1] == "\""))
      violations.push_back(name + " includes " + path + ": " + *why);
  }
  return violations;
}

std::string contentsOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Returns the violations in every C++ file under a top-level folder. @param whyForbidden of (path in the folder,
/// included path, quoted)
template <class WhyForbidden>
std::vector<std::string> violationsUnder(const std::string& folder, WhyForbidden whyForbidden) {
  const fs::path root = sourceFolder() / folder;
  std::vector<std::string> violations;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const fs::path relative = fs::relative(entry.path(), root);
    const std::string extension = relative.extension().string();
    if (extension != ".h" && extension != ".cpp") continue;
    const auto found =
        violationsIn(folder + "/" + relative.string(), contentsOf(entry.path()),
                     [&](const std::string& path, bool quoted) { return whyForbidden(relative, path, quoted); });
    violations.insert(violations.end(), found.begin(), found.end());
  }
  return violations;
}

TEST(Layers, IncludeOnlyLowerLayers) {
  EXPECT_THAT(violationsUnder("core", [](const fs::path& file, const std::string& path,
                                         bool quoted) { return whyForbidden(file.begin()->string(), path, quoted); }),
              IsEmpty());
}

TEST(Layers, RoomsIncludeOnlyLowerRooms) {
  for (const auto& [room, known] : kRooms) {
    EXPECT_THAT(violationsUnder(folderOf(room),
                                [&room = room](const fs::path& file, const std::string& path, bool quoted) {
                                  const std::string first = *file.begin();  // wasm's tests run under Node
                                  const bool isOther = first == "tests" || (first != room && kRooms.contains(first));
                                  return isOther ? std::nullopt : whyForbiddenTo(room, path, quoted);
                                }),
                IsEmpty());
  }
}

TEST(Layers, AreTheFoldersOfCore) {
  std::vector<std::string> folders;
  for (const auto& entry : fs::directory_iterator(sourceFolder() / "core")) {
    if (entry.is_directory()) folders.push_back(entry.path().filename().string());
  }
  EXPECT_THAT(folders, testing::UnorderedElementsAreArray(kLayers));
}

/// Returns the violation in a line of a file by an include rule, or the number of violations if it is not one.
template <class Rule>
std::string violationOf(const std::string& line, const Rule& why) {
  const std::vector<std::string> violations = violationsIn("x.cpp", "// comment\n" + line + "\nint x;\n", why);
  return violations.size() == 1 ? violations.front() : std::to_string(violations.size()) + " violations";
}

TEST(Layers, DetectForbiddenIncludesOfRooms) {
  const auto only = [](const std::string& room, const std::string& line) {
    return violationOf(line, [&](const std::string& path, bool quoted) { return whyForbiddenTo(room, path, quoted); });
  };
  EXPECT_THAT(only("viewer", "#include \"engine/engine.h\""), HasSubstr("viewer knows nothing of engine"));
  EXPECT_THAT(only("engine", "#include \"inspector/inspector_window.h\""),
              HasSubstr("engine knows nothing of inspector"));
  EXPECT_THAT(only("engine", "#include \"messages/sentences.h\""), HasSubstr("engine knows nothing of messages"));
  EXPECT_THAT(only("engine", "#include <emscripten/val.h>"), HasSubstr("browser"));
  EXPECT_THAT(only("engine", "#include <imgui.h>"), HasSubstr("windows"));
  EXPECT_THAT(only("inspector", "#include \"native/egl_context.h\""), HasSubstr("inspector knows nothing of native"));
  EXPECT_THAT(only("wasm", "#include \"cli/command.h\""), HasSubstr("wasm knows nothing of cli"));
  EXPECT_THAT(only("cli", "#include \"viewer/viewer.h\""), HasSubstr("cli knows nothing of viewer"));
  EXPECT_THAT(only("viewer", "#include \"projection/visibility_map.h\""), "0 violations");
  EXPECT_THAT(only("inspector", "#include <imgui_impl_opengl3.h>"), "0 violations");
  EXPECT_THAT(only("wasm", "#include <emscripten/bind.h>"), "0 violations");
}

TEST(Layers, DetectForbiddenIncludes) {
  const auto only = [](const std::string& folder, const std::string& line) {
    return violationOf(line, [&](const std::string& path, bool quoted) { return whyForbidden(folder, path, quoted); });
  };
  EXPECT_THAT(only("math", "#include \"mesh/mesh.h\""), HasSubstr("mesh is a higher layer than math"));
  EXPECT_THAT(only("carving", "  #  include \"pipeline/job.h\""), HasSubstr("pipeline is a higher layer than carving"));
  EXPECT_THAT(only("qr", "#include \"mesh/mesh.h\""), HasSubstr("qr knows no mesh"));
  EXPECT_THAT(only("gl", "#include \"io/read_model.h\""), HasSubstr("gl knows no mesh"));
  EXPECT_THAT(only("gl", "#include <EGL/egl.h>"), HasSubstr("GL context"));
  EXPECT_THAT(only("render", "#include \"native/egl_context.h\""), HasSubstr("GL context"));
  EXPECT_THAT(only("pipeline", "#include <imgui.h>"), HasSubstr("window"));
  EXPECT_THAT(only("pipeline", "#include \"engine/engine.h\""), HasSubstr("window"));
  EXPECT_THAT(only("base", "#include \"result.h\""), HasSubstr("no folder of core"));
  EXPECT_THAT(only("carving", "#include \"render/luminance_pass.h\""), "0 violations");
  EXPECT_THAT(only("render", "#include \"shaders.h\""), "0 violations");
  EXPECT_THAT(only("base", "#include \"message_codes/files.h\""), "0 violations");
  EXPECT_THAT(only("base", "#include <vector>"), "0 violations");
}

}  // namespace
}  // namespace qrelief
