// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/three_mf/settings.h"

#include <nlohmann/json.hpp>

#include "io/three_mf/text.h"
#include "io/three_mf/volumes.h"

namespace qrelief {

void putBambuSettings(std::span<const NumberedObject> objects, ZipWriter& zip) {
  PartText text(zip, kBambuSettings);
  text.add(FMT_COMPILE("{}<config>\n"), kXmlDeclaration);
  for (const NumberedObject& object : objects) {
    text.add(FMT_COMPILE(" <object id=\"{}\">\n  <metadata key=\"name\" value=\"{}\"/>\n"
                         "  <metadata key=\"extruder\" value=\"{}\"/>\n"),
             object.id, escapedXml(object.name), object.bodies.front().filament);
    for (const NumberedBody& body : object.bodies)
      text.add(FMT_COMPILE("  <part id=\"{}\" subtype=\"normal_part\">\n   <metadata key=\"name\" value=\"{}\"/>\n"
                           "   <metadata key=\"extruder\" value=\"{}\"/>\n  </part>\n"),
               body.id, escapedXml(body.name), body.filament);
    text.add(FMT_COMPILE(" </object>\n"));
  }
  text.add(FMT_COMPILE("</config>\n"));
  text.finish();
}

void putBambuPalette(const Numbering& numbering, ZipWriter& zip) {
  nlohmann::ordered_json settings;
  for (const auto& [red, green, blue] : numbering.colours)
    settings["filament_colour"].push_back(fmt::format("#{:02X}{:02X}{:02X}", red, green, blue));
  settings["use_relative_e_distances"] = "1";
  settings["layer_change_gcode"] = "G92 E0\n";  // relative distances need it
  zip.begin("Metadata/project_settings.config");
  zip.append(settings.dump(1) + "\n");
}

namespace {

void putPrusaObject(std::size_t id, const std::string& name, std::span<const NumberedBody> bodies, PartText& text) {
  text.add(FMT_COMPILE(" <object id=\"{}\" instances_count=\"1\">\n"
                       "  <metadata type=\"object\" key=\"name\" value=\"{}\"/>\n"
                       "  <metadata type=\"object\" key=\"extruder\" value=\"{}\"/>\n"),
           id, escapedXml(name), bodies.front().filament);
  std::size_t first = 0;
  for (const NumberedBody& body : bodies) {
    const std::size_t end = first + body.body->mesh.triangles.size();
    text.add(FMT_COMPILE("  <volume firstid=\"{}\" lastid=\"{}\">\n"
                         "   <metadata type=\"volume\" key=\"name\" value=\"{}\"/>\n"
                         "   <metadata type=\"volume\" key=\"volume_type\" value=\"ModelPart\"/>\n"
                         "   <metadata type=\"volume\" key=\"extruder\" value=\"{}\"/>\n  </volume>\n"),
             first, end - 1, escapedXml(body.name), body.filament);
    first = end;
  }
  text.add(FMT_COMPILE(" </object>\n"));
}

}  // namespace

void putPrusaSettings(std::span<const NumberedObject> objects, ZipWriter& zip) {
  PartText text(zip, kPrusaSettings);
  text.add(FMT_COMPILE("{}<config>\n"), kXmlDeclaration);
  for (const NumberedObject& object : objects) {
    if (object.isInOneMesh) {
      putPrusaObject(object.id, object.name, object.bodies, text);
      continue;
    }
    for (const NumberedBody& body : object.bodies) putPrusaObject(body.id, body.name, std::span(&body, 1), text);
  }
  text.add(FMT_COMPILE("</config>\n"));
  text.finish();
}

}  // namespace qrelief
