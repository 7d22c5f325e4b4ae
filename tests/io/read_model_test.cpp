// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_model.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/write_model.h"
#include "io/write_stl.h"
#include "mesh/prepare.h"
#include "message_codes/files.h"
#include "messages/sentences.h"
#include "support/model_files.h"
#include "support/shapes.h"
#include "support/zip_file.h"

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
  EXPECT_EQ(soup->warnings.at(0), message<"format-misnamed">(with::term<"named">("STL"), with::term<"found">("OBJ")));
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
                  message<"text-encoding">(with::term<"encoding">(bigEndian ? "UTF-16 BE" : "UTF-16 LE")));
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

std::string errorOf(const Bytes& bytes, const std::string& name) {
  const auto soup = readModel(bytes, name);
  if (soup) return "no error";
  EXPECT_EQ(soup.error().kind, ErrorKind::BadInput);
  EXPECT_FALSE(hint(soup.error().message).empty()) << sentence(soup.error().message);
  return sentence(soup.error().message);
}

TEST(ReadModel, SaysWhatAFileIsThatIsNoModel) {
  using namespace std::string_literals;
  const std::string tar = std::string(257, 'x') + "ustar", iges = std::string(72, ' ') + "S      1\n" + "1H,,1H;\n";
  const std::pair<std::string, std::string> files[] = {
      {"%PDF-1.7\n", "PDF"},
      {"\x89PNG\r\n\x1a\n\0\0"s, "a picture (PNG)"},
      {"\xFF\xD8\xFF\xE0\0\x10JFIF"s, "a picture (JPEG)"},
      {"RIFF\x10\0\0\0WEBPVP8 "s, "a picture (WebP)"},
      {"<?xml version=\"1.0\"?>\n<svg width=\"1\"/>", "a picture (SVG)"},
      {"ISO-10303-21;\nHEADER;\n", "STEP files describe exact surfaces"},
      {iges, "IGES files describe exact surfaces"},
      {"  0\r\nSECTION\r\n  2\r\nHEADER\r\n", "cannot read DXF files"},
      {"BLENDER-v293", "cannot read Blender files"},
      {"Kaydara FBX Binary  \0"s, "cannot read FBX files"},
      {"<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"x\">", "cannot read COLLADA files"},
      {"{\"asset\": {\"version\": \"2.0\"}}", "cannot read glTF files"},
      {"<!DOCTYPE HTML>\n<title>404</title>", "a web page"},
      {"<?xml version=\"1.0\"?><Error><Code>AccessDenied</Code></Error>", "XML"},
      {"[{\"text\": \"a\"}]", "This is JSON"},
      {"\xEF\xBB\xBF {\"a\": 1}", "This is JSON"},
      {"; generated by PrusaSlicer 2.5.0\n\nM73 P0 R10\n", "G-code"},
      {"; by hand\nG28 ; home\nG1 X1 Y2\n", "G-code"},
      {"GCDE\1\0\0\0"s, "G-code"},
      {"\x1F\x8B\x08\0\0"s, "an archive (gzip)"},
      {tar, "an archive (tar)"},
      {"7z\xBC\xAF\x27\x1C", "an archive (7z)"},
      {"Rar!\x1A\x07", "an archive (RAR)"},
      {"version https://git-lfs.github.com/spec/v1\noid sha256:0\n", "a pointer of Git LFS"}};
  for (const auto& [content, what] : files)
    for (const char* name : {"a.stl", "a.obj", "a.off", "a.ply", "a.3mf", "a"})
      EXPECT_THAT(errorOf(bytesOf(content), name), HasSubstr(what)) << name;
}

TEST(ReadModel, DoesNotMistakeModelsForOtherFiles) {
  Bytes stl = writeStl(shapes::tetrahedron(10));
  const std::string header = "{\"made\": \"by a scanner\"}";
  std::copy(header.begin(), header.end(), stl.begin());
  stl.push_back(0);  // the size is no longer exact
  EXPECT_TRUE(readModel(stl, "a.stl"));
  EXPECT_THAT(errorOf(bytesOf("; only a comment\nhello\n"), "a"), HasSubstr("a known format"));
}

