// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/rewrite_3mf.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>

#include "io/filament_code.h"
#include "io/read_3mf.h"
#include "io/three_mf_mesh_text.h"
#include "io/three_mf_text.h"
#include "io/three_mf_volumes.h"
#include "io/xml_tags.h"
#include "io/zip_archive.h"
#include "io/zip_writer.h"

namespace qrelief {
namespace {

tl::unexpected<Error> anew(Message why) { return fail(ErrorKind::NoSolution, std::move(why)); }

std::size_t numberFrom(std::optional<std::string_view> text) {
  std::size_t number = 0;
  if (text) std::from_chars(text->data(), text->data() + text->size(), number);
  return number;
}

/// An element of a slicer's model settings, from its first to after its last tag.
struct Element {
  std::size_t begin = 0, inside = 0, insideEnd = 0, end = 0;
};

/// Finds the element of a name and id at or after `from`, and before `to`. Such elements do not nest.
std::optional<Element> findElement(std::string_view text, std::string_view name, std::size_t id, std::size_t from = 0,
                                   std::size_t to = std::string_view::npos) {
  XmlTags tags(text.substr(0, to));
  std::optional<Element> element;
  while (const auto tag = tags.next()) {
    if (tag->begin < from) continue;
    if (!element && tag->starts(name) && numberFrom(tag->attribute("id")) == id) {
      element = Element{tag->begin, tag->end, tag->end, tag->end};
      if (tag->isEmpty) return element;
    } else if (element && tag->ends(name)) {
      element->insideEnd = tag->begin;
      element->end = tag->end;
      return element;
    }
  }
  return std::nullopt;
}

/// Returns the value of an element's own metadata: before the first part or volume in it.
std::optional<std::string_view> metadataOf(std::string_view text, const Element& element, std::string_view key) {
  XmlTags tags(text.substr(element.inside, element.insideEnd - element.inside));
  while (const auto tag = tags.next()) {
    if (tag->starts("part") || tag->starts("volume")) break;
    if (tag->starts("metadata") && tag->attribute("key") == key) return tag->attribute("value");
  }
  return std::nullopt;
}

/// Unpacks an entry, however long, and passes it to use() piece by piece.
template <class Use>
Status unpack(const ZipEntry& entry, const Use& use) {
  auto stream = ZipStream::open(entry, std::numeric_limits<std::uint64_t>::max());
  if (!stream) return tl::unexpected(stream.error());
  for (;;) {
    const auto piece = stream->next();
    if (!piece) return tl::unexpected(piece.error());
    if (piece->empty()) return {};
    use(std::string_view(reinterpret_cast<const char*>(piece->data()), piece->size()));
  }
}

/// Writes one file again.
class Rewriter {
 public:
  Rewriter(const ThreeMfSource& source, std::span<const ChangedRun> changes, ZipArchive archive)
      : source_(source), changes_(changes), archive_(std::move(archive)) {}

  Result<std::vector<std::uint8_t>> write(Slicer slicer) {
    if (isShared()) return anew(message("rewrite-shared"));
    if (const Status loaded = load(); !loaded) return tl::unexpected(loaded.error());
    if (const Status prepared = prepareSecondFilament(slicer); !prepared) return tl::unexpected(prepared.error());
    for (const auto& [mesh, changes] : byMesh())
      if (const Status done = changeMesh(mesh, changes); !done) return tl::unexpected(done.error());
    return zipped();
  }

 private:
  using MeshKey = std::pair<std::string, std::uint32_t>;  // part, object
  enum class Family { None, Prusa, Bambu };

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
    std::vector<std::string> names = {source_.start, std::string(kBambuSettings), std::string(kPrusaSettings)};
    for (const ChangedRun& change : changes_) names.push_back(runOf(change).part);
    for (const std::string& name : names) {
      const ZipEntry* entry = archive_.find(name);
      if (!entry || texts_.count(entry)) continue;
      std::string& text = texts_[entry];
      const Status unpacked = unpack(*entry, [&](std::string_view piece) { text.append(piece); });
      if (!unpacked) return tl::unexpected(unpacked.error());
      if (text.starts_with("\xFE\xFF") || text.starts_with("\xFF\xFE") || text.find('\0') != std::string::npos)
        return anew(message("rewrite-encoding"));
    }
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
    } else {
      return anew(message("rewrite-no-settings"));
    }
    const bool isForPrusa = slicer == Slicer::PrusaSlicer;
    if (slicer != Slicer::Any && isForPrusa != (family_ == Family::Prusa)) return anew(message("rewrite-other-slicer"));
    return {};
  }

