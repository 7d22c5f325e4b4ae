// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/three_mf/write_3mf.h"

#include <fmt/format.h>

#include "base/version.h"
#include "io/three_mf/filament_code.h"
#include "io/three_mf/numbering.h"
#include "io/three_mf/settings.h"
#include "io/three_mf/text.h"
#include "math/box.h"

namespace qrelief {
namespace {

constexpr double kPlateMiddleMm = 128;  // of Bambu Lab's plates of 256 mm
/// The only program name with a version that Bambu Studio 2.6 and OrcaSlicer 2.3 both accept.
constexpr std::string_view kBambuIdentity = "BambuStudio-02.00.00.00";

/// Attributes that a painted facet gets.
struct PaintNames {
  bool prusa, bambu, colourGroup;
};

PaintNames paintNames(Slicer slicer) {
  return {slicer == Slicer::Any || slicer == Slicer::PrusaSlicer, slicer != Slicer::PrusaSlicer,
          slicer != Slicer::PrusaSlicer};
}

/// Returns the middle of a box's lower side.
Vec3 foot(const Box3& box) { return {box.centre().x, box.centre().y, box.min.z}; }

/// Writes the text of one package.
class Package {
 public:
  Package(std::span<const ModelObject> objects, const WriteOptions& options)
      : numbering_(objects, options),
        options_(options),
        poses_(posesOnPlate(objects, options.slicer)),
        paint_(paintNames(options.slicer)) {}

  Result<std::vector<std::uint8_t>> write() {
    putTypesAndRelationships();
    putRoot();
    for (const NumberedObject& object : numbering_.objects)
      if (!object.path.empty()) putPartFile(object);
    if (numbering_.isColoured()) {
      const bool isForAny = options_.slicer == Slicer::Any;
      if (options_.slicer != Slicer::PrusaSlicer) putBambuSettings(numbering_.objects, zip_);
      if (isForAny || options_.slicer == Slicer::PrusaSlicer) putPrusaSettings(numbering_.objects, zip_);
      if (options_.palette) putBambuPalette(numbering_, zip_);
    }
    return zip_.finish();
  }

 private:
  bool hasColourGroups() const { return numbering_.isColoured() && options_.slicer != Slicer::PrusaSlicer; }
  bool namesBambu() const { return options_.palette && numbering_.isColoured(); }

  void putTypesAndRelationships() {
    zip_.begin("[Content_Types].xml");
    zip_.append(kXmlDeclaration);
    zip_.append(
        "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\n"
        " <Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\n"
        " <Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\n"
        " <Default Extension=\"config\" ContentType=\"application/xml\"/>\n"
        "</Types>\n");
    putRelationships("_rels/.rels", {"/3D/3dmodel.model"});
    if (!numbering_.hasPartFiles()) return;
    std::vector<std::string> paths;
    for (const NumberedObject& object : numbering_.objects)
      if (!object.path.empty()) paths.push_back(object.path);
    putRelationships("3D/_rels/3dmodel.model.rels", paths);
  }

  void putRelationships(std::string_view name, const std::vector<std::string>& targets) {
    PartText text(zip_, name);
    text.add(FMT_COMPILE("{}<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\n"),
             kXmlDeclaration);
    for (std::size_t i = 0; i < targets.size(); ++i)
      text.add(FMT_COMPILE(" <Relationship Target=\"{}\" Id=\"model{}\" "
                           "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>\n"),
               targets[i], i + 1);
    text.add(FMT_COMPILE("</Relationships>\n"));
    text.finish();
  }

