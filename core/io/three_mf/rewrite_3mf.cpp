// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/three_mf/rewrite_3mf.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <limits>
#include <map>

#include "io/three_mf/filament_code.h"
#include "io/three_mf/mesh_text.h"
#include "io/three_mf/read_3mf.h"
#include "io/three_mf/rewritten_3mf.h"
#include "io/three_mf/settings.h"
#include "io/three_mf/text.h"
#include "io/three_mf/volumes.h"
#include "io/three_mf/xml_tags.h"
#include "io/zip_archive.h"
#include "io/zip_writer.h"
#include "message_codes/files.h"

namespace qrelief {
namespace {

constexpr std::string_view kContentTypes = "[Content_Types].xml";

tl::unexpected<Error> anew(Message why) { return fail(ErrorKind::NoSolution, std::move(why)); }

/// Unpacks an entry, however long, and passes it to use() piece by piece.
template <class Use>
Status unpack(const ZipEntry& entry, const Use& use) {
  auto stream = ZipStream::open(entry, std::numeric_limits<std::uint64_t>::max());
  QRELIEF_TRY(stream);
  for (;;) {
    const auto piece = stream->next();
    QRELIEF_TRY(piece);
    if (piece->empty()) return {};
    use(std::string_view(reinterpret_cast<const char*>(piece->data()), piece->size()));
  }
}

/// Writes one file again.
class Rewriter {
 public:
  Rewriter(const ThreeMfSource& source, std::span<const ChangedRun> changes, const std::array<Material, 2>& materials,
           ItemPose pose, ZipArchive archive)
      : source_(source), changes_(changes), materials_(materials), pose_(pose), archive_(std::move(archive)) {}

  Result<std::vector<std::uint8_t>> write(Slicer slicer) {
    if (isShared()) return anew(message<"rewrite-shared">());
    QRELIEF_TRY(load());
    QRELIEF_TRY(prepareSecondFilament(slicer));
    for (const auto& [mesh, changes] : byMesh()) QRELIEF_TRY(changeMesh(mesh, changes));
    if (pose_.pose != Affine() && !turnItem()) return anew(message<"rewrite-encoding">());
    return zipped();
  }

 private:
  using MeshKey = std::pair<std::string, std::uint32_t>;  // part, object
  /// Whose settings divide the changed mesh into bodies. Plain: the file has no settings of a slicer.
  enum class Family { None, Prusa, Bambu, Plain };

  const ThreeMfRun& runOf(const ChangedRun& change) const { return source_.runs[change.run]; }

  std::map<MeshKey, std::vector<const ChangedRun*>> byMesh() const {
    std::map<MeshKey, std::vector<const ChangedRun*>> meshes;
    for (const ChangedRun& change : changes_) meshes[{runOf(change).part, runOf(change).object}].push_back(&change);
    return meshes;
  }

  /// Returns true if a changed mesh is in the build more than once.
  bool isShared() const {
    for (const ChangedRun& change : changes_) {
      const ThreeMfRun& run = runOf(change);
      for (const ThreeMfRun& other : source_.runs)
        if (other.part == run.part && other.object == run.object &&
            (other.item != run.item || (&other != &run && other.firstInMesh == run.firstInMesh)))
          return true;
    }
    return false;
  }

  /// Unpacks the model parts and settings that may change.
  Status load() {
    std::vector<std::string> names = {source_.start, std::string(kBambuSettings), std::string(kPrusaSettings),
                                      std::string(kContentTypes)};
    for (const ChangedRun& change : changes_) names.push_back(runOf(change).part);
    for (const std::string& name : names) QRELIEF_TRY(load(archive_.find(name)));
    return {};
  }

  /// Unpacks all model parts, for an id that is new in the whole file: slicers look some up without their part.
  Status loadAllModels() {
    for (const ZipEntry* entry : archive_.files())
      if (entry->name.ends_with(".model")) QRELIEF_TRY(load(entry));
    return {};
  }

