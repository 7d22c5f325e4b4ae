// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_3mf.h"

#include <algorithm>
#include <fmt/compile.h>
#include <fmt/format.h>
#include <iterator>

#include "base/utf8.h"
#include "io/zip_writer.h"

namespace qrelief {
namespace {

constexpr std::string_view kXml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
constexpr std::size_t kPieceBytes = 256 * 1024;

/// Returns true for characters that UTF-8 can hold but XML 1.0 cannot: U+FFFE and U+FFFF.
bool isNoCharacter(std::string_view sequence) { return sequence == "\xEF\xBF\xBE" || sequence == "\xEF\xBF\xBF"; }

/// Escapes a text for the value of an attribute. Characters that XML cannot hold become question marks.
std::string escaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = utf8SequenceLength(text);
    const char c = text.front();
    if (length > 1 && isNoCharacter(text.substr(0, length)))
      result += "???";
    else if (length > 1)
      result += text.substr(0, length);
    else if (length == 0 || (c >= 0 && c < ' '))
      result += '?';
    else if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

/// A body and its numbers in the file.
struct NumberedBody {
  const ModelBody* body;
  std::string name;
  std::size_t id;
  std::size_t colour;  ///< index of the colour group, and of the extruder, from 0
};

struct NumberedObject {
  std::string name;
  std::size_t id;  ///< id of the body itself if there is only one
  std::vector<NumberedBody> bodies;
  const ModelObject* object;
};

/// Numbers of everything in the file: colour group 1, then bodies and objects from 2 on.
struct Numbering {
  std::vector<Colour> colours;  ///< each once, in order of appearance; empty if nothing has a colour
  std::vector<NumberedObject> objects;

  Numbering(std::span<const ModelObject> objectsToWrite, const std::string& title) {
    std::size_t nextId = 2;
    for (const ModelObject& object : objectsToWrite) {
      NumberedObject numbered;
      numbered.object = &object;
      numbered.name = !object.name.empty()         ? object.name
                      : objectsToWrite.size() == 1 ? title
                                                   : fmt::format("Object {}", objects.size() + 1);
      for (const ModelBody& body : object.bodies) {
        const std::string name = !body.name.empty() ? body.name : numbered.name;
        numbered.bodies.push_back({&body, name, nextId++, colourOf(body)});
      }
      numbered.id = numbered.bodies.size() == 1 ? numbered.bodies.front().id : nextId++;
      objects.push_back(std::move(numbered));
    }
  }

 private:
  std::size_t colourOf(const ModelBody& body) {
    if (!body.colour) return 0;
    const auto known = std::find(colours.begin(), colours.end(), *body.colour);
    if (known != colours.end()) return static_cast<std::size_t>(known - colours.begin());
    colours.push_back(*body.colour);
    return colours.size() - 1;
  }
};

/// Text that goes into the archive piece by piece; finish() writes the last piece.
class PartText {
 public:
  explicit PartText(ZipWriter& zip) : zip_(zip) {}
  void finish() { zip_.append(text_); }
  template <class Format, class... Values>
  void add(const Format& format, const Values&... values) {
    fmt::format_to(std::back_inserter(text_), format, values...);
    if (text_.size() < kPieceBytes) return;
    zip_.append(text_);
    text_.clear();
  }

