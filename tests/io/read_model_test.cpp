// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_model.h"

#include <cmath>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/write_model.h"
#include "io/write_stl.h"
#include "mesh/prepare.h"
#include "messages/sentences.h"
#include "support/model_files.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using model_files::Bytes;
using model_files::bytesOf;
using model_files::PlyKind;
using ::testing::HasSubstr;

struct Sample {
  std::string name;
  Bytes bytes;
};

std::vector<Sample> samples(const Mesh& mesh) {
  return {{"binary.stl", writeStl(mesh)},
          {"ascii.stl", bytesOf(model_files::asciiStl(mesh))},
          {"a.obj", bytesOf(model_files::obj(mesh))},
          {"a.off", bytesOf(model_files::off(mesh))},
          {"ascii.ply", model_files::ply(mesh, PlyKind::Ascii)},
          {"little.ply", model_files::ply(mesh, PlyKind::LittleEndian)},
          {"big.ply", model_files::ply(mesh, PlyKind::BigEndian)},
          {"a.3mf", *writeModel(mesh, ModelFormat::ThreeMf)}};
}

/// Expects either an error with a message, or a soup with valid indices and positions.
void expectErrorOrValid(const Bytes& bytes, const std::string& name) {
  const auto soup = readModel(bytes, name);
  if (!soup) {
    ASSERT_FALSE(sentence(soup.error().message).empty());
    ASSERT_EQ(soup.error().kind, ErrorKind::BadInput);
    return;
  }
  ASSERT_FALSE(soup->triangles.empty());
  for (const Triangle& t : soup->triangles)
    for (const std::uint32_t v : t) ASSERT_LT(v, soup->positions.size());
  for (const Vec3& p : soup->positions) ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  const auto model = prepareModel(*soup, {});
  if (!model) {
    ASSERT_FALSE(sentence(model.error().message).empty());
    return;
  }
  for (const Triangle& t : model->mesh.triangles)
    for (const std::uint32_t v : t) ASSERT_LT(v, model->mesh.positions.size());
}

TEST(ReadModel, ReadsEveryFormatByItsExtensionInAnyCase) {
  for (Sample sample : samples(shapes::tetrahedron(10))) {
    for (char& c : sample.name) c = static_cast<char>(std::toupper(c));
    const auto soup = readModel(sample.bytes, sample.name);
    ASSERT_TRUE(soup) << sample.name << ": " << soup.error().message;
    EXPECT_EQ(soup->triangles.size(), 4u);
    EXPECT_TRUE(soup->warnings.empty());
  }
}

TEST(ReadModel, GivesTheSameSolidFromEveryFormat) {
  for (const Sample& sample : samples(shapes::bumpySphere(10, 1, 2, 1))) {
    const auto soup = readModel(sample.bytes, sample.name);
    ASSERT_TRUE(soup);
    const auto model = prepareModel(*soup, {});
    ASSERT_TRUE(model);
    EXPECT_TRUE(model->findings.empty());
    EXPECT_EQ(model->mesh.positions.size(), 42u);
    EXPECT_EQ(signedVolume(model->mesh), signedVolume(shapes::bumpySphere(10, 1, 2, 1))) << sample.name;
  }
}

TEST(ReadModel, DetectsTheFormatByContentIfTheNameHasNoKnownExtension) {
  for (const Sample& sample : samples(shapes::tetrahedron(10))) {
    const auto soup = readModel(sample.bytes, "model");
    ASSERT_TRUE(soup) << sample.name << ": " << soup.error().message;
    EXPECT_TRUE(soup->warnings.empty());
  }
}

TEST(ReadModel, ReadsTheContentWithAWarningIfTheNameIsWrong) {
  const auto soup = readModel(bytesOf("# exported\n" + model_files::obj(shapes::tetrahedron(10))), "model.stl");
  ASSERT_TRUE(soup) << soup.error().message;
  EXPECT_EQ(soup->format, "OBJ");
  EXPECT_EQ(soup->warnings.at(0), message("format-misnamed", with::term<"named">("STL"), with::term<"found">("OBJ")));
  EXPECT_EQ(readModel(writeStl(shapes::tetrahedron(10)), "model.obj")->format, "STL (binary)");
}

/// Returns text as saved by an editor that calls its encoding "Unicode".
Bytes wide(std::string_view text, bool bigEndian, bool marked) {
  Bytes bytes;
  const auto put = [&](std::uint8_t high, std::uint8_t low) {
    bytes.push_back(bigEndian ? high : low);
    bytes.push_back(bigEndian ? low : high);
  };
  if (marked) put(0xfe, 0xff);
  for (const char c : text) put(0, static_cast<std::uint8_t>(c));
  return bytes;
}

