// SPDX-License-Identifier: GPL-3.0-or-later
// Whoever knows the paper finds its algorithms by its own words.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <vector>

#include "support/paths.h"

namespace qrelief {
namespace {

namespace fs = std::filesystem;

std::string lowerCase(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

std::string contentOf(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::size_t countOf(const std::string& word, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

/// Returns the header or shader that a search for a word lists first: the one named by it, else the one that has it
/// most often.
std::string foundBy(const std::string& word) {
  std::string name = word;
  std::replace(name.begin(), name.end(), ' ', '_');
  std::pair<bool, std::size_t> most{false, 0};
  std::string found;
  for (const char* folder : {"core", "shaders"})
    for (const auto& entry : fs::recursive_directory_iterator(sourceFolder() / folder)) {
      const fs::path& path = entry.path();
      if (path.extension() != ".h" && path.extension() != ".frag") continue;
      const std::pair hits{path.stem().string() == name, countOf(word, lowerCase(contentOf(path)))};
      if (hits <= most) continue;
      most = hits;
      found = fs::relative(path, sourceFolder()).generic_string();
    }
  return found;
}

TEST(PaperWords, LeadToTheAlgorithm) {
  const std::vector<std::pair<std::string, std::string>> expected = {
      {"hbao", "shaders/hbao.frag"},
      {"tanh", "core/depth/paper_step_search.h"},
      {"silhouette", "core/projection/silhouette.h"},
      {"isoptic", "core/projection/size_map.h"},
      {"constrained delaunay", "core/carving/constrained_delaunay.h"},
      {"halton", "core/base/halton.h"},
      {"directional light", "core/light/directional_light.h"},
      {"position marker", "core/qr/module_pattern.h"},
  };
  for (const auto& [word, file] : expected) EXPECT_EQ(foundBy(word), file) << word;
}

}  // namespace
}  // namespace qrelief