  /// Unpacks a part that is there and was not unpacked yet.
  Status load(const ZipEntry* entry) {
    if (!entry || texts_.count(entry)) return {};
    std::string& text = texts_[entry];
    const Status unpacked = unpack(*entry, [&](std::string_view piece) { text.append(piece); });
    QRELIEF_TRY(unpacked);
    if (text.starts_with("\xFE\xFF") || text.starts_with("\xFF\xFE") || text.find('\0') != std::string::npos)
      return anew(message<"rewrite-encoding">());
    return {};
  }

  /// Returns the text of a part; nullptr if there is none.
  const std::string* textOf(std::string_view name) const {
    const ZipEntry* entry = archive_.find(name);
    const auto it = entry ? texts_.find(entry) : texts_.end();
    return it == texts_.end() ? nullptr : &it->second;
  }

  void edit(std::string_view name, TextEdit edit) { edits_[archive_.find(name)].push_back(std::move(edit)); }

  /// Finds out who divides the mesh into bodies, and which filament is the second one.
  Status prepareSecondFilament(Slicer slicer) {
    const auto second = std::find_if(changes_.begin(), changes_.end(),
                                     [](const ChangedRun& c) { return c.inlay || !c.painted.empty(); });
    if (second == changes_.end()) return {};
    const ThreeMfRun& run = runOf(*second);
    const std::string* prusa = textOf(kPrusaSettings);
    const std::string* bambu = textOf(kBambuSettings);
    const auto volumes = prusa ? findElement(*prusa, "object", run.object) : std::nullopt;
    const auto parts = bambu ? findElement(*bambu, "object", run.itemObject) : std::nullopt;
    if (parts && run.itemObject != run.object) {
      family_ = Family::Bambu;
      const auto part = findElement(*bambu, "part", run.object, parts->inside, parts->insideEnd);
      const auto own = part ? metadataOf(*bambu, *part, "extruder") : std::nullopt;
      setFilament(own ? own : metadataOf(*bambu, *parts, "extruder"));
    } else if (volumes && textOf(run.part)->find("xmlns:slic3rpe") != std::string::npos) {
      family_ = Family::Prusa;
      setFilament(metadataOf(*prusa, *volumes, "extruder"));
    } else if (!prusa && !bambu && slicer == Slicer::Any && !hasColourGroups()) {
      family_ = Family::Plain;
      curaFilament_ = curaFilament(*textOf(run.part), run.object);
      return loadAllModels();
    } else {
      return anew(message<"rewrite-no-settings">());
    }
    const bool isForPrusa = slicer == Slicer::PrusaSlicer;
    if (slicer != Slicer::Any && isForPrusa != (family_ == Family::Prusa))
      return anew(message<"rewrite-other-slicer">());
    return {};
  }

  /// OrcaSlicer and Bambu Studio number filaments by the file's colour groups.
  bool hasColourGroups() const {
    for (const auto& [entry, text] : texts_)
      if (text.find("colorgroup") != std::string::npos) return true;
    return false;
  }

  void setFilament(std::optional<std::string_view> body) { filament_ = secondFilament(numberFrom(body)); }

  Status changeMesh(const MeshKey& key, const std::vector<const ChangedRun*>& changes) {
    const std::string* text = textOf(key.first);
    const auto mesh = text ? findMesh(*text, key.second) : std::nullopt;
    const auto last = std::prev(changes.end());
    if (!mesh || runOf(**last).firstInMesh + runOf(**last).count > mesh->triangles.size())
      return anew(message<"rewrite-encoding">());
    for (const MeshText::TriangleText& triangle : mesh->triangles)
      for (const std::uint32_t v : triangle.corners)
        if (v >= mesh->vertices.size()) return anew(message<"rewrite-encoding">());
    const ChangedRun* inlaid = nullptr;
    const ChangedRun* painted = nullptr;
    for (const ChangedRun* change : changes) {
      if (change->inlay) inlaid = change;
      if (!change->painted.empty()) painted = change;
    }
    std::size_t group = 0;
    if (family_ == Family::Plain && (inlaid || painted)) group = addMaterials(key);
    const PaintAttributes paint = painted ? paintAttributes(group) : PaintAttributes();
    edit(key.first, {mesh->begin, mesh->end, changedMesh(*mesh, source_, changes, paint, family_ == Family::Prusa)});
    changeObject(key, *changes.front());
    QRELIEF_TRY(moveRanges(key.second, changes, mesh->triangles.size(), inlaid));
    if (!inlaid || family_ == Family::Prusa) return {};
    return family_ == Family::Bambu ? addPart(*inlaid, *mesh) : addBody(*inlaid, *mesh, group);
  }

