// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/xml_document.h"

#include <expat.h>
#include <memory>
#include <stdexcept>

#include "io/zip_archive.h"

namespace qrelief {
namespace {

struct Tree {
  XmlNode top;
  std::vector<XmlNode*> open = {&top};
};

void XMLCALL onStart(void* user, const char* name, const char** attributes) {
  auto& tree = *static_cast<Tree*>(user);
  XmlNode& node = tree.open.back()->children.emplace_back();
  node.name = name;
  for (const char** a = attributes; *a; a += 2) node.attributes[a[0]] = a[1];
  tree.open.push_back(&node);  // stays valid: its parent gets no other child while it is open
}

void XMLCALL onEnd(void* user, const char*) { static_cast<Tree*>(user)->open.pop_back(); }

void XMLCALL onText(void* user, const char* text, int length) {
  static_cast<Tree*>(user)->open.back()->text.append(text, static_cast<std::size_t>(length));
}

}  // namespace

std::string XmlNode::operator[](const std::string& attribute) const {
  const auto it = attributes.find(attribute);
  return it == attributes.end() ? std::string() : it->second;
}

std::vector<const XmlNode*> XmlNode::all(std::string_view tag) const {
  std::vector<const XmlNode*> nodes;
  for (const XmlNode& child : children)
    if (child.name == tag) nodes.push_back(&child);
  return nodes;
}

const XmlNode& XmlNode::first(std::string_view tag) const {
  static const XmlNode kNone;
  const auto nodes = all(tag);
  return nodes.empty() ? kNone : *nodes.front();
}

XmlNode parsedXml(const std::string& text) {
  const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(XML_ParserCreate(nullptr), XML_ParserFree);
  Tree tree;
  XML_SetUserData(parser.get(), &tree);
  XML_SetElementHandler(parser.get(), onStart, onEnd);
  XML_SetCharacterDataHandler(parser.get(), onText);
  if (XML_Parse(parser.get(), text.data(), static_cast<int>(text.size()), XML_TRUE) != XML_STATUS_OK)
    throw std::runtime_error(XML_ErrorString(XML_GetErrorCode(parser.get())));
  return std::move(tree.top.children.front());
}

std::map<std::string, std::string> unzipped(std::span<const std::uint8_t> bytes) {
  std::map<std::string, std::string> files;
  const auto archive = ZipArchive::open(bytes);
  if (!archive) return files;
  for (const ZipEntry* entry : archive->files()) {
    auto stream = ZipStream::open(*entry, 1 << 30);
    std::string& text = files[entry->name];
    while (stream) {
      const auto piece = stream->next();
      if (!piece || piece->empty()) break;
      text.append(piece->begin(), piece->end());
    }
  }
  return files;
}

}  // namespace qrelief