 private:
  ZipWriter& zip_;
  std::string text_;
};

void putBody(const NumberedBody& body, bool coloured, PartText& text) {
  const std::string colour = coloured ? fmt::format(" pid=\"1\" pindex=\"{}\"", body.colour) : std::string();
  text.add(FMT_COMPILE("  <object id=\"{}\" name=\"{}\" type=\"model\"{}>\n"), body.id, escaped(body.name), colour);
  if (coloured)
    text.add(FMT_COMPILE("   <metadatagroup><metadata name=\"cura:extruder_nr\" preserve=\"1\" type=\"xs:integer\">{}"
                         "</metadata></metadatagroup>\n"),
             body.colour);
  text.add(FMT_COMPILE("   <mesh>\n    <vertices>\n"));
  for (const Vec3f& p : body.body->mesh.positions)
    text.add(FMT_COMPILE("     <vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n"), p.x, p.y, p.z);
  text.add(FMT_COMPILE("    </vertices>\n    <triangles>\n"));
  for (const auto& [a, b, c] : body.body->mesh.triangles)
    text.add(FMT_COMPILE("     <triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n"), a, b, c);
  text.add(FMT_COMPILE("    </triangles>\n   </mesh>\n  </object>\n"));
}

void putItem(const NumberedObject& numbered, PartText& text) {
  const Vec3 offset = numbered.object->offsetMm;
  const std::string transform =
      offset == Vec3(0) ? "" : fmt::format(" transform=\"1 0 0 0 1 0 0 0 1 {} {} {}\"", offset.x, offset.y, offset.z);
  if (numbered.object->description.empty())
    text.add(FMT_COMPILE("  <item objectid=\"{}\"{}/>\n"), numbered.id, transform);
  else
    text.add(FMT_COMPILE("  <item objectid=\"{}\"{}>\n   <metadatagroup><metadata name=\"Description\">{}</metadata>"
                         "</metadatagroup>\n  </item>\n"),
             numbered.id, transform, escaped(numbered.object->description));
}

void putModel(const Numbering& numbering, const std::string& title, ZipWriter& zip) {
  zip.begin("3D/3dmodel.model");
  PartText text(zip);
  const bool coloured = !numbering.colours.empty();
  text.add(FMT_COMPILE("{}<model unit=\"millimeter\" xml:lang=\"en-US\" "
                       "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"{}>\n"),
           kXml,
           coloured ? " xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\" "
                      "xmlns:cura=\"http://software.ultimaker.com/xml/cura/3mf/2015/10\" requiredextensions=\"m\""
                    : "");
  text.add(
      FMT_COMPILE(" <metadata name=\"Title\">{}</metadata>\n <metadata name=\"Application\">QRelief {}</metadata>\n"),
      escaped(title), QRELIEF_VERSION);
  text.add(FMT_COMPILE(" <resources>\n"));
  if (coloured) {
    text.add(FMT_COMPILE("  <m:colorgroup id=\"1\">\n"));
    for (const auto& [red, green, blue] : numbering.colours)
      text.add(FMT_COMPILE("   <m:color color=\"#{:02X}{:02X}{:02X}FF\"/>\n"), red, green, blue);
    text.add(FMT_COMPILE("  </m:colorgroup>\n"));
  }
  for (const NumberedObject& object : numbering.objects) {
    for (const NumberedBody& body : object.bodies) putBody(body, coloured, text);
    if (object.bodies.size() == 1) continue;
    text.add(FMT_COMPILE("  <object id=\"{}\" name=\"{}\" type=\"model\">\n   <components>\n"), object.id,
             escaped(object.name));
    for (const NumberedBody& body : object.bodies) text.add(FMT_COMPILE("    <component objectid=\"{}\"/>\n"), body.id);
    text.add(FMT_COMPILE("   </components>\n  </object>\n"));
  }
  text.add(FMT_COMPILE(" </resources>\n <build>\n"));
  for (const NumberedObject& object : numbering.objects) putItem(object, text);
  text.add(FMT_COMPILE(" </build>\n</model>\n"));
  text.finish();
}

void putBambuSettings(const Numbering& numbering, ZipWriter& zip) {
  zip.begin("Metadata/model_settings.config");
  PartText text(zip);
  text.add(FMT_COMPILE("{}<config>\n"), kXml);
  for (const NumberedObject& object : numbering.objects) {
    text.add(FMT_COMPILE(" <object id=\"{}\">\n  <metadata key=\"name\" value=\"{}\"/>\n"
                         "  <metadata key=\"extruder\" value=\"{}\"/>\n"),
             object.id, escaped(object.name), object.bodies.front().colour + 1);
    for (const NumberedBody& body : object.bodies)
      text.add(FMT_COMPILE("  <part id=\"{}\" subtype=\"normal_part\">\n   <metadata key=\"name\" value=\"{}\"/>\n"
                           "   <metadata key=\"extruder\" value=\"{}\"/>\n  </part>\n"),
               body.id, escaped(body.name), body.colour + 1);
    text.add(FMT_COMPILE(" </object>\n"));
  }
  text.add(FMT_COMPILE("</config>\n"));
  text.finish();
}

void putPrusaSettings(const Numbering& numbering, ZipWriter& zip) {
  zip.begin("Metadata/Slic3r_PE_model.config");
  PartText text(zip);
  text.add(FMT_COMPILE("{}<config>\n"), kXml);
  for (const NumberedObject& object : numbering.objects)
    for (const NumberedBody& body : object.bodies)
      text.add(FMT_COMPILE(" <object id=\"{0}\" instances_count=\"1\">\n"
                           "  <metadata type=\"object\" key=\"name\" value=\"{1}\"/>\n"
                           "  <metadata type=\"object\" key=\"extruder\" value=\"{2}\"/>\n"
                           "  <volume firstid=\"0\" lastid=\"{3}\">\n"
                           "   <metadata type=\"volume\" key=\"name\" value=\"{1}\"/>\n  </volume>\n </object>\n"),
               body.id, escaped(body.name), body.colour + 1, body.body->mesh.triangles.size() - 1);
  text.add(FMT_COMPILE("</config>\n"));
  text.finish();
}

}  // namespace

Result<std::vector<std::uint8_t>> write3mf(std::span<const ModelObject> objects, const WriteOptions& options) {
  const Numbering numbering(objects, options.title);
  ZipWriter zip;
  zip.begin("[Content_Types].xml");
  zip.append(kXml);
  zip.append(
      "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\n"
      " <Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\n"
      " <Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\n"
      " <Default Extension=\"config\" ContentType=\"application/xml\"/>\n"
      "</Types>\n");
  zip.begin("_rels/.rels");
  zip.append(kXml);
  zip.append(
      "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\n"
      " <Relationship Target=\"/3D/3dmodel.model\" Id=\"model\" "
      "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>\n"
      "</Relationships>\n");
  putModel(numbering, options.title, zip);
  if (!numbering.colours.empty()) {
    putBambuSettings(numbering, zip);
    putPrusaSettings(numbering, zip);
  }
  return zip.finish();
}

}  // namespace qrelief
