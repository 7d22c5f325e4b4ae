// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/three_mf/read_3mf.h"

#include <algorithm>
#include <map>
#include <optional>

#include "io/polygon_list.h"
#include "io/three_mf/colours.h"
#include "io/three_mf/model.h"
#include "io/three_mf/source.h"
#include "io/three_mf/volumes.h"
#include "io/three_mf/xml_reader.h"
#include "io/zip_archive.h"
#include "mesh/weld.h"
#include "message_codes/files.h"

namespace qrelief {
namespace {

constexpr std::string_view kRelationships = "_rels/.rels";
constexpr std::string_view kRelationshipSpace = "http://schemas.openxmlformats.org/package/2006/relationships";
constexpr std::string_view kStartPart = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
constexpr std::size_t kMaxParts = 4096;         // model parts of one package
constexpr std::size_t kMaxNesting = 32;         // nesting depth of components
constexpr std::size_t kMaxInstances = 100'000;  // number of objects after components are assembled
constexpr std::size_t kLongestTarget = 120;     // in messages

/// The targets of relationships of one type.
class RelationshipHandler : public XmlHandler {
 public:
  std::vector<std::string> targets;
  bool external = false;  ///< one of them is outside of the package

  Status startElement(const XmlElement& element) override {
    if (element.space != kRelationshipSpace || element.name != "Relationship") return {};
    if (element.attribute("Type") != kStartPart) return {};
    external |= element.attribute("TargetMode") == "External";
    targets.emplace_back(element.attribute("Target").value_or(""));
    return {};
  }
};

/// Returns true for "..", in any escaped form.
bool isParent(std::string_view segment) {
  const auto takeDot = [&segment] {
    for (const std::string_view dot : {".", "%2e", "%2E"})
      if (segment.starts_with(dot)) {
        segment.remove_prefix(dot.size());
        return true;
      }
    return false;
  };
  return takeDot() && takeDot() && segment.empty();
}

/// Returns a part's name as in the archive, from the target of a relationship or a `p:path`; empty if it leads
/// elsewhere.
std::optional<std::string> partName(std::string_view target) {
  std::vector<std::string_view> segments;
  if (target.find_first_of(":\\?#") != std::string_view::npos) return std::nullopt;
  while (!target.empty()) {
    const std::size_t end = std::min(target.find('/'), target.size());
    const std::string_view segment = target.substr(0, end);
    target.remove_prefix(std::min(end + 1, target.size()));
    if (segment.empty() || segment == ".") continue;
    if (isParent(segment)) {
      if (segments.empty()) return std::nullopt;
      segments.pop_back();
    } else {
      segments.push_back(segment);
    }
  }
  std::string name;
  for (const std::string_view segment : segments) name.append(name.empty() ? "" : "/").append(segment);
  return name.empty() ? std::nullopt : std::optional(name);
}

/// The model parts of a file, read on demand.
class Package {
 public:
  Package(ZipArchive archive, const ReadLimits& limits) : archive_(std::move(archive)), limits_(limits) {}

  /// Finds and reads the main model part of the package.
  /// @returns its name
  Result<std::string> readStart() {
    const ZipEntry* entry = archive_.find(kRelationships);
    if (!entry) return badInput(message<"3mf-no-relationships">());
    RelationshipHandler handler;
    Result<ZipStream> stream = open(*entry);
    QRELIEF_TRY(stream);
    QRELIEF_TRY(readXml(*stream, std::string(kRelationships), handler));
    if (handler.targets.empty()) return badInput(message<"3mf-no-start">());
    if (handler.targets.size() > 1)
      return badInput(message<"3mf-several-starts">(with::count<"count">(handler.targets.size())));
    const std::string& target = handler.targets.front();
    if (target.empty()) return badInput(message<"3mf-no-target">());
    const auto name = partName(target);
    if (handler.external || target.find(':') != std::string::npos)
      return badInput(message<"3mf-external">(with::quoted<"target">(excerpt(target, kLongestTarget))));
    if (!name) return badInput(message<"3mf-leaves-package">(with::quoted<"target">(excerpt(target, kLongestTarget))));
    QRELIEF_TRY(readModels(*name));
    return *name;
  }

  /// Reads a model part and all parts that its components and items need.
  Status readModels(const std::string& start) {
    std::vector<std::string> paths = {start};
    while (!paths.empty()) {
      const std::string name = std::move(paths.back());
      paths.pop_back();
      if (models_.count(name)) continue;
      if (models_.size() == kMaxParts) return badInput(message<"3mf-too-many-parts">(with::count<"limit">(kMaxParts)));
      Result<ThreeMfModel> model = readPart(name);
      QRELIEF_TRY(model);
      QRELIEF_TRY(resolvePaths(*model, name, paths));
      models_.emplace(name, std::move(*model));
    }
    return {};
  }