  /// Takes the slices away from an object whose shape changes: they show what it was before. A build item becomes of
  /// type "model": slicers print no others.
  void changeObject(const MeshKey& key, const ChangedRun& change) {
    const std::string_view text = *textOf(key.first);
    const std::size_t begin = findElement(text, "object", key.second)->begin;
    const bool isItem = runOf(change).object == runOf(change).itemObject;
    for (const XmlTag::Attribute& a : XmlTags(text.substr(begin)).next()->attributes())
      if (a.name.ends_with(":slicestackid") || a.name.ends_with(":meshresolution"))
        edit(key.first, {begin + a.begin, begin + a.end, ""});
      else if (isItem && a.name == "type" && a.value != "model")
        edit(key.first, {begin + a.valueBegin, begin + a.valueBegin + a.value.size(), "model"});
  }

  /// @param group  the code's colour group, of addMaterials()
  PaintAttributes paintAttributes(std::size_t group) const {
    const std::string code = filamentCode(filament_);
    const std::string prusa = fmt::format(" {}=\"{}\"", kPrusaPaint, code);
    const std::string bambu = fmt::format(" {}=\"{}\"", kBambuPaint, code);
    if (family_ == Family::Prusa) return {prusa, {}};
    if (family_ == Family::Bambu) return {bambu, {}};
    return {prusa + bambu + fmt::format(" pid=\"{}\" p1=\"0\"", group),
            fmt::format(" xmlns:slic3rpe=\"{}\"", kPrusaSpace)};
  }

  /// Adds a colour group for each of both materials, and their names. Gives an object the first group if it has no
  /// property yet. Nothing refers to the names: Bambu Studio takes every `pid` for a colour group.
  /// @returns the code's colour group
  std::size_t addMaterials(const MeshKey& key) {
    const std::string_view text = *textOf(key.first);
    const XmlSpan object = *findElement(text, "object", key.second);
    const XmlTag tag = *XmlTags(text.substr(object.begin)).next();
    const std::string_view prefix = prefixOf(tag);
    std::string groups, bases;
    std::array<std::size_t, 2> ids{};
    for (std::size_t i = 0; i < ids.size(); ++i) {
      ids[i] = nextId();
      const auto& [name, colour] = materials_[i];
      const std::string hex = fmt::format("#{:02X}{:02X}{:02X}FF", colour[0], colour[1], colour[2]);
      groups += fmt::format("<m:colorgroup xmlns:m=\"{}\" id=\"{}\"><m:color color=\"{}\"/></m:colorgroup>\n",
                            kMaterialSpace, ids[i], hex);
      bases += fmt::format("<{}base name=\"{}\" displaycolor=\"{}\"/>", prefix, escapedXml(name), hex);
    }
    edit(key.first,
         {object.begin, object.begin,
          groups + fmt::format("<{0}basematerials id=\"{1}\">{2}</{0}basematerials>\n", prefix, nextId(), bases)});
    const std::size_t end = object.begin + tag.raw.size() - 1;
    if (!tag.attribute("pid")) edit(key.first, {end, end, fmt::format(" pid=\"{}\" pindex=\"0\"", ids[0])});
    return ids[1];
  }

