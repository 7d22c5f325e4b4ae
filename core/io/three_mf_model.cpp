// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/three_mf_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "io/parse_number.h"
#include "io/polygon_list.h"
#include "io/text_scanner.h"

namespace qrelief {
namespace {

constexpr std::string_view kCore = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
constexpr std::string_view kProduction = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";
constexpr std::string_view kMaterial = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02";
constexpr std::string_view kTriangleSets = "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07";
constexpr std::size_t kMaxEntries = 100'000;  // objects, components and items of one part

struct Unit {
  std::string_view name;
  double mm;
};
constexpr std::array<Unit, 6> kUnits = {
    {{"micron", 0.001}, {"millimeter", 1}, {"centimeter", 10}, {"inch", 25.4}, {"foot", 304.8}, {"meter", 1000}}};

tl::unexpected<Error> bad(std::string what, std::string hint = {}) {
  return fail(ErrorKind::BadInput, std::move(what), std::move(hint));
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
      default:
        return parent == Place::Outside ? bad("the outermost element is no 3MF model") : Status();
    }
  }

  Status endElement() override {
    const Place place = places_.back();
    places_.pop_back();
    return place == Place::Object ? endObject() : Status();
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
    Other  ///< passed over with all that is in it
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

  tl::unexpected<Error> badObject(const std::string& what) const {
    return bad(fmt::format("object {}: {}", objectId_, what));
  }

  Status countEntry() {
    if (++entries_ <= kMaxEntries) return {};
    return bad(fmt::format("there are more than {} objects, components and items", kMaxEntries),
               "Join objects before exporting the model");
  }

  Status startModel(const XmlElement& element) {
    if (const auto unit = element.attribute("unit")) {
      const auto known = std::find_if(kUnits.begin(), kUnits.end(), [&](const Unit& u) { return u.name == *unit; });
      if (known == kUnits.end()) return bad(fmt::format("the unit {} is not known", quoted(*unit)));
      model_.unitMm = known->mm;
    }
    // What a reader must understand to get the geometry right: colours and names of triangles are not among it.
    TextScanner prefixes(element.attribute("requiredextensions").value_or(""));
    for (std::string_view prefix = prefixes.word(); !prefix.empty(); prefix = prefixes.word()) {
      const auto space = spaces_.find(std::string(prefix));
      if (space == spaces_.end()) return bad(fmt::format("the required extension {} is not declared", quoted(prefix)));
      if (space->second != kProduction && space->second != kMaterial && space->second != kTriangleSets &&
          space->second != kCore)
        return bad(fmt::format("it requires the extension {}, which cannot be read", space->second),
                   "Export the model as plain triangles (3MF core), or as STL");
    }
    return {};
  }

  static Result<std::uint32_t> idFrom(const XmlElement& element, std::string_view name) {
    const auto text = element.attribute(name);
    if (!text) return bad(fmt::format("an element '{}' has no {}", element.name, name));
    const auto id = parseInteger(*text);
    if (!id || *id < 1 || *id > 0x7fffffff) return bad(fmt::format("{} is no {}", quoted(*text), name));
    return static_cast<std::uint32_t>(*id);
  }

  Status startObject(const XmlElement& element) {
    if (const Status counted = countEntry(); !counted) return counted;
    const Result<std::uint32_t> id = idFrom(element, "id");
    if (!id) return tl::unexpected(id.error());
    objectId_ = *id;
    const auto [at, isNew] = model_.objects.try_emplace(*id);
    if (!isNew) return badObject("there are two of this id");
    object_ = &at->second;
    object_->name = element.attribute("name").value_or("");
    object_->type = element.attribute("type").value_or("model");
    hasContent_ = false;
    return {};
  }

  Status startContent() {
    if (hasContent_) return badObject("it has more than one mesh or list of components");
    hasContent_ = true;
    return {};
  }

  Status takeVertex(const XmlElement& element) {
    if (++vertices_ > 3 * limits_.maxTriangles) return tooManyTriangles(limits_.maxTriangles);
    const std::size_t number = object_->positions.size() + 1;
    Vec3 p(0);
    for (int axis = 0; axis < 3; ++axis) {
      const char name = static_cast<char>('x' + axis);
      const auto text = element.attribute(std::string_view(&name, 1));
      if (!text) return badObject(fmt::format("vertex {} has no {}", number, name));
      const auto value = parseNumber(*text);
      if (!value) return badObject(fmt::format("vertex {}: {}", number, notANumber(*text)));
      if (!std::isfinite(*value))
        return badObject(fmt::format("vertex {} is at {}, which is not finite", number, *text));
      p[axis] = *value;
    }
    object_->positions.push_back(p);
    return {};
  }

  Status takeTriangle(const XmlElement& element) {
    if (++triangles_ > limits_.maxTriangles) return tooManyTriangles(limits_.maxTriangles);
    static constexpr std::array<std::string_view, 3> kNames = {"v1", "v2", "v3"};
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto text = element.attribute(kNames[k]);
      if (!text) return badObject(fmt::format("triangle {} has no {}", object_->triangles.size() + 1, kNames[k]));
      const auto index = parseInteger(*text);
      if (!index || *index < 0 || *index > 0xffffffffLL)
        return badObject(fmt::format("triangle {}: {} is no vertex", object_->triangles.size() + 1, quoted(*text)));
      triangle[k] = static_cast<std::uint32_t>(*index);
    }
    object_->triangles.push_back(triangle);
    return {};
  }

