// SPDX-License-Identifier: GPL-3.0-or-later
// `qrelief engrave --maps`.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/command_fixture.h"
#include "io/zip_archive.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using MapsFileTest = CommandTest;

/// An array of an NPZ file.
struct NumpyArray {
  std::string shape;  // as in its header
  std::vector<float> values;
};

NumpyArray arrayOf(const std::string& npy) {
  EXPECT_EQ(npy.substr(0, 8), std::string("\x93NUMPY\x01\0", 8));
  const std::size_t length = static_cast<unsigned char>(npy[8]) + 256 * static_cast<unsigned char>(npy[9]);
  EXPECT_EQ((10 + length) % 64, 0u);
  const std::string header = npy.substr(10, length);
  EXPECT_NE(header.find("'descr': '<f4', 'fortran_order': False"), std::string::npos) << header;
  NumpyArray array;
  const std::size_t begin = header.find('(') + 1;
  array.shape = header.substr(begin, header.find(')') - begin);
  array.values.resize((npy.size() - 10 - length) / sizeof(float));
  std::memcpy(array.values.data(), npy.data() + 10 + length, array.values.size() * sizeof(float));
  return array;
}

TEST_F(MapsFileTest, HasTheMapsAsNumpyArrays) {
  const std::string model = writeModel("ball.stl", shapes::icosphere(40, 5));
  const Outcome outcome = run({"engrave", model, "--text", "https://qrelief.example", "--at", "0,0,40", "--size", "25",
                               "-o", path("out.stl"), "--report", path("out.json"), "--maps", path("maps.npz")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto report = nlohmann::json::parse(contentOf(path("out.json")));
  const std::size_t modules = report["symbol"]["modules"], texels = 10 * (modules + 12), edge = 5 * modules;
  const std::string npz = contentOf(path("maps.npz"));
  const auto archive = ZipArchive::open(std::span(reinterpret_cast<const std::uint8_t*>(npz.data()), npz.size()));
  ASSERT_TRUE(archive.has_value());
  const auto read = [&](const std::string& name) {
    const auto bytes = unpacked(*archive->find(name + ".npy"), std::uint64_t{1} << 30);
    return arrayOf(std::string(bytes->begin(), bytes->end()));
  };

  const NumpyArray normal = read("normal"), height = read("height"), luminance = read("luminance");
  EXPECT_EQ(normal.shape, fmt::format("{0}, {0}, 3", texels));
  EXPECT_EQ(height.shape, fmt::format("{0}, {0}", texels));
  ASSERT_EQ(luminance.values.size(), texels * texels);
  const std::size_t middle = texels / 2 * texels + texels / 2, top = texels / 2;
  EXPECT_NEAR(normal.values[3 * middle + 2], 1, 0.01);
  EXPECT_GT(normal.values[3 * top + 1], 0.2);  // the sphere's top faces up
  EXPECT_NEAR(height.values[middle], 0, 0.05);
  EXPECT_LT(height.values[top], -1);
  EXPECT_GT(*std::max_element(luminance.values.begin(), luminance.values.end()), 0.95f);

  const NumpyArray depth = read("depth"), passDepth = read("pass_depth"), passLuminance = read("pass_luminance");
  EXPECT_EQ(depth.shape, fmt::format("{0}, {0}", edge));
  EXPECT_NEAR(*std::max_element(depth.values.begin(), depth.values.end()), report["depth"]["maxMm"].get<double>(),
              1e-5);
  const int passes = report["depth"]["iterations"];
  EXPECT_EQ(passDepth.shape, fmt::format("{0}, {1}, {1}", passes, edge));
  EXPECT_EQ(passLuminance.shape, passDepth.shape);
  for (std::size_t i = 0; i < passDepth.values.size(); ++i)
    ASSERT_EQ(std::isnan(passDepth.values[i]), std::isnan(passLuminance.values[i]));
  const std::size_t carved = std::count_if(depth.values.begin(), depth.values.end(), [](float d) { return d > 0; });
  const std::size_t inLastPass = std::count_if(passDepth.values.end() - static_cast<std::ptrdiff_t>(edge * edge),
                                               passDepth.values.end(), [](float d) { return !std::isnan(d); });
  EXPECT_GE(inLastPass, carved);
}

}  // namespace
}  // namespace qrelief