Bytes zipOf(const std::vector<std::string>& names, const Bytes& content) {
  std::vector<zip_file::File> files;
  for (const std::string& name : names) files.push_back({name, std::string(content.begin(), content.end())});
  return zip_file::zip(files);
}

TEST(ReadModel, ReadsTheOnlyModelOfAZip) {
  for (const Sample& sample : samples(shapes::tetrahedron(10)))
    for (const char* name : {"a.zip", "a.3mf", "a.stl"}) {
      const auto soup = readModel(
          zipOf({"parts/readme.txt", "__MACOSX/parts/._" + sample.name, "parts/" + sample.name}, sample.bytes), name);
      ASSERT_TRUE(soup) << sample.name << ": " << sentence(soup.error().message);
      EXPECT_EQ(soup->triangles.size(), 4u);
      ASSERT_FALSE(soup->warnings.empty());
      const auto read = std::find(soup->warnings.begin(), soup->warnings.end(),
                                  message<"zip-read">(with::quoted<"file">("parts/" + sample.name)));
      EXPECT_NE(read, soup->warnings.end()) << sample.name << ' ' << name;
    }
}

TEST(ReadModel, ReadsAModelOfAZipWhateverItsFolder) {
  // Nothing is written where an archive says, so no path can do harm.
  const Bytes stl = writeStl(shapes::tetrahedron(10));
  for (const std::string name : {"../../x.stl", "./x.stl", "/etc/x.stl", "..\\x.stl"})
    EXPECT_TRUE(readModel(zipOf({name}, stl), "x.zip")) << name;
  for (const std::string name : {".x.stl", "a/.b/x.stl", "../.x.stl", "a\\.x.stl"})
    EXPECT_THAT(errorOf(zipOf({name}, stl), "x.zip"), HasSubstr("holds no file")) << name;
}

TEST(ReadModel, NamesTheFilesOfAZipWithoutOneModel) {
  const Bytes stl = writeStl(shapes::tetrahedron(10));
  EXPECT_EQ(errorOf(zipOf({"a.stl", "b/c.STL", "note.txt"}, stl), "x.zip"),
            "The ZIP archive holds 2 models: \"a.stl, b/c.STL\"");
  EXPECT_EQ(errorOf(zipOf({"Schl\u00FCssel.stl", "\u5B57.stl"}, stl), "x.zip"),
            "The ZIP archive holds 2 models: \"Schl\u00FCssel.stl, \u5B57.stl\"");
  EXPECT_EQ(errorOf(zipOf({"a\x81\x1B\u0085.jpg"}, stl), "x.zip"),
            "The ZIP archive holds no model, only 1 file: \"a???.jpg\"");
  EXPECT_EQ(errorOf(zipOf({"a.jpg"}, stl), "x.zip"), "The ZIP archive holds no model, only 1 file: \"a.jpg\"");
  EXPECT_THAT(errorOf(zipOf({"1", "2", "3", "4", "5", "6"}, stl), "x.3mf"),
              HasSubstr("6 files: \"1, 2, 3, 4, 5, ...\""));
  EXPECT_THAT(errorOf(zipOf({}, stl), "x.zip"), HasSubstr("holds no file"));
  EXPECT_THAT(errorOf(zipOf({"_rels/.rels", "xl/workbook.xml"}, stl), "x.xlsx"), HasSubstr("Excel"));
  EXPECT_THAT(errorOf(zipOf({"Document.xml"}, stl), "x.FCStd"), HasSubstr("FreeCAD files describe exact surfaces"));
  EXPECT_THAT(errorOf(zipOf({"Manifest.dat"}, stl), "x.f3d"), HasSubstr("Fusion files describe exact surfaces"));
}