  /// Moves the ranges of PrusaSlicer's volumes of a mesh, and adds the inlay as a volume.
  /// @param triangles  of the mesh, before
  Status moveRanges(std::uint32_t object, const std::vector<const ChangedRun*>& changes, std::size_t triangles,
                    const ChangedRun* inlaid) {
    const std::string* text = textOf(kPrusaSettings);
    const auto element = text ? findElement(*text, "object", object) : std::nullopt;
    if (!element) return {};
    /// Returns the new number of the first or last triangle of a volume.
    const auto newNumber = [&](std::size_t triangle, bool isLast) {
      std::size_t result = triangle;
      for (const ChangedRun* change : changes) {
        const ThreeMfRun& run = runOf(*change);
        const std::size_t end = run.firstInMesh + run.count;
        if (end <= triangle + (isLast ? 1 : 0)) result += change->mesh.triangles.size() - run.count;
      }
      return result;
    };
    std::vector<VolumeRange> ranges;
    XmlTags tags(*text);
    while (const auto tag = tags.next()) {
      if (tag->begin < element->inside || tag->begin >= element->insideEnd || !tag->starts("volume")) continue;
      ranges.push_back({numberFrom(tag->attribute("firstid")), numberFrom(tag->attribute("lastid"))});
      for (const XmlTag::Attribute& a : tag->attributes())
        if (a.name == "firstid" || a.name == "lastid")
          edit(kPrusaSettings, {a.valueBegin, a.valueBegin + a.value.size(),
                                std::to_string(newNumber(numberFrom(a.value), a.name == "lastid"))});
    }
    if (!divideMesh(ranges, triangles)) return anew(message<"rewrite-encoding">());
    if (!inlaid || family_ != Family::Prusa) return {};
    const std::size_t first = newNumber(triangles, false);
    edit(kPrusaSettings, {element->insideEnd, element->insideEnd,
                          fmt::format(" <volume firstid=\"{}\" lastid=\"{}\">\n"
                                      "   <metadata type=\"volume\" key=\"name\" value=\"{}\"/>\n"
                                      "   <metadata type=\"volume\" key=\"volume_type\" value=\"ModelPart\"/>\n"
                                      "   <metadata type=\"volume\" key=\"extruder\" value=\"{}\"/>\n  </volume>\n ",
                                      first, first + inlaid->inlay->mesh.triangles.size() - 1,
                                      escapedXml(inlaid->inlay->name), filament_)});
    return {};
  }

  /// Adds a component to the item's object, after the component of a run's mesh. The item's object is in the start
  /// part. Older versions of Bambu Studio write it into the mesh's own part.
  /// @returns false if the item's object does not have the mesh as a component
  bool addComponent(const ThreeMfRun& run, std::size_t id) {
    for (const std::string& name : {source_.start, run.part}) {
      const std::string& text = *textOf(name);
      const auto object = findElement(text, "object", run.itemObject);
      if (!object) continue;
      for (XmlTags tags(text); const auto tag = tags.next();) {
        if (tag->begin < object->inside || tag->end > object->insideEnd || !tag->starts("component") ||
            numberFrom(tag->attribute("objectid")) != run.object)
          continue;
        std::vector<TextEdit> changed;
        for (const XmlTag::Attribute& a : tag->attributes())
          if (a.name == "objectid")
            changed.push_back(
                {a.valueBegin - tag->begin, a.valueBegin - tag->begin + a.value.size(), std::to_string(id)});
        std::size_t after = tag->end;
        if (!tag->isEmpty) after = text.find('>', tag->end) + 1;
        const std::string copy = edited(text.substr(tag->begin, after - tag->begin), std::move(changed));
        edit(name, {after, after, "\n" + withOwnUuid(copy, id)});
        return true;
      }
    }
    return false;
  }

  /// Returns an element with its first UUID changed, if its first tag has one.
  static std::string withOwnUuid(const std::string& element, std::size_t id) {
    const auto tag = XmlTags(element).next();
    for (const XmlTag::Attribute& a : tag->attributes())
      if (a.name.ends_with(":UUID") && a.value.size() > 8)
        return edited(element, {{a.valueBegin, a.valueBegin + 8, fmt::format("{:08x}", id)}});
    return element;
  }