  const ThreeMfModel& model(const std::string& name) const { return models_.at(name); }

  ThreeMfVolumes volumes(std::vector<Message>& warnings) const {
    return readThreeMfVolumes(archive_, limits_.maxExpandedBytes - expanded_, warnings);
  }

  FilamentColours filamentColours() const { return {archive_, limits_.maxExpandedBytes - expanded_}; }

 private:
  Result<ZipStream> open(const ZipEntry& entry) {
    Result<ZipStream> stream = ZipStream::open(entry, limits_.maxExpandedBytes - expanded_);
    if (stream) expanded_ += entry.size;
    return stream;
  }

  Result<ThreeMfModel> readPart(const std::string& name) {
    const ZipEntry* entry = archive_.find(name);
    if (!entry) return badInput(message<"3mf-part-missing">(with::quoted<"part">(excerpt(name, kLongestTarget))));
    Result<ZipStream> stream = open(*entry);
    QRELIEF_TRY(stream);
    ReadLimits left = limits_;
    left.maxTriangles -= triangles_;
    Result<ThreeMfModel> model = readThreeMfModel(*stream, name, left);
    if (model)
      for (const auto& [id, object] : model->objects) triangles_ += object.triangles.size();
    return model;
  }

  /// Turns every path into the name of a part; an empty path becomes the part's own name.
  static Status resolvePaths(ThreeMfModel& model, const std::string& own, std::vector<std::string>& paths) {
    const auto resolve = [&](std::vector<ThreeMfInstance>& instances) -> Status {
      for (ThreeMfInstance& instance : instances) {
        if (instance.path.empty()) {
          instance.path = own;
          continue;
        }
        const auto name = partName(instance.path);
        if (!name)
          return badInput(message<"3mf-path-outside">(with::quoted<"part">(excerpt(own)),
                                                      with::index<"object">(instance.object),
                                                      with::quoted<"path">(excerpt(instance.path, kLongestTarget))));
        instance.path = *name;
        if (instance.path != own) paths.push_back(*name);
      }
      return {};
    };
    for (auto& [id, object] : model.objects) QRELIEF_TRY(resolve(object.components));
    return resolve(model.items);
  }

  ZipArchive archive_;
  const ReadLimits& limits_;
  std::map<std::string, ThreeMfModel> models_;
  std::uint64_t expanded_ = 0;
  std::size_t triangles_ = 0;
};

/// Total size of an object with all its components.
struct Extent {
  std::size_t triangles = 0, vertices = 0, instances = 1, nesting = 1;
};

/// Returns true if every edge of the mesh has an even number of triangles. Equal positions are one corner.
bool hasClosedMesh(const ThreeMfObject& object) {
  std::vector<Vec3f> points(object.positions.begin(), object.positions.end());
  const Welding welding = weldEqual(points);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Triangle& t : object.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      edges.push_back(std::minmax({welding.indexOf[t[k]], welding.indexOf[t[(k + 1) % 3]]}));
  std::sort(edges.begin(), edges.end());
  for (auto edge = edges.begin(), end = edge; edge != edges.end(); edge = end) {
    end = std::upper_bound(edge, edges.end(), *edge);
    if ((end - edge) % 2 != 0) return false;
  }
  return true;
}

/// Assembles the build's items.
class Builder {
 public:
  Builder(const Package& package, const ReadLimits& limits) : package_(package), limits_(limits) {}

  /// @param bytes  the file
  Result<PolygonSoup> build(const std::string& start, std::span<const std::uint8_t> bytes) {
    const ThreeMfModel& model = package_.model(start);
    soup_.format = "3MF";
    soup_.unitMm = model.unitMm;
    volumes_ = package_.volumes(soup_.warnings);
    filamentColours_ = package_.filamentColours();
    Extent total{0, 0, 0, 0};
    for (const ThreeMfInstance& item : model.items) {
      if (!find(item)) return objectMissing(item, start);
      if (whyNoModel(item)) continue;
      const Result<Extent> extent = measure(item, start);
      QRELIEF_TRY(extent);
      QRELIEF_TRY(add(total, *extent));
    }
    for (const ThreeMfInstance& item : model.items) addItem(item, model.unitMm);
    Result<PolygonSoup> soup = finish(model);
    if (soup)
      soup->source = std::make_shared<const ThreeMfSource>(ThreeMfSource{
          {bytes.begin(), bytes.end()}, start, model.unitMm, std::move(runs_), isPainted_, volumes_.plates});
    return soup;
  }

