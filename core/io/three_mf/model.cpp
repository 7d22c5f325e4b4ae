// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/three_mf/model.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/parse_number.h"
#include "io/polygon_list.h"
#include "io/text_scanner.h"
#include "io/three_mf/colours.h"
#include "io/three_mf/filament_code.h"
#include "math/box.h"
#include "message_codes/files.h"

namespace qrelief {
namespace {

constexpr std::string_view kCore = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
constexpr std::string_view kProduction = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";
constexpr std::string_view kMaterial = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02";
constexpr std::string_view kTriangleSets = "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07";
constexpr std::string_view kSlice = "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07";
constexpr std::size_t kLongestUri = 120, kLongestTransform = 120;  // in messages
constexpr std::size_t kMaxEntries = 100'000;                       // objects, components and items of one part
constexpr std::size_t kObjectDepth = 3;                            // of an object's element: model, resources, object

struct Unit {
  std::string_view name;
  double mm;
};
constexpr std::array<Unit, 6> kUnits = {
    {{"micron", 0.001}, {"millimeter", 1}, {"centimeter", 10}, {"inch", 25.4}, {"foot", 304.8}, {"meter", 1000}}};

/// Cura's settings that make an object a helper mesh, which is not printed as it is.
constexpr std::array<std::string_view, 4> kCuraMeshes = {"support_mesh", "anti_overhang_mesh", "infill_mesh",
                                                         "cutting_mesh"};
constexpr std::string_view kCuraPrefix = "cura:";
constexpr std::string_view kPrusaPaintName = kPrusaPaint.substr(kPrusaPaint.find(':') + 1);
constexpr std::size_t kLongestSwitch = 16;  // "True", with blanks
constexpr std::size_t kCorners = 3;         // attributes that every triangle has

/// Returns the value of a boolean of XML, or of Python; none for anything else.
std::optional<bool> switchFrom(std::string_view text) {
  const std::string_view word = withoutBlanks(text);
  if (word == "1" || word == "true" || word == "True") return true;
  if (word == "0" || word == "false" || word == "False") return false;
  return std::nullopt;
}

/// Returns true if the mesh has vertices and all are corners of its bounding box.
bool isBox(const ThreeMfObject& object) {
  Box3 box;
  for (const Vec3& p : object.positions) box.add(p);
  return !object.positions.empty() && std::all_of(object.positions.begin(), object.positions.end(), [&](Vec3 p) {
    return (p.x == box.min.x || p.x == box.max.x) && (p.y == box.min.y || p.y == box.max.y) &&
           (p.z == box.min.z || p.z == box.max.z);
  });
}

/// Returns true if the element of a triangle says how the facet is painted.
bool isPainted(const XmlElement& element) {
  return std::any_of(kFacetPaints.begin(), kFacetPaints.end(), [&](std::string_view name) {
    // Without a prefix this is the whole name, because npos + 1 is 0.
    return element.hasAttributeNamed(name.substr(name.find(':') + 1));
  });
}

tl::unexpected<Error> badTransform(std::string_view text, Message what) {
  return badInput(message<"3mf-transform">(with::quoted<"transform">(excerpt(text, kLongestTransform)),
                                           with::cause<"cause">(std::move(what))));
}

class ModelHandler : public XmlHandler {
 public:
  explicit ModelHandler(const ReadLimits& limits) : limits_(limits) {}

  ThreeMfModel take() { return std::move(model_); }

  void declareSpace(std::string_view prefix, std::string_view uri) override {
    if (places_.empty()) spaces_.insert_or_assign(std::string(prefix), std::string(uri));
  }

  Status startElement(const XmlElement& element) override {
    const Place parent = places_.empty() ? Place::Outside : places_.back();
    places_.push_back(placeOf(element, parent));
    switch (places_.back()) {
      case Place::Model:
        return startModel(element);
      case Place::Object:
        return startObject(element);
      case Place::Mesh:
        return startContent();
      case Place::Build:
        model_.hasBuild = true;
        return {};
      case Place::Vertex:
        return takeVertex(element);
      case Place::Triangle:
        return takeTriangle(element);
      case Place::Components:
        return startContent();
      case Place::Component:
        return takeInstance(element, object_->components);
      case Place::Item:
        return takeInstance(element, model_.items);
      case Place::Other:
        if (isInObject())
          takeOther(element, parent);
        else
          takeColours(element);
        [[fallthrough]];
      default:
        return parent == Place::Outside ? badInput(message<"3mf-not-a-model">()) : Status();
    }
  }

  Status endElement() override {
    const Place place = places_.back();
    places_.pop_back();
    takeSwitch();
    if (place == Place::Vertices) verticesEnded_ = true;
    return place == Place::Object ? endObject() : Status();
  }