  /// Adds the inlay as an object behind a component, and as a part of Bambu Studio's settings.
  Status addPart(const ChangedRun& change, const MeshText& body) {
    const ThreeMfRun& run = runOf(change);
    const std::size_t id = nextId();
    if (!addComponent(run, id)) return anew(message<"rewrite-no-settings">());
    edit(run.part, {body.objectEnd, body.objectEnd,
                    fmt::format("\n<{0}object id=\"{1}\" type=\"model\">\n{2}</{0}object>", body.prefix, id,
                                wholeMesh(change.inlay->mesh, run, source_.unitMm, body.prefix))});
    const std::string& settings = *textOf(kBambuSettings);
    const XmlSpan object = *findElement(settings, "object", run.itemObject);
    const auto part = findElement(settings, "part", run.object, object.inside, object.insideEnd);
    const auto matrix = part ? metadataOf(settings, *part, "matrix") : std::nullopt;
    const std::size_t at = part ? part->end : object.insideEnd;
    edit(kBambuSettings,
         {at, at,
          fmt::format("\n    <part id=\"{}\" subtype=\"normal_part\">\n      <metadata key=\"name\" value=\"{}\"/>\n{}"
                      "      <metadata key=\"extruder\" value=\"{}\"/>\n    </part>\n",
                      id, escapedXml(change.inlay->name),
                      matrix ? fmt::format("      <metadata key=\"matrix\" value=\"{}\"/>\n", *matrix) : "",
                      filament_)});
    return {};
  }

  /// Adds the inlay as an object to a file without settings, and the settings of all slicers. If the item is the mesh
  /// itself, it becomes an object with two components.
  Status addBody(const ChangedRun& change, const MeshText& body, std::size_t group) {
    const ThreeMfRun& run = runOf(change);
    const std::string_view text = *textOf(run.part);
    const std::size_t start = findElement(text, "object", run.object)->begin;
    const XmlTag tag = *XmlTags(text.substr(start)).next();
    const std::string name = run.name.empty() ? materials_[0].name : run.name;
    std::string uuid;
    for (const XmlTag::Attribute& a : tag.attributes())
      if (a.name.ends_with(":UUID")) uuid = fmt::format(" {}=\"{}\"", a.name, a.value);
    const std::size_t inlay = nextId();
    std::size_t whole = run.itemObject;
    std::string objects = withOwnUuid(
        fmt::format("<{0}object id=\"{1}\" type=\"model\" name=\"{2}\" pid=\"{3}\" pindex=\"0\" xmlns:cura=\"{4}\"{5}>"
                    "\n{6}{7}</{0}object>",
                    body.prefix, inlay, escapedXml(change.inlay->name), group, kCuraSpace, uuid,
                    curaExtruder(secondFilament(curaFilament_), body.prefix),
                    wholeMesh(change.inlay->mesh, run, source_.unitMm, body.prefix)),
        inlay);
    if (whole == run.object) {
      whole = nextId();
      const auto component = [&](std::size_t object, std::size_t own) {
        return withOwnUuid(fmt::format("<{}component objectid=\"{}\"{}/>", body.prefix, object, uuid), own);
      };
      objects += "\n" + withOwnUuid(fmt::format("<{0}object id=\"{1}\" type=\"model\" name=\"{2}\"{3}>"
                                                "<{0}components>{4}{5}</{0}components></{0}object>",
                                                body.prefix, whole, escapedXml(name), uuid,
                                                component(run.object, whole + 1), component(inlay, whole + 2)),
                                    whole);
      if (!pointItemTo(run, whole)) return anew(message<"rewrite-encoding">());
    } else if (!addComponent(run, inlay)) {
      return anew(message<"rewrite-no-settings">());
    }
    edit(run.part, {body.objectEnd, body.objectEnd, "\n" + objects});
    newBodies_ = {{name, change.mesh, {}}, *change.inlay};
    newObject_.emplace();
    newObject_->name = name;
    newObject_->id = whole;
    newObject_->bodies = {{&newBodies_[0], name, run.object, curaFilament_, 0},
                          {&newBodies_[1], change.inlay->name, inlay, secondFilament(curaFilament_), 0}};
    declareSettings();
    return {};
  }

  /// Returns the tag of a build item.
  std::optional<XmlTag> tagOfItem(std::size_t item) const {
    for (XmlTags tags(*textOf(source_.start)); const auto tag = tags.next();)
      if (tag->starts("item") && item-- == 0) return tag;
    return {};
  }

  /// Makes a run's build item an item of another object of the same part. @returns false if the item is not found
  bool pointItemTo(const ThreeMfRun& run, std::size_t object) {
    const auto tag = tagOfItem(run.item);
    if (!tag) return false;
    for (const XmlTag::Attribute& a : tag->attributes())
      if (a.name == "objectid" && numberFrom(a.value) == run.itemObject) {
        edit(source_.start, {a.valueBegin, a.valueBegin + a.value.size(), std::to_string(object)});
        return true;
      }
    return false;
  }