TEST(ReadModel, DoesNotUnpackAZipWithinAZip) {
  const Bytes inner = zipOf({"a.stl"}, writeStl(shapes::tetrahedron(10)));
  EXPECT_THAT(errorOf(zipOf({"inner.zip"}, inner), "x.zip"), HasSubstr("holds no model"));
  EXPECT_THAT(errorOf(zipOf({"inner.3mf"}, inner), "x.zip"), HasSubstr("no part \"_rels/.rels\""));
}

TEST(ReadModel, ReadsAnArchiveWithBytesAfterItsEnd) {
  for (Bytes bytes : {zipOf({"a.stl"}, writeStl(shapes::tetrahedron(10))),
                      *writeModel(shapes::tetrahedron(10), ModelFormat::ThreeMf)}) {
    bytes.resize(bytes.size() + 3, '\n');
    const auto soup = readModel(bytes, "a.3mf");
    ASSERT_TRUE(soup) << sentence(soup.error().message);
    EXPECT_EQ(soup->warnings.back(), message<"zip-trailing-bytes">(with::count<"count">(3)));
  }
}

TEST(ReadModel, ReadsTextsWithPaddingAtTheirEnd) {
  for (const Sample& sample : samples(shapes::tetrahedron(10))) {
    if (sample.name == "a.3mf" || sample.name == "binary.stl") continue;
    for (const std::string& padding : {std::string(512, '\0'), std::string("\x1A"), std::string("\n\0\r\n\0\n", 6)}) {
      Bytes bytes = sample.bytes;
      bytes.insert(bytes.end(), padding.begin(), padding.end());
      const auto soup = readModel(bytes, sample.name);
      ASSERT_TRUE(soup) << sample.name << ": " << sentence(soup.error().message);
      EXPECT_EQ(soup->triangles.size(), 4u);
      EXPECT_TRUE(soup->warnings.empty()) << sample.name;
    }
  }
}

TEST(ReadModel, ReadsKeywordsInSmallLettersAndCapitals) {
  for (const Sample& sample : samples(shapes::tetrahedron(10))) {
    if (!sample.name.starts_with("ascii") && !sample.name.starts_with("a.o")) continue;
    for (const bool inCapitals : {true, false}) {
      Bytes bytes = sample.bytes;
      for (std::uint8_t& c : bytes) c = static_cast<std::uint8_t>(inCapitals ? std::toupper(c) : std::tolower(c));
      const auto soup = readModel(bytes, "model");
      ASSERT_TRUE(soup) << sample.name << ": " << sentence(soup.error().message);
      EXPECT_EQ(soup->triangles.size(), 4u);
      EXPECT_TRUE(soup->warnings.empty()) << sample.name;
    }
  }
}

TEST(ReadModel, LimitsTheSizeOfTheModelInAZip) {
  const Bytes zip = zipOf({"a.stl"}, writeStl(shapes::tetrahedron(10)));
  EXPECT_FALSE(readModel(zip, "a.zip", {.maxExpandedBytes = 200}));
  EXPECT_FALSE(readModel(zip, "a.zip", {.maxTriangles = 3}));
}

TEST(ReadModel, SaysThatA3mfIsSliced) {
  const Bytes sliced = zip_file::threeMf(zip_file::modelPart("", ""), {{"Metadata/plate_1.gcode", "G28\n"}});
  EXPECT_EQ(errorOf(sliced, "plate.gcode.3mf"), "The 3MF file is sliced: it holds G-code for a printer, but no model");
  const Bytes both = zip_file::threeMf(zip_file::modelPart(zip_file::boxObject(1, 1, 2, 3), "<item objectid=\"1\"/>"),
                                       {{"Metadata/plate_1.gcode", "G28\n"}});
  EXPECT_TRUE(readModel(both, "plate.3mf"));
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