  void text(std::string_view piece) override {
    if (!curaMesh_.empty() && switch_.size() + piece.size() <= kLongestSwitch) switch_ += piece;
  }

 private:
  enum class Place {
    Outside,
    Model,
    Resources,
    Object,
    Mesh,
    Vertices,
    Vertex,
    Triangles,
    Triangle,
    Components,
    Component,
    Build,
    Item,
    Other  ///< skipped with everything in it
  };

  static Place placeOf(const XmlElement& element, Place parent) {
    struct Rule {
      Place parent;
      std::string_view name;
      Place place;
    };
    static constexpr std::array<Rule, 12> kRules = {{{Place::Vertices, "vertex", Place::Vertex},
                                                     {Place::Triangles, "triangle", Place::Triangle},
                                                     {Place::Outside, "model", Place::Model},
                                                     {Place::Model, "resources", Place::Resources},
                                                     {Place::Model, "build", Place::Build},
                                                     {Place::Resources, "object", Place::Object},
                                                     {Place::Object, "mesh", Place::Mesh},
                                                     {Place::Object, "components", Place::Components},
                                                     {Place::Mesh, "vertices", Place::Vertices},
                                                     {Place::Mesh, "triangles", Place::Triangles},
                                                     {Place::Components, "component", Place::Component},
                                                     {Place::Build, "item", Place::Item}}};
    if (element.space != kCore) return Place::Other;
    for (const Rule& rule : kRules)
      if (rule.parent == parent && rule.name == element.name) return rule.place;
    return Place::Other;
  }

  tl::unexpected<Error> badObject(Message what) const {
    return badInput(message<"3mf-object">(with::index<"object">(objectId_), with::cause<"cause">(std::move(what))));
  }

  tl::unexpected<Error> badVertex(Message what) const {
    return badObject(
        message<"vertex">(with::index<"vertex">(object_->positions.size() + 1), with::cause<"cause">(std::move(what))));
  }

  /// @param number  from 1
  tl::unexpected<Error> badTriangle(std::size_t number, Message what) const {
    return badObject(message<"3mf-triangle">(with::index<"triangle">(number), with::cause<"cause">(std::move(what))));
  }

  Status countEntry() {
    if (++entries_ <= kMaxEntries) return {};
    return badInput(message<"3mf-too-many-entries">(with::count<"limit">(kMaxEntries)));
  }

  Status startModel(const XmlElement& element) {
    if (const auto unit = element.attribute("unit")) {
      const auto known =
          std::find_if(kUnits.begin(), kUnits.end(), [&](const Unit& u) { return u.name == withoutBlanks(*unit); });
      if (known == kUnits.end()) return badInput(message<"3mf-unit">(with::quoted<"unit">(excerpt(*unit))));
      model_.unitMm = known->mm;
    }
    // Refuse extensions that change the geometry. Colours, triangle names and slices in addition to a full mesh do not.
    TextScanner prefixes(element.attribute("requiredextensions").value_or(""));
    for (std::string_view prefix = prefixes.word(); !prefix.empty(); prefix = prefixes.word()) {
      const auto space = spaces_.find(std::string(prefix));
      if (space == spaces_.end())
        return badInput(message<"3mf-extension-undeclared">(with::quoted<"prefix">(excerpt(prefix))));
      if (space->second != kProduction && space->second != kMaterial && space->second != kTriangleSets &&
          space->second != kSlice && space->second != kCore)
        return badInput(message<"3mf-extension">(with::quoted<"extension">(excerpt(space->second, kLongestUri))));
    }
    return {};
  }

  static Result<std::uint32_t> idFrom(const XmlElement& element, std::string_view name) {
    const auto text = element.attribute(name);
    if (!text)
      return badInput(
          message<"3mf-attribute-missing">(with::quoted<"element">(element.name), with::term<"attribute">(name)));
    const auto id = parseInteger(withoutBlanks(*text));
    if (!id || *id < 1 || *id > 0x7fffffff)
      return badInput(message<"3mf-id">(with::quoted<"word">(excerpt(*text)), with::term<"attribute">(name)));
    return static_cast<std::uint32_t>(*id);
  }

  Status startObject(const XmlElement& element) {
    QRELIEF_TRY(countEntry());
    const Result<std::uint32_t> id = idFrom(element, "id");
    QRELIEF_TRY(id);
    objectId_ = *id;
    const auto [at, isNew] = model_.objects.try_emplace(*id);
    if (!isNew) return badObject(message<"3mf-two-objects">());
    object_ = &at->second;
    object_->name = element.attribute("name").value_or("");
    object_->type = element.attribute("type").value_or("model");
    const auto resolution = element.attribute(kSlice, "meshresolution");
    object_->hasSlices = element.attribute(kSlice, "slicestackid").has_value();
    object_->isInSlices = resolution == "lowres";
    mayBeInSlices_ = object_->hasSlices && !resolution;
    objectGroup_ = numberOf(element, "pid");
    objectColour_ = colourOf(objectGroup_, numberOf(element, "pindex"));
    foreignContent_.clear();
    hasContent_ = verticesEnded_ = false;
    return {};
  }

