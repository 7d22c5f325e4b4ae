// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "io/read_model.h"
#include "io/write_stl.h"
#include "native/zxing_decoder.h"
#include "verification/frontal_reading.h"
#include "verification/reading_variants.h"

namespace qrelief {

/// Returns the number of tries that a frontal reading test makes.
inline std::size_t frontalTries() {
  const std::size_t variants = readingVariants({64, 64, std::vector<std::uint8_t>(64 * 64)}, 8).size();
  return kFrontalViews.size() * variants * zxingDecoders().size();
}

/// Exit status and output of one run of the command.
struct Outcome {
  int status = -1;
  std::string out, err;
};

inline std::string contentOf(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Runs the command in a temporary folder and deletes the folder afterwards.
class CommandTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = std::filesystem::temp_directory_path() / "qrelief_XXXXXX";  // the same test may run in parallel
    ASSERT_TRUE(mkdtemp(name.data()));
    folder_ = name;
  }
  void TearDown() override {
    if (!folder_.empty()) std::filesystem::remove_all(folder_);
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string writeModel(const std::string& name, const Mesh& mesh) const { return writeBytes(name, writeStl(mesh)); }

  std::string writeBytes(const std::string& name, const std::vector<std::uint8_t>& bytes) const {
    std::ofstream(path(name), std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return path(name);
  }

  Result<PolygonSoup> readBack(const std::string& name) const {
    const std::string bytes = contentOf(path(name));
    return readModel(std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()), name);
  }

  /// Runs the command; quotes the arguments for the shell.
  /// @param redirections  for the shell, such as ">/dev/full"; they replace those that collect the output
  Outcome run(const std::vector<std::string>& arguments, const std::string& redirections = {}) const;

  std::filesystem::path folder_;
};

}  // namespace qrelief