 private:
  using Key = std::pair<std::string, std::uint32_t>;

  Status add(Extent& total, const Extent& part) const {
    total.triangles += part.triangles;
    total.vertices += part.vertices;
    total.instances += part.instances;
    total.nesting = std::max(total.nesting, part.nesting + 1);
    if (total.triangles > limits_.maxTriangles || total.vertices > 3 * limits_.maxTriangles)
      return tooManyTriangles(limits_.maxTriangles);
    if (total.instances > kMaxInstances)
      return badInput(message<"3mf-too-many-instances">(with::count<"limit">(kMaxInstances)));
    if (total.nesting > kMaxNesting + 1) return nestedTooDeep();
    return {};
  }

  static tl::unexpected<Error> nestedTooDeep() {
    return badInput(message<"3mf-nested-too-deep">(with::count<"limit">(kMaxNesting)));
  }

  static tl::unexpected<Error> objectMissing(const ThreeMfInstance& instance, const std::string& asking) {
    return badInput(message<"3mf-object-missing">(with::quoted<"asking">(excerpt(asking)),
                                                  with::index<"object">(instance.object),
                                                  with::quoted<"part">(excerpt(instance.path))));
  }

  /// Measures an object before anything is multiplied, and checks the limits.
  /// @param asking  the part that refers to the object
  Result<Extent> measure(const ThreeMfInstance& instance, const std::string& asking) {
    const Key key{instance.path, instance.object};
    if (const auto known = extents_.find(key); known != extents_.end()) {
      if (known->second) return *known->second;
      return badInput(
          message<"3mf-circle">(with::index<"object">(instance.object), with::quoted<"part">(excerpt(instance.path))));
    }
    const ThreeMfObject* object = find(instance);
    if (!object) return objectMissing(instance, asking);
    if (object->isInSlices)
      return badInput(
          message<"3mf-slices">(with::index<"object">(instance.object), with::quoted<"part">(excerpt(instance.path))));
    if (object->isInBeams)
      return badInput(
          message<"3mf-beams">(with::index<"object">(instance.object), with::quoted<"part">(excerpt(instance.path))));
    withSlices_ += object->hasSlices;
    if (extents_.size() > kMaxInstances)
      return badInput(message<"3mf-too-many-objects">(with::count<"limit">(kMaxInstances)));
    extents_.emplace(key, std::nullopt);  // while it is open, to find circular references
    if (++depth_ > kMaxNesting) return nestedTooDeep();
    Extent total{object->triangles.size(), object->positions.size(), 1, 1};
    for (const ThreeMfInstance& component : object->components) {
      const Result<Extent> extent = measure(component, instance.path);
      if (!extent) return extent;
      QRELIEF_TRY(add(total, *extent));
    }
    --depth_;
    extents_[key] = total;
    return total;
  }

  const ThreeMfObject* find(const ThreeMfInstance& instance) const {
    const auto& objects = package_.model(instance.path).objects;
    const auto it = objects.find(instance.object);
    return it == objects.end() ? nullptr : &it->second;
  }

  void addItem(const ThreeMfInstance& item, double unitMm) {
    const ThreeMfObject& object = *find(item);
    const std::size_t number = items_++;
    if (auto why = whyNoModel(item)) {
      if (notModels_++ == 0) whyNot_ = std::move(*why);
      return;
    }
    itemType_ = object.type;
    if (object.type != "model" && oddlyTyped_++ == 0) oddType_ = object.type;
    const std::size_t first = soup_.triangles.size();
    ThreeMfRun run;
    run.item = number;
    run.itemObject = item.object;
    place(item, Affine(), unitMm, run);
    if (soup_.triangles.size() == first)
      ++empty_;
    else
      soup_.parts.push_back({object.name.empty() ? item.partNumber : object.name, first});
  }

  /// @param outer   transform of the referring part's coordinates
  /// @param unitMm  unit of the referring part
  /// @param run     says which item it is
  void place(const ThreeMfInstance& instance, const Affine& outer, double unitMm, ThreeMfRun run) {
    const ThreeMfObject& object = *find(instance);
    const double ownUnitMm = package_.model(instance.path).unitMm;
    Affine transform = outer.after(instance.transform);
    if (ownUnitMm != unitMm) {
      const double factor = ownUnitMm / unitMm;
      transform = transform.after({{factor, 0, 0}, {0, factor, 0}, {0, 0, factor}, Vec3(0)});
    }
    run.part = instance.path;
    run.object = instance.object;
    run.name = object.name;
    run.toFile = transform;
    run.mirrored = transform.determinant() < 0;
    addMesh(object, run);
    for (const ThreeMfInstance& component : object.components) {
      if (isModel(component, run.itemObject))
        place(component, transform, ownUnitMm, run);
      else
        ++modifiers_;
    }
  }