  bool isInObject() const { return places_.size() > kObjectDepth && places_[kObjectDepth - 1] == Place::Object; }

  /// Takes what other programs and extensions say about an object.
  void takeOther(const XmlElement& element, Place parent) {
    if (parent == Place::Object && element.space != kCore && !element.space.empty()) foreignContent_ = element.space;
    if (parent == Place::Mesh && element.name == "beamlattice") object_->isInBeams = true;
    // Cura writes metadata; its old versions wrote elements of their own.
    std::string_view key;
    if (element.name == "metadata") key = element.attribute("name").value_or("");
    if (element.name == "setting") key = element.attribute("key").value_or("");
    if (key.starts_with(kCuraPrefix)) key.remove_prefix(kCuraPrefix.size());
    switch_.clear();
    curaMesh_ = std::find(kCuraMeshes.begin(), kCuraMeshes.end(), key) == kCuraMeshes.end() ? "" : key;
  }

  /// Ends the setting whose text was read.
  void takeSwitch() {
    if (!curaMesh_.empty() && switchFrom(switch_) == true) object_->curaMesh = curaMesh_;
    curaMesh_.clear();
  }

  /// Takes the colours of a group of the resources.
  void takeColours(const XmlElement& element) {
    const bool isBase = element.space == kCore && element.name == "base";
    if ((element.space == kCore && element.name == "basematerials") ||
        (element.space == kMaterial && element.name == "colorgroup"))
      groupId_ = numberOf(element, "id").value_or(0);
    else if (isBase || (element.space == kMaterial && element.name == "color"))
      groups_[groupId_].push_back(colourFrom(element.attribute(isBase ? "displaycolor" : "color").value_or("")));
  }

  static std::optional<std::uint32_t> numberOf(const XmlElement& element, std::string_view name) {
    const auto text = element.attribute(name);
    const auto number = text ? parseInteger(withoutBlanks(*text)) : std::nullopt;
    if (!number || *number < 0 || *number > 0x7fffffff) return {};
    return static_cast<std::uint32_t>(*number);
  }

  std::optional<Colour> colourOf(std::optional<std::uint32_t> group, std::optional<std::uint32_t> index) const {
    const auto colours = group ? groups_.find(*group) : groups_.end();
    if (colours == groups_.end() || !index || *index >= colours->second.size()) return {};
    return colours->second[*index];
  }

  /// Returns the colour of a triangle: by its own properties, or else the object's.
  std::optional<Colour> colourOf(const XmlElement& element) const {
    if (groups_.empty()) return {};
    const auto index = numberOf(element, "p1");
    if (!index) return objectColour_;
    const auto group = numberOf(element, "pid");
    return colourOf(group ? group : objectGroup_, index);
  }

  static std::uint8_t paintOf(const XmlElement& element) {
    const auto text = element.attribute(kBambuPaint);
    const auto code = text ? text : element.attribute(kPrusaSpace, kPrusaPaintName);
    return code ? static_cast<std::uint8_t>(filamentOfCode(*code).value_or(0)) : std::uint8_t{0};
  }

  /// Adds a value for the latest triangle. All values are `none` until there is another one.
  template <class Value>
  void add(std::vector<Value>& values, const Value& value, const Value& none) {
    if (values.empty() && value == none) return;
    values.resize(object_->triangles.size() - 1, none);
    values.push_back(value);
  }

  Status startContent() {
    if (hasContent_) return badObject(message<"3mf-two-contents">());
    hasContent_ = true;
    return {};
  }

  Status takeVertex(const XmlElement& element) {
    if (++vertices_ > 3 * limits_.maxTriangles) return tooManyTriangles(limits_.maxTriangles);
    Vec3 p(0);
    for (int axis = 0; axis < 3; ++axis) {
      const char name = static_cast<char>('x' + axis);
      const auto text = element.attribute(std::string_view(&name, 1));
      if (!text) return badVertex(message<"3mf-coordinate-missing">(with::term<"axis">(std::string_view(&name, 1))));
      const auto value = parseNumber(withoutBlanks(*text));
      if (!value) return badVertex(notANumber(*text));
      if (!std::isfinite(*value)) return badVertex(notFinite(*text));
      p[axis] = *value;
    }
    object_->positions.push_back(p);
    return {};
  }