TEST(ReadModel, NamesTheEncodingOfTextInUtf16) {
  const Mesh mesh = shapes::tetrahedron(10);
  const Bytes ply = model_files::ply(mesh, PlyKind::Ascii);
  const std::pair<const char*, std::string> texts[] = {{"a.obj", model_files::obj(mesh)},
                                                       {"a.stl", model_files::asciiStl(mesh)},
                                                       {"a.off", model_files::off(mesh)},
                                                       {"a.ply", std::string(ply.begin(), ply.end())}};
  for (const auto& [name, text] : texts)
    for (const bool bigEndian : {false, true})
      for (const bool marked : {false, true}) {
        const auto soup = readModel(wide(text, bigEndian, marked), name);
        ASSERT_FALSE(soup) << name;
        EXPECT_EQ(soup.error().message,
                  message("text-encoding", with::term<"encoding">(bigEndian ? "UTF-16 BE" : "UTF-16 LE")));
      }
  const auto soup = readModel(wide("v 0 0 0\n", false, true), "a.obj");
  EXPECT_THAT(sentence(soup.error().message), HasSubstr("text in UTF-16 LE"));
  EXPECT_THAT(hint(soup.error().message), HasSubstr("UTF-8"));
}

TEST(ReadModel, DoesNotMistakeBinaryFilesForUtf16) {
  Bytes stl = writeStl(shapes::tetrahedron(10));
  stl[0] = 0xff, stl[1] = 0xfe;
  EXPECT_EQ(readModel(stl, "a.stl")->triangles.size(), 4u);
  stl.push_back(0);  // the size is no longer exact
  EXPECT_EQ(readModel(stl, "a.stl")->triangles.size(), 4u);
}

TEST(ReadModel, RefusesAnEmptyFile) {
  EXPECT_THAT(sentence(readModel({}, "a.stl").error().message), HasSubstr("empty"));
}

TEST(ReadModel, RefusesAFileOverTheLimit) {
  EXPECT_THAT(sentence(readModel(writeStl(shapes::tetrahedron(1)), "a.stl", {.maxBytes = 100}).error().message),
              HasSubstr("284 bytes"));
}

TEST(ReadModel, NamesUnsupportedFormats) {
  EXPECT_THAT(sentence(readModel(bytesOf("glTF...."), "a.glb").error().message), HasSubstr("glTF"));
  const auto unknown = readModel(bytesOf("what is this"), "a.txt");
  EXPECT_THAT(sentence(unknown.error().message), HasSubstr("a known format"));
  EXPECT_THAT(hint(unknown.error().message), HasSubstr("PLY"));
}

TEST(ReadModel, RefusesTextThatIsNotAModelUnderAnyName) {
  for (const char* name : {"a.stl", "a.obj", "a.ply", "a.off"})
    EXPECT_FALSE(readModel(bytesOf("<html><body>404 Not Found</body></html>\n"), name)) << name;
}

TEST(ReadModel, SurvivesEveryTruncation) {
  for (const Sample& sample : samples(shapes::box({10, 20, 30})))
    for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
      expectErrorOrValid(Bytes(sample.bytes.begin(), sample.bytes.begin() + static_cast<std::ptrdiff_t>(size)),
                         sample.name);
      if (HasFatalFailure()) FAIL() << sample.name << " cut to " << size;
    }
}

TEST(ReadModel, SurvivesAChangeOfEveryByte) {
  const std::array<std::function<std::uint8_t(std::uint8_t)>, 8> changes = {
      [](std::uint8_t) { return 0x00; },       [](std::uint8_t) { return 0xff; },
      [](std::uint8_t b) { return b ^ 0x01; }, [](std::uint8_t b) { return b ^ 0x80; },
      [](std::uint8_t) { return '9'; },        [](std::uint8_t) { return '-'; },
      [](std::uint8_t) { return '\n'; },       [](std::uint8_t) { return 'e'; }};
  for (const Sample& sample : samples(shapes::box({10, 20, 30})))
    for (std::size_t at = 0; at < sample.bytes.size(); ++at)
      for (std::size_t i = 0; i < changes.size(); ++i) {
        Bytes bytes = sample.bytes;
        bytes[at] = changes[i](bytes[at]);
        expectErrorOrValid(bytes, sample.name);
        if (HasFatalFailure()) FAIL() << sample.name << ", byte " << at << ", change " << i;
      }
}

}  // namespace
}  // namespace qrelief