  /// Returns the reason why an item is no model to print; none for a model. FreeCAD calls closed bodies "surface".
  std::optional<Message> whyNoModel(const ThreeMfInstance& item) {
    const ThreeMfObject& object = *find(item);
    if (!item.isPrinted) return message<"3mf-not-printed">(with::index<"object">(item.object));
    if (!object.curaMesh.empty())
      return message<"3mf-cura-mesh">(with::index<"object">(item.object), with::term<"setting">(object.curaMesh));
    if (object.type == "model") return std::nullopt;
    if (object.type != "surface" && object.type != "other")
      return message<"3mf-type">(with::index<"object">(item.object), with::quoted<"type">(excerpt(object.type)));
    if (isClosed(item)) return std::nullopt;
    return message<"3mf-type-open">(with::index<"object">(item.object), with::quoted<"type">(excerpt(object.type)));
  }

  /// Returns true if the object and its components have closed meshes only.
  bool isClosed(const ThreeMfInstance& instance, std::size_t nesting = 0) {
    const ThreeMfObject* object = find(instance);
    if (!object || nesting > kMaxNesting) return false;
    const auto [known, isNew] = closed_.try_emplace({instance.path, instance.object}, false);  // false: a circle, too
    if (!isNew) return known->second;
    const bool isClosedMesh = object->triangles.empty() ? !object->components.empty() : hasClosedMesh(*object);
    return known->second =
               isClosedMesh && std::all_of(object->components.begin(), object->components.end(),
                                           [&](const ThreeMfInstance& c) { return isClosed(c, nesting + 1); });
  }

  /// Returns false for a component that slicers do not print. Bambu Studio calls modifiers "other".
  bool isModel(const ThreeMfInstance& component, std::uint32_t itemObject) {
    const std::string& type = find(component)->type;
    if (type != "model" && type != "surface" && type != itemType_) return false;
    return !whyNoModel(component) && !volumes_.notModels.count({itemObject, component.object});
  }

  /// Adds a mesh, except for the volumes that slicers do not print.
  void addMesh(const ThreeMfObject& object, const ThreeMfRun& run) {
    const std::size_t triangles = object.triangles.size();
    if (triangles == 0) return;
    isPainted_ |= object.isPainted;
    const auto known = volumes_.ranges.find(run.object);
    if (known == volumes_.ranges.end() || !divideMesh(known->second, triangles))
      return addTriangles(object, run, 0, triangles, partTraits(run));
    const std::vector<VolumeRange>& ranges = known->second;
    std::vector<std::size_t> volumeOf(triangles, ranges.size());  // ranges.size(): in no volume
    for (std::size_t v = 0; v < ranges.size(); ++v)
      std::fill(volumeOf.begin() + static_cast<std::ptrdiff_t>(ranges[v].first),
                volumeOf.begin() + static_cast<std::ptrdiff_t>(ranges[v].last + 1), v);
    for (std::size_t first = 0, end = 0; first < triangles; first = end) {
      for (end = first; end < triangles && volumeOf[end] == volumeOf[first];) ++end;
      const bool isInVolume = volumeOf[first] != ranges.size();
      if (!isInVolume || ranges[volumeOf[first]].isModel)
        addTriangles(object, run, first, end, isInVolume ? ranges[volumeOf[first]].traits : VolumeTraits());
      else
        ++modifiers_;
    }
  }

  /// Returns what Bambu Studio or OrcaSlicer says of a run's mesh as a part.
  VolumeTraits partTraits(const ThreeMfRun& run) const {
    const auto part = volumes_.parts.find({run.itemObject, run.object});
    return part == volumes_.parts.end() ? VolumeTraits() : part->second;
  }