  /// Turns the item of `pose_`. @returns false if the item is not found
  bool turnItem() {
    const auto tag = tagOfItem(pose_.item);
    if (!tag) return false;
    Affine pose = pose_.pose;
    pose.origin /= source_.unitMm;
    for (const XmlTag::Attribute& a : tag->attributes()) {
      if (a.name != "transform") continue;
      const auto before = transformFrom(a.value);
      if (!before) return false;
      edit(source_.start, {a.valueBegin, a.valueBegin + a.value.size(), transformText(pose.after(*before))});
      return true;
    }
    const std::size_t end = tag->end - (tag->isEmpty ? 2 : 1);
    edit(source_.start, {end, end, fmt::format(" transform=\"{}\"", transformText(pose))});
    return true;
  }

  /// Declares the content type of settings, as OPC requires of every part.
  void declareSettings() {
    const std::string* types = textOf(kContentTypes);
    if (!types) return;
    for (XmlTags tags(*types); const auto tag = tags.next();) {
      if (tag->starts("Default") && tag->attribute("Extension") == "config") return;
      if (tag->ends("Types"))
        edit(kContentTypes,
             {tag->begin, tag->begin,
              fmt::format("<{}Default Extension=\"config\" ContentType=\"application/xml\"/>\n", prefixOf(*tag))});
    }
  }

  /// Returns an id that nothing has.
  std::size_t nextId() {
    if (largestId_ == 0)
      for (const auto& [entry, text] : texts_)
        for (XmlTags tags(text); const auto tag = tags.next();)
          largestId_ = std::max(largestId_, numberFrom(tag->attribute("id")));
    return ++largestId_;
  }

  Result<std::vector<std::uint8_t>> zipped() {
    ZipWriter zip;
    for (const ZipEntry* entry : archive_.files()) {
      zip.begin(entry->name);
      if (const auto edits = edits_.find(entry); edits != edits_.end()) {
        zip.append(edited(texts_.at(entry), edits->second));
        continue;
      }
      const Status unpacked = unpack(*entry, [&](std::string_view piece) { zip.append(piece); });
      QRELIEF_TRY(unpacked);
    }
    if (newObject_) {
      putBambuSettings(std::span(&*newObject_, 1), zip);
      putPrusaSettings(std::span(&*newObject_, 1), zip);
    }
    return zip.finish();
  }

  const ThreeMfSource& source_;
  std::span<const ChangedRun> changes_;
  const std::array<Material, 2>& materials_;
  ItemPose pose_;
  ZipArchive archive_;
  std::map<const ZipEntry*, std::string> texts_;
  std::map<const ZipEntry*, std::vector<TextEdit>> edits_;
  Family family_ = Family::None;
  unsigned filament_ = 2;
  std::size_t curaFilament_ = 1;  // of the body with the code
  std::size_t largestId_ = 0;
  std::vector<ModelBody> newBodies_;         ///< of newObject_
  std::optional<NumberedObject> newObject_;  ///< for the settings of a file that had none
};

}  // namespace

Result<std::vector<std::uint8_t>> rewrite3mf(const ThreeMfSource& source, std::span<const ChangedRun> changes,
                                             Slicer slicer, const std::array<Material, 2>& materials, Vec3 up) {
  Result<ZipArchive> archive = ZipArchive::open(source.bytes);
  QRELIEF_TRY(archive);
  const auto before = read3mf(source.bytes, {});
  if (!before) return anew(message<"rewrite-read-differently">());
  const ItemPose turned = turnedItem(source, changes, *before, up);
  auto bytes = Rewriter(source, changes, materials, turned, std::move(*archive)).write(slicer);
  if (!bytes) return bytes;
  const auto read = read3mf(*bytes, {});
  if (!read || !holdsChanges(*read, *before, source, changes, turned))
    return anew(message<"rewrite-read-differently">());
  return bytes;
}

}  // namespace qrelief
