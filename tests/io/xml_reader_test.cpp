// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/three_mf/xml_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdexcept>

#include "io/zip_writer.h"
#include "message_codes/files.h"
#include "messages/sentences.h"
#include "support/zip_file.h"

namespace qrelief {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Records the parser's events as text.
class Recorder : public XmlHandler {
 public:
  std::vector<std::string> events;
  std::string refuse, throwAt;

  void declareSpace(std::string_view prefix, std::string_view uri) override {
    events.push_back("space " + std::string(prefix) + "=" + std::string(uri));
  }
  Status startElement(const XmlElement& element) override {
    events.push_back("<" + std::string(element.space) + "|" + std::string(element.name) + " " +
                     std::string(element.attribute("a").value_or("-")) + " " +
                     std::string(element.attribute("urn:p", "a").value_or("-")));
    if (element.name == refuse) return badInput(message<"3mf-two-objects">());
    if (element.name == throwAt) throw std::runtime_error("thrown");
    return {};
  }
  Status endElement() override {
    events.push_back(">");
    return {};
  }
};

Status read(const std::string& text, XmlHandler& handler) {
  ZipWriter writer;
  writer.begin("part.xml");
  writer.append(text);
  const auto bytes = writer.finish();
  const auto archive = ZipArchive::open(*bytes);
  auto stream = ZipStream::open(*archive->find("part.xml"), 1 << 30);
  return readXml(*stream, "part.xml", handler);
}

std::string errorOf(const std::string& text) {
  Recorder recorder;
  const Status status = read(text, recorder);
  return status ? "" : sentence(status.error().message);
}

TEST(XmlReader, ReportsElementsAndAttributesWithTheirNamespaces) {
  Recorder recorder;
  ASSERT_TRUE(read("<r xmlns='urn:d' xmlns:p='urn:p' a='1' p:a='2'>text<p:e/>&lt;<f a='&amp;'/></r>", recorder));
  EXPECT_THAT(recorder.events, ElementsAre("space =urn:d", "space p=urn:p", "<urn:d|r 1 2", "<urn:p|e - -", ">",
                                           "<urn:d|f & -", ">", ">"));
}

TEST(XmlReader, RefusesADocumentTypeDefinition) {
  EXPECT_THAT(errorOf("<?xml version='1.0'?>\n<!DOCTYPE r [<!ENTITY a 'b'>]>\n<r>&a;</r>"), HasSubstr("line 2: "));
  EXPECT_THAT(errorOf("<!DOCTYPE r SYSTEM 'r.dtd'><r/>"), HasSubstr("DTD"));
}

TEST(XmlReader, NamesPartAndLineOfMalformedXml) {
  EXPECT_THAT(errorOf("<r>\n\n<a></b></r>"), HasSubstr("Part \"part.xml\" of the 3MF file, line 3: mismatched tag"));
  EXPECT_THAT(errorOf("<r>"), HasSubstr("no element found"));
  EXPECT_THAT(errorOf(""), HasSubstr("no element found"));
  EXPECT_THAT(errorOf("<r>&unknown;</r>"), HasSubstr("undefined entity"));
  EXPECT_THAT(errorOf("<r>\xff</r>"), HasSubstr("not well-formed"));
}

TEST(XmlReader, StopsWithTheHandlersErrorAndItsLine) {
  Recorder recorder;
  recorder.refuse = "b";
  const Status status = read("<r>\n<b/><c/></r>", recorder);
  ASSERT_FALSE(status);
  EXPECT_EQ(sentence(status.error().message), "Part \"part.xml\" of the 3MF file, line 2: two objects have this id");
  EXPECT_EQ(hint(status.error().message), hint(message<"3mf-two-objects">()));
  EXPECT_THAT(recorder.events, ElementsAre("<|r - -", "<|b - -"));
}

TEST(XmlReader, PropagatesExceptions) {
  Recorder recorder;
  recorder.throwAt = "b";
  EXPECT_THROW((void)read("<r><b/></r>", recorder), std::runtime_error);
}

TEST(XmlReader, RefusesElementsNestedTooDeep) {
  const auto nested = [](int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += "<a>";
    for (int i = 0; i < depth; ++i) text += "</a>";
    return text;
  };
  EXPECT_EQ(errorOf(nested(100)), "");
  EXPECT_THAT(errorOf(nested(101)), HasSubstr("more than 100 elements are nested"));
}

TEST(XmlReader, RefusesAnUnclosedTagOrComment) {
  std::string noise;
  for (std::uint64_t i = 0; i < 300'000; ++i) noise += std::to_string(i * 7919 % 100'003);
  EXPECT_THAT(errorOf("<r a='" + noise + "'/>"), HasSubstr("longer than 1048576 bytes"));
  EXPECT_THAT(errorOf("<r><!--" + noise + "--></r>"), HasSubstr("longer than 1048576 bytes"));
}

TEST(XmlReader, SkipsTextOfAnyLength) {
  EXPECT_EQ(errorOf("<r>" + std::string(5 << 20, 'x') + "</r>"), "");
  EXPECT_EQ(errorOf("<r>" + std::string(5 << 20, ' ') + "</r>"), "");
  EXPECT_EQ(errorOf("<r/>" + std::string(5 << 20, '\n')), "");
}

}  // namespace
}  // namespace qrelief