  /// Writes `<model>` with the namespaces that the file needs.
  void beginModel(PartText& text, bool hasPaths) const {
    std::string spaces, required;
    if (hasColourGroups()) {
      spaces += fmt::format(" xmlns:m=\"{}\" xmlns:cura=\"{}\"", kMaterialSpace, kCuraSpace);
      required += "m";
    }
    if (hasPaths) {
      spaces += " xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\"";
      required += required.empty() ? "p" : " p";
    }
    if (numbering_.isColoured() && paint_.prusa) spaces += fmt::format(" xmlns:slic3rpe=\"{}\"", kPrusaSpace);
    if (namesBambu()) spaces += " xmlns:BambuStudio=\"http://schemas.bambulab.com/package/2021\"";
    text.add(FMT_COMPILE("{}<model unit=\"millimeter\" xml:lang=\"en-US\" "
                         "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"{}{}>\n"),
             kXmlDeclaration, spaces,
             required.empty() ? required : fmt::format(" requiredextensions=\"{}\"", required));
  }

  void putRoot() {
    PartText text(zip_, "3D/3dmodel.model");
    beginModel(text, numbering_.hasPartFiles());
    text.add(FMT_COMPILE(" <metadata name=\"Title\">{}</metadata>\n"), escapedXml(options_.title));
    if (namesBambu())
      text.add(FMT_COMPILE(" <metadata name=\"Application\">{}</metadata>\n"
                           " <metadata name=\"BambuStudio:3mfVersion\">1</metadata>\n"),
               kBambuIdentity);
    else
      text.add(FMT_COMPILE(" <metadata name=\"Application\">QRelief {}</metadata>\n"), kVersion);
    if (numbering_.hasPaint() && paint_.prusa)
      text.add(FMT_COMPILE(" <metadata name=\"slic3rpe:MmPaintingVersion\">1</metadata>\n"));
    text.add(FMT_COMPILE(" <resources>\n"));
    if (hasColourGroups()) putColourGroups(text);
    if (hasColourGroups() && options_.slicer == Slicer::Any) putMaterials(text);
    for (const NumberedObject& object : numbering_.objects) putObject(object, text);
    text.add(FMT_COMPILE(" </resources>\n <build>\n"));
    for (std::size_t i = 0; i < numbering_.objects.size(); ++i) putItem(numbering_.objects[i], poses_[i], text);
    text.add(FMT_COMPILE(" </build>\n</model>\n"));
    text.finish();
  }

  void putPartFile(const NumberedObject& object) {
    PartText text(zip_, object.path.substr(1));
    beginModel(text, true);
    text.add(FMT_COMPILE(" <resources>\n"));
    if (hasColourGroups()) putColourGroups(text);
    for (const NumberedBody& body : object.bodies) putBodies(body.id, body.name, std::span(&body, 1), text);
    text.add(FMT_COMPILE(" </resources>\n <build/>\n</model>\n"));
    text.finish();
  }

  /// OrcaSlicer keeps one colour of each group.
  void putColourGroups(PartText& text) const {
    for (std::size_t i = 0; i < numbering_.colours.size(); ++i) {
      const auto& [red, green, blue] = numbering_.colours[i];
      text.add(FMT_COMPILE("  <m:colorgroup id=\"{}\">\n   <m:color color=\"#{:02X}{:02X}{:02X}FF\"/>\n"
                           "  </m:colorgroup>\n"),
               i + 1, red, green, blue);
    }
  }

  /// Names the colours' materials. Bodies do not refer to them: Bambu Studio takes every `pid` for a colour group.
  void putMaterials(PartText& text) const {
    text.add(FMT_COMPILE("  <basematerials id=\"{}\">\n"), numbering_.materialsId);
    for (std::size_t i = 0; i < numbering_.colours.size(); ++i) {
      const auto& [red, green, blue] = numbering_.colours[i];
      text.add(FMT_COMPILE("   <base name=\"{}\" displaycolor=\"#{:02X}{:02X}{:02X}FF\"/>\n"),
               escapedXml(numbering_.materials[i]), red, green, blue);
    }
    text.add(FMT_COMPILE("  </basematerials>\n"));
  }

  void putObject(const NumberedObject& object, PartText& text) const {
    if (object.isInOneMesh) return putBodies(object.id, object.name, object.bodies, text);
    if (object.path.empty())
      for (const NumberedBody& body : object.bodies) putBodies(body.id, body.name, std::span(&body, 1), text);
    if (!object.hasComponents) return;
    text.add(FMT_COMPILE("  <object id=\"{}\" name=\"{}\" type=\"model\">\n   <components>\n"), object.id,
             escapedXml(object.name));
    const std::string path = object.path.empty() ? "" : fmt::format(" p:path=\"{}\"", object.path);
    for (const NumberedBody& body : object.bodies)
      text.add(FMT_COMPILE("    <component{} objectid=\"{}\"/>\n"), path, body.id);
    text.add(FMT_COMPILE("   </components>\n  </object>\n"));
  }

  /// Writes bodies as one mesh.
  void putBodies(std::size_t id, const std::string& name, std::span<const NumberedBody> bodies, PartText& text) const {
    const std::size_t filament = bodies.front().filament;
    text.add(FMT_COMPILE("  <object id=\"{}\" name=\"{}\" type=\"model\"{}>\n"), id, escapedXml(name),
             hasColourGroups() ? fmt::format(" pid=\"{}\" pindex=\"0\"", filament) : std::string());
    if (hasColourGroups()) text.addText(curaExtruder(filament, ""));
    text.add(FMT_COMPILE("   <mesh>\n    <vertices>\n"));
    for (const NumberedBody& body : bodies)
      for (const Vec3f& p : body.body->mesh.positions)
        text.add(FMT_COMPILE("     <vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n"), p.x, p.y, p.z);
    text.add(FMT_COMPILE("    </vertices>\n    <triangles>\n"));
    std::size_t first = 0;
    for (const NumberedBody& body : bodies) {
      putTriangles(body, first, text);
      first += body.body->mesh.positions.size();
    }
    text.add(FMT_COMPILE("    </triangles>\n   </mesh>\n  </object>\n"));
  }

  /// @param first  number of the body's first vertex
  void putTriangles(const NumberedBody& body, std::size_t first, PartText& text) const {
    const std::vector<Triangle>& triangles = body.body->mesh.triangles;
    const std::string paint = paintOf(body);
    std::span<const std::uint32_t> painted;
    if (body.body->paint) painted = body.body->paint->triangles;
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      const auto& [a, b, c] = triangles[t];
      const bool isPainted = !painted.empty() && painted.front() == t;
      if (isPainted) painted = painted.subspan(1);
      text.add(FMT_COMPILE("     <triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"{}/>\n"), first + a, first + b, first + c,
               isPainted ? std::string_view(paint) : std::string_view());
    }
  }

  /// Returns the attributes of the body's painted facets.
  std::string paintOf(const NumberedBody& body) const {
    if (body.paintFilament == 0) return {};
    const std::string code = filamentCode(static_cast<unsigned>(body.paintFilament));
    std::string attributes;
    if (paint_.prusa) attributes += fmt::format(" {}=\"{}\"", kPrusaPaint, code);
    if (paint_.bambu) attributes += fmt::format(" {}=\"{}\"", kBambuPaint, code);
    if (paint_.colourGroup) attributes += fmt::format(" pid=\"{}\" p1=\"0\"", body.paintFilament);
    return attributes;
  }

  void putItem(const NumberedObject& numbered, const Affine& pose, PartText& text) const {
    const std::string transform = pose == Affine() ? "" : fmt::format(" transform=\"{}\"", transformText(pose));
    if (numbered.object->description.empty())
      text.add(FMT_COMPILE("  <item objectid=\"{}\"{}/>\n"), numbered.id, transform);
    else
      text.add(FMT_COMPILE("  <item objectid=\"{}\"{}>\n   <metadatagroup><metadata name=\"Description\">{}</metadata>"
                           "</metadatagroup>\n  </item>\n"),
               numbered.id, transform, escapedXml(numbered.object->description));
  }

  ZipWriter zip_;
  Numbering numbering_;
  const WriteOptions& options_;
  std::vector<Affine> poses_;  // of the objects
  PaintNames paint_;
};

}  // namespace

Result<std::vector<std::uint8_t>> write3mf(std::span<const ModelObject> objects, const WriteOptions& options) {
  return Package(objects, options).write();
}

bool hasPalette(Slicer slicer) { return slicer == Slicer::OrcaSlicer || slicer == Slicer::BambuStudio; }

std::vector<Affine> posesOnPlate(std::span<const ModelObject> objects, Slicer slicer) {
  std::vector<Affine> poses;
  Box3 before, after;
  bool isTurned = false;
  for (const ModelObject& object : objects) {
    Affine pose = turnedUp(object.up);
    isTurned |= pose != Affine();
    pose.origin += object.offsetMm;
    for (const ModelBody& body : object.bodies)
      for (const Vec3f& p : body.mesh.positions) {
        before.add(Vec3(p) + object.offsetMm);
        after.add(pose(Vec3(p)));
      }
    poses.push_back(pose);
  }
  Vec3 move(0);
  if (hasPalette(slicer))
    move = Vec3(kPlateMiddleMm, kPlateMiddleMm, 0) - foot(after);
  else if (isTurned)
    move = Vec3(before.centre().x, before.centre().y, 0) - foot(after);
  for (Affine& pose : poses) pose.origin += move;
  return poses;
}

}  // namespace qrelief
