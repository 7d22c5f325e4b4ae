// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/three_mf/xml_reader.h"

#include <exception>
#include <expat.h>
#include <memory>
#include <new>

#include "base/parallel.h"
#include "io/polygon_list.h"
#include "message_codes/files.h"

namespace qrelief {
namespace {

constexpr char kBetweenSpaceAndName = '\n';
constexpr int kMaxDepth = 100;
constexpr XML_Index kMaxTagBytes = 1 << 20;

/// State that Expat passes to its callbacks.
struct Session {
  XML_Parser parser = nullptr;
  XmlHandler& handler;
  int depth = 0;
  Status status{};
  std::exception_ptr thrown{};  // must not pass through Expat, which is C

  template <class Step>
  void guarded(Step step) {
    if (!status || thrown) return;
    try {
      status = step();
    } catch (...) {
      thrown = std::current_exception();
    }
    if (!status || thrown) XML_StopParser(parser, XML_FALSE);
  }
};

void XMLCALL onStart(void* user, const XML_Char* name, const XML_Char** attributes) {
  auto& session = *static_cast<Session*>(user);
  session.guarded([&]() -> Status {
    if (++session.depth > kMaxDepth) return badInput(message<"xml-too-deep">(with::count<"limit">(kMaxDepth)));
    return session.handler.startElement(XmlElement(name, attributes));
  });
}

void XMLCALL onEnd(void* user, const XML_Char*) {
  auto& session = *static_cast<Session*>(user);
  session.guarded([&] {
    --session.depth;
    return session.handler.endElement();
  });
}

void XMLCALL onSpace(void* user, const XML_Char* prefix, const XML_Char* uri) {
  auto& session = *static_cast<Session*>(user);
  session.guarded([&]() -> Status {
    session.handler.declareSpace(prefix ? prefix : "", uri ? uri : "");
    return {};
  });
}

void XMLCALL onText(void* user, const XML_Char* text, int length) {
  auto& session = *static_cast<Session*>(user);
  session.guarded([&]() -> Status {
    session.handler.text({text, static_cast<std::size_t>(length)});
    return {};
  });
}

void XMLCALL onDoctype(void* user, const XML_Char*, const XML_Char*, const XML_Char*, int) {
  static_cast<Session*>(user)->guarded([]() -> Status { return badInput(message<"xml-dtd">()); });
}

/// Compares without finding the text's end first: most names differ in their first character.
bool isSame(const char* text, std::string_view word) {
  for (const char c : word)
    if (*text++ != c) return false;
  return *text == '\0';
}

}  // namespace

XmlElement::XmlElement(const char* fullName, const char* const* attributes) : name(fullName), attributes_(attributes) {
  if (const std::size_t end = name.rfind(kBetweenSpaceAndName); end != std::string_view::npos) {
    space = name.substr(0, end);
    name.remove_prefix(end + 1);
  }
}

std::optional<std::string_view> XmlElement::attribute(std::string_view wanted) const {
  for (const char* const* a = attributes_; *a; a += 2)
    if (isSame(*a, wanted)) return a[1];
  return std::nullopt;
}

std::optional<std::string_view> XmlElement::attribute(std::string_view uri, std::string_view wanted) const {
  for (const char* const* a = attributes_; *a; a += 2) {
    const std::string_view full = *a;
    if (full.size() == uri.size() + 1 + wanted.size() && full.starts_with(uri) && full.ends_with(wanted) &&
        full[uri.size()] == kBetweenSpaceAndName)
      return a[1];
  }
  return std::nullopt;
}

std::size_t XmlElement::attributeCount() const {
  std::size_t count = 0;
  for (const char* const* a = attributes_; *a; a += 2) ++count;
  return count;
}

bool XmlElement::hasAttributeNamed(std::string_view wanted) const {
  for (const char* const* a = attributes_; *a; a += 2) {
    std::string_view own = *a;
    own.remove_prefix(own.rfind(kBetweenSpaceAndName) + 1);  // without a prefix: npos + 1 = 0
    if (own == wanted) return true;
  }
  return false;
}

Status readXml(ZipStream& stream, const std::string& part, XmlHandler& handler) {
  const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(
      XML_ParserCreateNS(nullptr, kBetweenSpaceAndName), XML_ParserFree);
  if (!parser) throw std::bad_alloc();
  Session session{parser.get(), handler};
  XML_SetUserData(parser.get(), &session);
  XML_SetElementHandler(parser.get(), onStart, onEnd);
  XML_SetCharacterDataHandler(parser.get(), onText);
  XML_SetStartNamespaceDeclHandler(parser.get(), onSpace);
  XML_SetStartDoctypeDeclHandler(parser.get(), onDoctype);
  const auto failHere = [&](Message what) {
    return badInput(message<"3mf-part-line">(with::quoted<"part">(excerpt(part)),
                                             with::index<"line">(XML_GetCurrentLineNumber(parser.get())),
                                             with::cause<"cause">(std::move(what))));
  };

  XML_Index fed = 0;
  for (auto piece = stream.next(), following = piece;; piece = following) {
    QRELIEF_TRY(piece);
    const bool more = !piece->empty();
    XML_Status parsed = XML_STATUS_OK;
    parallelFor(more ? 2 : 1, [&](int i) {  // the next piece is unpacked meanwhile
      if (i == 0)
        parsed = XML_Parse(parser.get(), reinterpret_cast<const char*>(piece->data()), static_cast<int>(piece->size()),
                           more ? XML_FALSE : XML_TRUE);
      else
        following = stream.next();
    });
    if (session.thrown) std::rethrow_exception(session.thrown);
    if (!session.status) return failHere(std::move(session.status.error().message));
    if (parsed != XML_STATUS_OK) {
      if (XML_GetErrorCode(parser.get()) == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
      return failHere(message<"xml-malformed">(with::term<"why">(XML_ErrorString(XML_GetErrorCode(parser.get())))));
    }
    if (!more) return {};
    fed += static_cast<XML_Index>(piece->size());
    // Expat keeps an unfinished tag or comment and scans it again and again.
    if (fed - XML_GetCurrentByteIndex(parser.get()) > kMaxTagBytes)
      return failHere(message<"xml-tag-too-long">(with::count<"limit">(kMaxTagBytes)));
  }
}

}  // namespace qrelief