  void setFilament(std::optional<std::string_view> body) { filament_ = numberFrom(body) == 2 ? 1 : 2; }

  Status changeMesh(const MeshKey& key, const std::vector<const ChangedRun*>& changes) {
    const std::string* text = textOf(key.first);
    const auto mesh = text ? findMesh(*text, key.second) : std::nullopt;
    const auto last = std::prev(changes.end());
    if (!mesh || runOf(**last).firstInMesh + runOf(**last).count > mesh->triangles.size())
      return anew(message("rewrite-encoding"));
    for (const MeshText::TriangleText& triangle : mesh->triangles)
      for (const std::uint32_t v : triangle.corners)
        if (v >= mesh->vertices.size()) return anew(message("rewrite-encoding"));
    std::optional<PaintAttribute> paint;
    if (family_ != Family::None)
      paint = PaintAttribute{family_ == Family::Prusa ? kPrusaPaint : kBambuPaint, filamentCode(filament_)};
    edit(key.first, {mesh->begin, mesh->end, changedMesh(*mesh, source_, changes, paint, family_ == Family::Prusa)});
    const ChangedRun* inlaid = nullptr;
    for (const ChangedRun* change : changes)
      if (change->inlay) inlaid = change;
    moveRanges(key.second, changes, mesh->triangles.size(), inlaid);
    if (inlaid && family_ == Family::Bambu) return addPart(*inlaid, *mesh);
    return {};
  }

  /// Moves the ranges of PrusaSlicer's volumes of a mesh, and adds the inlay as a volume.
  /// @param triangles  of the mesh, before
  void moveRanges(std::uint32_t object, const std::vector<const ChangedRun*>& changes, std::size_t triangles,
                  const ChangedRun* inlaid) {
    const std::string* text = textOf(kPrusaSettings);
    const auto element = text ? findElement(*text, "object", object) : std::nullopt;
    if (!element) return;
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
    XmlTags tags(*text);
    while (const auto tag = tags.next()) {
      if (tag->begin < element->inside || tag->begin >= element->insideEnd || !tag->starts("volume")) continue;
      for (const XmlTag::Attribute& a : tag->attributes())
        if (a.name == "firstid" || a.name == "lastid")
          edit(kPrusaSettings, {a.valueBegin, a.valueBegin + a.value.size(),
                                std::to_string(newNumber(numberFrom(a.value), a.name == "lastid"))});
    }
    if (!inlaid || family_ != Family::Prusa) return;
    const std::size_t first = newNumber(triangles, false);
    edit(kPrusaSettings, {element->insideEnd, element->insideEnd,
                          fmt::format(" <volume firstid=\"{}\" lastid=\"{}\">\n"
                                      "   <metadata type=\"volume\" key=\"name\" value=\"{}\"/>\n"
                                      "   <metadata type=\"volume\" key=\"volume_type\" value=\"ModelPart\"/>\n"
                                      "   <metadata type=\"volume\" key=\"extruder\" value=\"{}\"/>\n  </volume>\n ",
                                      first, first + inlaid->inlay->mesh.triangles.size() - 1,
                                      escapedXml(inlaid->inlay->name), filament_)});
  }

  /// Adds the inlay as an object behind a component, and as a part of Bambu Studio's settings.
  Status addPart(const ChangedRun& change, const MeshText& body) {
    const ThreeMfRun& run = runOf(change);
    const std::size_t id = nextId();
    const std::string& root = *textOf(source_.start);
    const auto item = findElement(root, "object", run.itemObject);
    std::optional<XmlTag> component;
    for (XmlTags tags(root); const auto tag = tags.next();)
      if (item && tag->begin >= item->inside && tag->end <= item->insideEnd && tag->starts("component") &&
          numberFrom(tag->attribute("objectid")) == run.object)
        component = tag;
    if (!component) return anew(message("rewrite-no-settings"));
    std::vector<TextEdit> changed;
    for (const XmlTag::Attribute& a : component->attributes()) {
      const std::size_t at = a.valueBegin - component->begin;
      if (a.name == "objectid") changed.push_back({at, at + a.value.size(), std::to_string(id)});
      if (a.name.ends_with(":UUID") && a.value.size() > 8) changed.push_back({at, at + 8, fmt::format("{:08x}", id)});
    }
    std::size_t after = component->end;
    if (!component->isEmpty) after = root.find('>', component->end) + 1;
    edit(source_.start,
         {after, after, "\n" + edited(root.substr(component->begin, after - component->begin), changed)});
    edit(run.part, {body.objectEnd, body.objectEnd,
                    fmt::format("\n<{0}object id=\"{1}\" type=\"model\">\n{2}</{0}object>", body.prefix, id,
                                wholeMesh(change.inlay->mesh, run, source_.unitMm, body.prefix))});
    const std::string& settings = *textOf(kBambuSettings);
    const Element object = *findElement(settings, "object", run.itemObject);
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

  /// Returns an id that nothing has.
  std::size_t nextId() const {
    std::size_t largest = 0;
    for (const auto& [entry, text] : texts_)
      for (XmlTags tags(text); const auto tag = tags.next();)
        largest = std::max(largest, numberFrom(tag->attribute("id")));
    return largest + 1;
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
      if (!unpacked) return tl::unexpected(unpacked.error());
    }
    return zip.finish();
  }