  Status takeTriangle(const XmlElement& element) {
    if (++triangles_ > limits_.maxTriangles) return tooManyTriangles(limits_.maxTriangles);
    static constexpr std::array<std::string_view, 3> kNames = {"v1", "v2", "v3"};
    Triangle triangle{};
    const std::size_t number = object_->triangles.size() + 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto text = element.attribute(kNames[k]);
      if (!text) return badTriangle(number, message<"3mf-corner-missing">(with::term<"corner">(kNames[k])));
      const auto index = parseInteger(withoutBlanks(*text));
      if (!index) return badTriangle(number, text->empty() ? notANumber(*text) : notAVertex(*text));
      if (*index < 0 || *index > 0xffffffffLL || (verticesEnded_ && !hasVertex(*index)))
        return badTriangle(number, noSuchVertex(*index, object_->positions.size()));
      triangle[k] = static_cast<std::uint32_t>(*index);
    }
    object_->triangles.push_back(triangle);
    const bool hasMore = element.attributeCount() > kCorners;
    if (hasMore && !object_->isPainted) object_->isPainted = isPainted(element);
    add(object_->colours, hasMore ? colourOf(element) : objectColour_, std::optional<Colour>());
    add(object_->paint, hasMore ? paintOf(element) : std::uint8_t{0}, std::uint8_t{0});
    return {};
  }

  bool hasVertex(std::int64_t index) const { return static_cast<std::uint64_t>(index) < object_->positions.size(); }

  Status takeInstance(const XmlElement& element, std::vector<ThreeMfInstance>& instances) {
    QRELIEF_TRY(countEntry());
    ThreeMfInstance instance;
    const Result<std::uint32_t> id = idFrom(element, "objectid");
    QRELIEF_TRY(id);
    instance.object = *id;
    instance.path = element.attribute(kProduction, "path").value_or("");
    instance.partNumber = element.attribute("partnumber").value_or("");
    instance.isPrinted = switchFrom(element.attribute("printable").value_or("")).value_or(true);
    if (const auto text = element.attribute("transform")) {
      const Result<Affine> transform = transformFrom(*text);
      QRELIEF_TRY(transform);
      instance.transform = *transform;
    }
    instances.push_back(std::move(instance));
    return {};
  }

  Status endObject() {
    if (!hasContent_ && !foreignContent_.empty())
      return badObject(
          message<"3mf-foreign-content">(with::quoted<"extension">(excerpt(foreignContent_, kLongestUri))));
    if (!hasContent_) return badObject(message<"3mf-no-content">());
    for (std::size_t t = 0; t < object_->triangles.size(); ++t)  // triangles may come before their vertices
      for (const std::uint32_t v : object_->triangles[t])
        if (!hasVertex(v)) return badTriangle(t + 1, noSuchVertex(v, object_->positions.size()));
    object_->isInSlices |= mayBeInSlices_ && isBox(*object_);
    return {};
  }

  const ReadLimits& limits_;
  ThreeMfModel model_;
  std::map<std::string, std::string> spaces_;  // prefix → URI, of the outermost element
  std::vector<Place> places_;                  // of the open elements
  ThreeMfObject* object_ = nullptr;
  std::uint32_t objectId_ = 0, groupId_ = 0;
  std::map<std::uint32_t, std::vector<std::optional<Colour>>> groups_;  // of colours, by their id
  std::optional<std::uint32_t> objectGroup_;
  std::optional<Colour> objectColour_;
  bool hasContent_ = false;
  bool mayBeInSlices_ = false;     // the object has slices and does not say how good its mesh is
  std::string foreignContent_;     // namespace of an object's content that is none of the core's
  std::string curaMesh_, switch_;  // the open setting of Cura, and its text so far
  bool verticesEnded_ = false;     // for the object's mesh; from then on, a triangle's vertices must exist
  std::size_t vertices_ = 0, triangles_ = 0, entries_ = 0;
};

}  // namespace

Result<Affine> transformFrom(std::string_view text) {
  std::array<double, 12> m{};
  TextScanner words(text);
  for (double& value : m) {
    const std::string_view word = words.word();
    const auto number = parseNumber(word);
    if (!number) return badTransform(text, notANumber(word));
    if (!std::isfinite(*number)) return badTransform(text, notFinite(word));
    value = *number;
  }
  if (!words.word().empty()) return badTransform(text, message<"3mf-transform-too-long">());
  const Affine transform{{m[0], m[1], m[2]}, {m[3], m[4], m[5]}, {m[6], m[7], m[8]}, {m[9], m[10], m[11]}};
  if (!(std::abs(transform.determinant()) > 0) || !std::isfinite(transform.determinant()))
    return badTransform(text, message<"3mf-transform-flat">());
  return transform;
}

Result<ThreeMfModel> readThreeMfModel(ZipStream& stream, const std::string& part, const ReadLimits& limits) {
  ModelHandler handler(limits);
  QRELIEF_TRY(readXml(stream, part, handler));
  return handler.take();
}

}  // namespace qrelief