  /// Adds triangles `first` to `end` of a mesh, with the positions that they need.
  void addTriangles(const ThreeMfObject& object, ThreeMfRun run, std::size_t first, std::size_t end,
                    const VolumeTraits& traits) {
    constexpr std::uint32_t kNowhere = 0xffffffffu;
    const bool isWhole = first == 0 && end == object.triangles.size();
    std::vector<std::uint32_t> place(object.positions.size(), kNowhere);
    const auto add = [&](std::uint32_t v) {
      if (place[v] == kNowhere) {
        place[v] = static_cast<std::uint32_t>(soup_.positions.size());
        soup_.positions.push_back(run.toFile(object.positions[v]));
      }
      return place[v];
    };
    if (isWhole)  // in the file's order, those that no triangle needs included
      for (std::uint32_t v = 0; v < object.positions.size(); ++v) add(v);
    run.firstTriangle = soup_.triangles.size();
    run.firstInMesh = first;
    run.count = end - first;
    runs_.push_back(run);
    soup_.bodyOf.insert(soup_.bodyOf.end(), end - first, static_cast<std::uint32_t>(soup_.bodies.size()));
    soup_.bodies.push_back({traits.name.empty() ? run.name : traits.name,
                            static_cast<std::uint32_t>(soup_.parts.size()), false, traits.filament});
    for (std::size_t t = first; t < end; ++t) {
      const auto& [a, b, c] = object.triangles[t];
      if (run.mirrored)
        soup_.triangles.push_back({add(a), add(c), add(b)});
      else
        soup_.triangles.push_back({add(a), add(b), add(c)});
      soup_.colours.push_back(colourOf(object, t, traits));
    }
  }

  /// Returns the colour of a triangle. Paint counts before the volume's filament, and both before the file's materials.
  std::optional<Colour> colourOf(const ThreeMfObject& object, std::size_t triangle, const VolumeTraits& traits) const {
    const std::uint32_t paint = triangle < object.paint.size() ? object.paint[triangle] : 0;
    const std::uint32_t filament = paint != 0 ? paint : traits.filament;
    if (filament != 0)
      if (const auto known = filamentColours_.of(filament)) return known;
    if (triangle < object.colours.size() && object.colours[triangle]) return object.colours[triangle];
    return filament != 0 ? std::optional(FilamentColours::standIn(filament)) : std::nullopt;
  }

  Result<PolygonSoup> finish(const ThreeMfModel& model) {
    if (notModels_ > 0)
      soup_.warnings.push_back(message<"3mf-items-not-models">(
          with::count<"count">(notModels_), with::count<"items">(model.items.size()), with::cause<"why">(whyNot_)));
    if (oddlyTyped_ > 0)
      soup_.warnings.push_back(
          message<"3mf-type-closed">(with::count<"count">(oddlyTyped_), with::quoted<"type">(excerpt(oddType_))));
    if (withSlices_ > 0) soup_.warnings.push_back(message<"3mf-slices-unused">(with::count<"count">(withSlices_)));
    if (modifiers_ > 0) soup_.warnings.push_back(message<"3mf-modifiers">(with::count<"count">(modifiers_)));
    if (empty_ > 0) soup_.warnings.push_back(message<"3mf-items-empty">(with::count<"count">(empty_)));
    if (!model.hasBuild) return badInput(message<"3mf-build-missing">(with::count<"count">(model.objects.size())));
    if (model.items.empty()) return badInput(message<"3mf-build-empty">(with::count<"count">(model.objects.size())));
    if (soup_.triangles.empty())
      return badInput(
          message<"3mf-no-triangle">(with::count<"count">(model.items.size()), with::cause<"why">(whyNot_)));
    for (const Vec3& p : soup_.positions)
      if (!(glm::length(p) < 1e300)) return badInput(message<"3mf-out-of-bounds">());
    if (soup_.bodies.size() < 2) soup_.bodyOf.clear();
    return std::move(soup_);
  }

  const Package& package_;
  const ReadLimits& limits_;
  std::map<Key, std::optional<Extent>> extents_;
  std::map<Key, bool> closed_;
  std::size_t depth_ = 0, items_ = 0, notModels_ = 0, modifiers_ = 0, empty_ = 0, oddlyTyped_ = 0, withSlices_ = 0;
  Message whyNot_ = message<"3mf-without-triangles">();  // why the first item that is no model is none
  std::string itemType_;                                 // of the item that is placed
  std::string oddType_;                                  // of the first closed mesh that is not called a model
  ThreeMfVolumes volumes_;
  FilamentColours filamentColours_;
  std::vector<ThreeMfRun> runs_;
  bool isPainted_ = false;
  PolygonSoup soup_;
};

}  // namespace

Result<PolygonSoup> read3mf(std::span<const std::uint8_t> bytes, const ReadLimits& limits) {
  Result<ZipArchive> archive = ZipArchive::open(bytes);
  QRELIEF_TRY(archive);
  Package package(std::move(*archive), limits);
  const Result<std::string> start = package.readStart();
  QRELIEF_TRY(start);
  return Builder(package, limits).build(*start, bytes);
}

}  // namespace qrelief
