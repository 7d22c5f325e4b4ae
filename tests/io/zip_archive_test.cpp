// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/zip_archive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/zip_writer.h"
#include "messages/sentences.h"
#include "support/zip_file.h"

namespace qrelief {
namespace {

using ::testing::HasSubstr;
using zip_file::File;
using Bytes = std::vector<std::uint8_t>;

constexpr std::uint64_t kPlenty = 1 << 30;

Result<std::string> contentOf(const ZipArchive& archive, const std::string& name, std::uint64_t maxBytes = kPlenty) {
  auto stream = ZipStream::open(*archive.find(name), maxBytes);
  if (!stream) return tl::unexpected(stream.error());
  std::string text;
  for (;;) {
    const auto piece = stream->next();
    if (!piece) return tl::unexpected(piece.error());
    if (piece->empty()) return text;
    text.append(piece->begin(), piece->end());
  }
}

Result<std::string> contentOf(const Bytes& bytes, const std::string& name, std::uint64_t maxBytes = kPlenty) {
  const auto archive = ZipArchive::open(bytes);
  if (!archive) return tl::unexpected(archive.error());
  return contentOf(*archive, name, maxBytes);
}

std::string errorOf(const Bytes& bytes) {
  const auto archive = ZipArchive::open(bytes);
  return archive ? "" : sentence(archive.error().message);
}

/// Returns text that deflate cannot shrink to nothing, longer than several pieces.
std::string longText() {
  std::string text;
  for (int i = 0; i < 250'000; ++i) text += std::to_string(i * 7919 % 100'003) + " ";
  return text;
}

TEST(ZipArchive, ReadsStoredFiles) {
  const Bytes bytes = zip_file::zip({{"a.txt", "first"}, {"b/c.txt", ""}, {"d", longText()}});
  EXPECT_EQ(contentOf(bytes, "a.txt").value(), "first");
  EXPECT_EQ(contentOf(bytes, "b/c.txt").value(), "");
  EXPECT_EQ(contentOf(bytes, "d").value(), longText());
}

TEST(ZipArchive, ReadsDeflatedFiles) {
  ZipWriter writer;
  writer.begin("empty");
  writer.begin("long");
  const std::string text = longText();
  for (std::size_t at = 0; at < text.size(); at += 1000) writer.append(std::string_view(text).substr(at, 1000));
  writer.begin("short");
  writer.append("x");
  const auto bytes = writer.finish();
  ASSERT_TRUE(bytes);
  EXPECT_LT(bytes->size(), text.size() / 2);
  EXPECT_EQ(contentOf(*bytes, "empty").value(), "");
  EXPECT_EQ(contentOf(*bytes, "long").value(), text);
  EXPECT_EQ(contentOf(*bytes, "short").value(), "x");
}

TEST(ZipStream, KeepsAPieceDuringTheNextCall) {
  const std::string text = longText();
  ZipWriter writer;
  writer.begin("long");
  writer.append(text);
  const Bytes bytes = writer.finish().value();
  const ZipArchive archive = ZipArchive::open(bytes).value();
  ZipStream stream = ZipStream::open(*archive.find("long"), kPlenty).value();
  std::string read;
  int pieces = 0;
  for (auto piece = stream.next(), following = piece; !piece->empty(); piece = following, ++pieces) {
    following = stream.next();
    ASSERT_TRUE(following);
    read.append(piece->begin(), piece->end());
  }
  EXPECT_GT(pieces, 2);
  EXPECT_TRUE(read == text);
}

TEST(ZipArchive, ReadsAFileOfManyBlocks) {
  std::string text;
  while (text.size() < 20'000'000) text += longText();
  const auto written = [&](std::size_t pieceBytes) {
    ZipWriter writer;
    writer.begin("before");
    writer.append("x");
    writer.begin("long");
    for (std::size_t at = 0; at < text.size(); at += pieceBytes)
      writer.append(std::string_view(text).substr(at, pieceBytes));
    return writer.finish().value();
  };
  const Bytes bytes = written(text.size());
  EXPECT_EQ(contentOf(bytes, "before").value(), "x");
  EXPECT_TRUE(contentOf(bytes, "long").value() == text);
  EXPECT_TRUE(written(300'001) == bytes);
}

TEST(ZipArchive, PacksARepetitionInTheNextBlock) {
  const std::string noise = longText().substr(0, 30'000);
  const std::string upToTheBlocksEnd = std::string((1 << 20) - noise.size(), 'a') + noise;
  const auto packedSize = [](const std::string& text) {
    ZipWriter writer;
    writer.begin("a");
    writer.append(text);
    return writer.finish()->size();
  };
  EXPECT_LT(packedSize(upToTheBlocksEnd + noise), packedSize(upToTheBlocksEnd) + 2'000);
}

TEST(ZipArchive, ComparesNamesAsPackagesDo) {
  const auto archive = ZipArchive::open(zip_file::zip({{"3D/My%20Model.model", "x"}, {"folder/", ""}}));
  ASSERT_TRUE(archive);
  EXPECT_NE(archive->find("3d/my model.MODEL"), nullptr);
  EXPECT_EQ(archive->find("3D/MyModel.model"), nullptr);
  EXPECT_EQ(archive->find("folder/"), nullptr);
  EXPECT_NE(ZipArchive::open(zip_file::zip({{"3D\\a.model", "x"}}))->find("3D/a.model"), nullptr);
}

TEST(ZipArchive, ReadsZip64) {
  EXPECT_EQ(contentOf(zip_file::zip64({{"a.txt", "first"}}), "a.txt").value(), "first");
  File large{"b.txt", "second"};
  large.size = large.packedSize = 0xffffffff;
  large.extra = std::string("\x99\x99\x02\0xx\x01\0\x10\0\6\0\0\0\0\0\0\0\6\0\0\0\0\0\0\0", 26);
  EXPECT_EQ(contentOf(zip_file::zip64({large}), "b.txt").value(), "second");
}

TEST(ZipArchive, RefusesMalformedZip64) {
  File large{"b.txt", "second"};
  large.size = 0xffffffff;
  EXPECT_THAT(errorOf(zip_file::zip64({large})), HasSubstr("ZIP64 field"));
  large.extra = std::string("\x01\0\4\0\6\0\0\0", 8);
  EXPECT_THAT(errorOf(zip_file::zip64({large})), HasSubstr("ZIP64 field"));
  Bytes bytes = zip_file::zip64({{"a.txt", "first"}});
  bytes[bytes.size() - 22 - 20 + 8 + 7] = 0xff;  // the locator's offset
  EXPECT_THAT(errorOf(bytes), HasSubstr("ZIP64 record is out of place"));
}

TEST(ZipArchive, RefusesATruncatedFile) {
  Bytes bytes = zip_file::zip({{"a.txt", "first"}});
  bytes.pop_back();
  EXPECT_THAT(errorOf(bytes), HasSubstr("cut off"));
  EXPECT_THAT(errorOf({}), HasSubstr("0 bytes"));
}

TEST(ZipArchive, ReadsAComment) {
  Bytes bytes = zip_file::zip({{"a.txt", "first"}});
  bytes.back() = 0xff, bytes[bytes.size() - 2] = 0xff;
  bytes.resize(bytes.size() + 0xffff, 'x');
  EXPECT_EQ(contentOf(bytes, "a.txt").value(), "first");
  EXPECT_EQ(ZipArchive::open(bytes)->trailingBytes(), 0u);
  bytes.pop_back();
  EXPECT_EQ(contentOf(bytes, "a.txt").value(), "first") << "the directory is whole, if not the comment";
}

TEST(ZipArchive, IgnoresBytesAfterItsEnd) {
  for (const Bytes& bytes : {zip_file::zip({{"a.txt", "first"}}), zip_file::zip64({{"a.txt", "first"}})})
    for (const std::size_t count : {1u, 100'000u}) {
      Bytes longer = bytes;
      longer.insert(longer.end(), count, 0);
      EXPECT_EQ(contentOf(longer, "a.txt").value(), "first");
      EXPECT_EQ(ZipArchive::open(longer)->trailingBytes(), count);
    }
  Bytes bytes = zip_file::zip({{"a.txt", "first"}});
  for (const char c : std::string("PK\5\6\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0 and more", 31)) bytes.push_back(c);
  EXPECT_EQ(contentOf(bytes, "a.txt").value(), "first") << "an end record that follows no directory";
  EXPECT_EQ(ZipArchive::open(bytes)->trailingBytes(), 31u);
}

TEST(ZipArchive, RefusesADirectoryBeyondTheFile) {
  Bytes bytes = zip_file::zip({{"a.txt", "first"}});
  bytes[bytes.size() - 3] = 0x7f;
  EXPECT_THAT(errorOf(bytes), HasSubstr("directory is out of place"));
}

TEST(ZipArchive, RefusesMoreFilesThanTheDirectoryHas) {
  Bytes bytes = zip_file::zip({{"a.txt", "first"}});
  bytes[bytes.size() - 14] = bytes[bytes.size() - 12] = 9;
  EXPECT_THAT(errorOf(bytes), HasSubstr("line 2 of its directory"));
  bytes[bytes.size() - 14] = 8;
  EXPECT_THAT(errorOf(bytes), HasSubstr("several disks"));
}

TEST(ZipArchive, RefusesFilesThatOverlap) {
  File again{"b.txt", "first"};
  again.localHeader = 0;
  again.localName = "b.txt";
  EXPECT_THAT(errorOf(zip_file::zip({{"b.txt", "first"}, {"c.txt", "first", 0, 0, {}, {}, {}, 0}})),
              HasSubstr("\"c.txt\" has a different name"));
  EXPECT_THAT(errorOf(zip_file::zip({{"b.txt", "first"}, again})), HasSubstr("overlap"));
}

TEST(ZipArchive, RefusesTwoFilesWithTheSameName) {
  EXPECT_THAT(errorOf(zip_file::zip({{"a.txt", "x"}, {"A.TXT", "y"}})), HasSubstr("two files named"));
}

TEST(ZipArchive, RefusesAFileThatIsNotAtItsOffset) {
  File file{"a.txt", "first"};
  file.localHeader = 1;
  EXPECT_THAT(errorOf(zip_file::zip({file})), HasSubstr("not where the directory says"));
  file.localHeader = 1000;
  EXPECT_THAT(errorOf(zip_file::zip({file})), HasSubstr("out of place"));
  file.localHeader.reset();
  file.packedSize = 6;
  EXPECT_THAT(errorOf(zip_file::zip({file})), HasSubstr("reaches into the directory"));
}

TEST(ZipArchive, RefusesAnotherNameInTheLocalHeader) {
  File file{"a.txt", "first"};
  file.localName = "b.txt";
  EXPECT_THAT(errorOf(zip_file::zip({file})), HasSubstr("a different name"));
}

TEST(ZipArchive, RefusesOtherNumbersInTheLocalHeader) {
  for (const int at : {8, 14, 18, 22}) {  // method, check sum, both sizes
    Bytes bytes = zip_file::zip({{"a.txt", "first"}});
    ++bytes[static_cast<std::size_t>(at)];
    EXPECT_THAT(errorOf(bytes), HasSubstr("different numbers")) << at;
  }
  Bytes follow = zip_file::zip({{"a.txt", "first", 8}});  // flag: "the numbers come after the content"
  follow[14] = follow[18] = follow[22] = 0;
  EXPECT_EQ(contentOf(follow, "a.txt").value(), "first");
}

TEST(ZipStream, RefusesAWrongChecksum) {
  File file{"a.txt", "first"};
  file.crc = 1;
  EXPECT_THAT(sentence(contentOf(zip_file::zip({file}), "a.txt").error().message), HasSubstr("checksum"));
}

TEST(ZipStream, RefusesTwoSizesOfAStoredFile) {
  File file{"a.txt", "first"};
  file.size = 4;
  EXPECT_THAT(sentence(contentOf(zip_file::zip({file}), "a.txt").error().message), HasSubstr("two different sizes"));
}

TEST(ZipStream, RefusesEncryptionAndUnknownMethods) {
  EXPECT_THAT(sentence(contentOf(zip_file::zip({{"a", "x", 1, 0}}), "a").error().message), HasSubstr("encrypted"));
  EXPECT_THAT(sentence(contentOf(zip_file::zip({{"a", "x", 0, 12}}), "a").error().message), HasSubstr("method 12"));
}

TEST(ZipStream, RefusesDamagedDeflateData) {
  // A stored block of three bytes whose length does not match its complement.
  const std::string block(
      "\x01\x03\x00\x00\x00"
      "abc",
      8);
  File file{"a", block, 0, 8};
  file.size = 3;
  EXPECT_THAT(sentence(contentOf(zip_file::zip({file}), "a").error().message), HasSubstr("cannot be unpacked"));
}

TEST(ZipStream, RefusesMoreAndFewerBytesThanAnnounced) {
  const std::string block(
      "\x01\x03\x00\xfc\xff"
      "abc",
      8);
  File file{"a", block, 0, 8};
  file.crc = 0x352441c2;  // of "abc"
  file.size = 3;
  EXPECT_EQ(contentOf(zip_file::zip({file}), "a").value(), "abc");
  file.size = 2;
  EXPECT_THAT(sentence(contentOf(zip_file::zip({file}), "a").error().message), HasSubstr("more bytes"));
  file.size = 4;
  EXPECT_THAT(sentence(contentOf(zip_file::zip({file}), "a").error().message), HasSubstr("holds 3 bytes, not the 4"));
  file.size = 3;
  file.content += "!";
  EXPECT_THAT(sentence(contentOf(zip_file::zip({file}), "a").error().message), HasSubstr("stray bytes"));
}

TEST(ZipStream, RefusesAFileOverTheLimitBeforeUnpackingIt) {
  EXPECT_THAT(sentence(contentOf(zip_file::zip({{"a", "12345678"}}), "a", 7).error().message),
              HasSubstr("the limits are 7 bytes"));
  EXPECT_EQ(contentOf(zip_file::zip({{"a", "12345678"}}), "a", 8).value(), "12345678");
}

TEST(ZipStream, RefusesAFileThatExpandsTooManyTimes) {
  const auto zipOfBlanks = [](std::size_t size) {
    ZipWriter writer;
    writer.begin("blanks");
    writer.append(std::string(size, ' '));
    return *writer.finish();
  };
  EXPECT_EQ(contentOf(zipOfBlanks(ZipStream::kFreeBytes), "blanks").value().size(), ZipStream::kFreeBytes);
  EXPECT_THAT(sentence(contentOf(zipOfBlanks(ZipStream::kFreeBytes + 1), "blanks").error().message),
              HasSubstr("200-fold"));
}

TEST(ZipArchive, SurvivesEveryTruncationAndChangedByte) {
  ZipWriter writer;
  writer.begin("a/b.txt");
  writer.append("some text that repeats, repeats, repeats");
  writer.begin("c.txt");
  writer.append("x");
  const Bytes good = *writer.finish();
  const auto expectErrorOrContent = [](const Bytes& bytes) {
    const auto archive = ZipArchive::open(bytes);
    if (!archive) {
      EXPECT_EQ(archive.error().kind, ErrorKind::BadInput);
      return;
    }
    for (const char* name : {"a/b.txt", "c.txt"}) {
      if (!archive->find(name)) continue;
      const auto text = contentOf(*archive, name, 1000);
      EXPECT_TRUE(text ? text->size() <= 1000 : !sentence(text.error().message).empty());
    }
  };
  for (std::size_t size = 0; size < good.size(); ++size) {
    const Bytes cut(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_FALSE(ZipArchive::open(cut)) << size;
  }
  for (std::size_t at = 0; at < good.size(); ++at)
    for (int value = 0; value < 256; ++value) {
      Bytes bytes = good;
      bytes[at] = static_cast<std::uint8_t>(value);
      expectErrorOrContent(bytes);
    }
  for (const Bytes& other : {zip_file::zip64({{"a/b.txt", "x"}}), zip_file::zip({{"c.txt", "y"}})})
    for (std::size_t at = 0; at < other.size(); ++at)
      for (const int value : {0x00, 0x01, 0x7f, 0x80, 0xff}) {
        Bytes bytes = other;
        bytes[at] = static_cast<std::uint8_t>(value);
        expectErrorOrContent(bytes);
      }
}

TEST(ZipWriter, IsDeterministic) {
  const auto write = [] {
    ZipWriter writer;
    writer.begin("a");
    writer.append("text");
    return *writer.finish();
  };
  EXPECT_EQ(write(), write());
}

}  // namespace
}  // namespace qrelief