  static Result<Affine> transformFrom(std::string_view text) {
    std::array<double, 12> m{};
    TextScanner words(text);
    for (double& value : m) {
      const std::string_view word = words.word();
      const auto number = parseNumber(word);
      if (!number || !std::isfinite(*number))
        return bad(fmt::format("the transform {}: {}", quoted(text), notANumber(word)));
      value = *number;
    }
    if (!words.word().empty()) return bad(fmt::format("the transform {} has more than 12 numbers", quoted(text)));
    const Affine transform{{m[0], m[1], m[2]}, {m[3], m[4], m[5]}, {m[6], m[7], m[8]}, {m[9], m[10], m[11]}};
    if (!(std::abs(transform.determinant()) > 0) || !std::isfinite(transform.determinant()))
      return bad(fmt::format("the transform {} flattens the object", quoted(text)));
    return transform;
  }

  Status takeInstance(const XmlElement& element, std::vector<ThreeMfInstance>& instances) {
    if (const Status counted = countEntry(); !counted) return counted;
    ThreeMfInstance instance;
    const Result<std::uint32_t> id = idFrom(element, "objectid");
    if (!id) return tl::unexpected(id.error());
    instance.object = *id;
    instance.path = element.attribute(kProduction, "path").value_or("");
    instance.partNumber = element.attribute("partnumber").value_or("");
    if (const auto text = element.attribute("transform")) {
      const Result<Affine> transform = transformFrom(*text);
      if (!transform) return tl::unexpected(transform.error());
      instance.transform = *transform;
    }
    instances.push_back(std::move(instance));
    return {};
  }

  Status endObject() {
    if (!hasContent_) return badObject("it has neither a mesh nor components");
    for (std::size_t t = 0; t < object_->triangles.size(); ++t)
      for (const std::uint32_t v : object_->triangles[t])
        if (v >= object_->positions.size())
          return badObject(fmt::format("triangle {} asks for vertex {} (counted from 0), but there are {}", t + 1, v,
                                       object_->positions.size()));
    return {};
  }

  const ReadLimits& limits_;
  ThreeMfModel model_;
  std::map<std::string, std::string> spaces_;  // prefix → URI, of the outermost element
  std::vector<Place> places_;                  // of the open elements
  ThreeMfObject* object_ = nullptr;
  std::uint32_t objectId_ = 0;
  bool hasContent_ = false;
  std::size_t vertices_ = 0, triangles_ = 0, entries_ = 0;
};

}  // namespace

Affine Affine::after(const Affine& inner) const {
  const auto turned = [this](Vec3 v) { return v.x * x + v.y * y + v.z * z; };
  return {turned(inner.x), turned(inner.y), turned(inner.z), (*this)(inner.origin)};
}

double Affine::determinant() const { return glm::dot(glm::cross(x, y), z); }

Result<ThreeMfModel> readThreeMfModel(ZipStream& stream, const std::string& part, const ReadLimits& limits) {
  ModelHandler handler(limits);
  if (const Status read = readXml(stream, part, handler); !read) return tl::unexpected(read.error());
  return handler.take();
}

}  // namespace qrelief