  const ThreeMfSource& source_;
  std::span<const ChangedRun> changes_;
  ZipArchive archive_;
  std::map<const ZipEntry*, std::string> texts_;
  std::map<const ZipEntry*, std::vector<TextEdit>> edits_;
  Family family_ = Family::None;
  unsigned filament_ = 2;
};

/// Returns true if `read` is `expected` after a transform and its inverse, up to the last digit of a 32-bit float.
bool isEqual(Vec3 read, Vec3 expected, Vec3 offset) {
  for (int axis = 0; axis < 3; ++axis) {
    const double largest = std::max({std::abs(expected[axis]), std::abs(offset[axis]), 1e-30});
    if (!(std::abs(read[axis] - expected[axis]) <= std::numeric_limits<float>::epsilon() * largest)) return false;
  }
  return true;
}

/// Compares what the new file holds with what it must hold.
bool isRight(const PolygonSoup& read, const PolygonSoup& before, const ThreeMfSource& source,
             std::span<const ChangedRun> changes) {
  std::size_t at = 0;
  const auto isNext = [&](const Mesh& mesh, Vec3 offset) {
    if (read.triangles.size() - at < mesh.triangles.size()) return false;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t, ++at)
      for (std::size_t k = 0; k < 3; ++k)
        if (!isEqual(read.positions[read.triangles[at][k]] * source.unitMm, Vec3(mesh.corner(t, static_cast<int>(k))),
                     offset * source.unitMm))
          return false;
    return true;
  };
  for (std::size_t r = 0; r < source.runs.size(); ++r) {
    const ThreeMfRun& run = source.runs[r];
    const auto change = std::find_if(changes.begin(), changes.end(), [&](const ChangedRun& c) { return c.run == r; });
    if (change != changes.end()) {
      if (!isNext(change->mesh, run.toFile.origin)) return false;
    } else {
      if (read.triangles.size() - at < run.count) return false;
      for (std::size_t t = run.firstTriangle; t < run.firstTriangle + run.count; ++t, ++at)
        for (std::size_t k = 0; k < 3; ++k)
          if (read.positions[read.triangles[at][k]] != before.positions[before.triangles[t][k]]) return false;
    }
    // An inlay follows the mesh that it belongs to.
    const bool endsMesh = r + 1 == source.runs.size() || source.runs[r + 1].object != run.object ||
                          source.runs[r + 1].part != run.part || source.runs[r + 1].item != run.item;
    if (!endsMesh) continue;
    for (const ChangedRun& c : changes)
      if (c.inlay && source.runs[c.run].object == run.object && source.runs[c.run].part == run.part)
        if (!isNext(c.inlay->mesh, run.toFile.origin)) return false;
  }
  return at == read.triangles.size();
}

}  // namespace

Result<std::vector<std::uint8_t>> rewrite3mf(const ThreeMfSource& source, std::span<const ChangedRun> changes,
                                             Slicer slicer) {
  Result<ZipArchive> archive = ZipArchive::open(source.bytes);
  if (!archive) return tl::unexpected(archive.error());
  auto bytes = Rewriter(source, changes, std::move(*archive)).write(slicer);
  if (!bytes) return bytes;
  const auto before = read3mf(source.bytes, {}), read = read3mf(*bytes, {});
  if (!before || !read || !isRight(*read, *before, source, changes)) return anew(message("rewrite-read-differently"));
  return bytes;
}

}  // namespace qrelief
