// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/slicer_rules.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>

#include "io/three_mf/filament_code.h"
#include "io/three_mf/model.h"
#include "support/xml_document.h"

// Sources:
// [P29] PrusaSlicer 2.9.4, src/libslic3r/Format/3mf.cpp
// [P25] PrusaSlicer 2.5.0, the same file, and the program itself (script/test-slicer)
// [BBS] OrcaSlicer at commit 5d337a4 and Bambu Studio at commit 9635928, src/libslic3r/Format/bbs_3mf.cpp
// [SNAP] measured with Snapmaker Orca 2.3.5, gridfinity-layout-tool pull request 1955. [BBS] keeps what it drops.
namespace qrelief::slicer_rules {
namespace {

const std::string kRootModel = "3D/3dmodel.model", kRootPath = "/" + kRootModel;

/// A mesh of the file, before it is divided into volumes.
struct Mesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<unsigned, 3>> triangles;
  std::vector<std::string> prusaPaint, bambuPaint;
};

/// An object of a model part: a mesh or components.
struct Resource {
  Mesh mesh;
  struct Component {
    std::string path;
    unsigned object;
    Affine transform;
  };
  std::vector<Component> components;
  unsigned pid = 0;
  std::set<unsigned> pids;  ///< its own and those of its triangles
};

unsigned number(const std::string& text) { return text.empty() ? 0 : static_cast<unsigned>(std::stoul(text)); }

Affine transformOf(const std::string& text) {
  std::istringstream in(text);
  Affine t;
  if (!text.empty())
    for (Vec3* row : {&t.x, &t.y, &t.z, &t.origin}) in >> row->x >> row->y >> row->z;
  return t;
}

Resource resourceOf(const XmlNode& object) {
  Resource resource;
  resource.pid = number(object["pid"]);
  const XmlNode& mesh = object.first("mesh");
  for (const XmlNode* v : mesh.first("vertices").all("vertex"))
    resource.mesh.vertices.push_back({std::stod((*v)["x"]), std::stod((*v)["y"]), std::stod((*v)["z"])});
  for (const XmlNode* t : mesh.first("triangles").all("triangle")) {
    resource.mesh.triangles.push_back({number((*t)["v1"]), number((*t)["v2"]), number((*t)["v3"])});
    resource.mesh.prusaPaint.push_back((*t)[std::string(kPrusaPaint)]);
    resource.mesh.bambuPaint.push_back((*t)[std::string(kBambuPaint)]);
  }
  for (const XmlNode* t : mesh.first("triangles").all("triangle")) resource.pids.insert(number((*t)["pid"]));
  resource.pids.insert(resource.pid);
  resource.pids.erase(0);
  for (const XmlNode* c : object.first("components").all("component"))
    resource.components.push_back({(*c)["p:path"], number((*c)["objectid"]), transformOf((*c)["transform"])});
  return resource;
}

using Resources = std::map<std::pair<std::string, unsigned>, Resource>;  // by path, with a leading slash, and id

/// A mesh in its place.
struct Placed {
  std::string path;
  unsigned id;
  const Mesh* mesh;
  Affine transform;
};

void collect(const Resources& resources, const std::string& path, unsigned id, const Affine& outer,
             std::vector<Placed>& placed) {
  const auto it = resources.find({path, id});
  if (it == resources.end()) return;
  if (!it->second.mesh.triangles.empty()) placed.push_back({path, id, &it->second.mesh, outer});
  for (const auto& c : it->second.components)
    collect(resources, c.path.empty() ? path : c.path, c.object, outer.after(c.transform), placed);
}

/// Reads the objects of model parts. A file without the root model is refused.
Resources resourcesOf(const std::map<std::string, std::string>& files, const std::set<std::string>& parts) {
  Resources resources;
  for (const auto& [name, text] : files) {
    if (!parts.count(name)) continue;
    const XmlNode model = parsedXml(text);
    for (const XmlNode* object : model.first("resources").all("object"))
      resources[{"/" + name, number((*object)["id"])}] = resourceOf(*object);
  }
  return resources;
}

void addTriangles(const Placed& placed, std::size_t first, std::size_t end, Volume& volume,
                  const std::function<unsigned(std::size_t)>& paintOf) {
  for (std::size_t t = first; t < end; ++t) {
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = placed.transform(placed.mesh->vertices.at(placed.mesh->triangles[t][k]));
    volume.triangles.push_back(corners);
    volume.paint.push_back(paintOf(t));
  }
}

unsigned filamentOr0(const std::string& code) { return filamentOfCode(code).value_or(0); }

/// Returns the values of `<metadata key value>`, by key. [P29] _handle_start_config_metadata, [BBS] the same.
std::map<std::string, std::string> metadataOf(const XmlNode& node) {
  std::map<std::string, std::string> values;
  for (const XmlNode* m : node.all("metadata")) values[(*m)["key"]] = (*m)["value"];
  return values;
}

double lowest(const Object& object) {
  double low = 1e300;
  for (const Volume& volume : object.volumes)
    for (const auto& corners : volume.triangles)
      for (const Vec3& p : corners) low = std::min(low, p.z);
  return low;
}

/// Returns a file; an empty node if there is none.
XmlNode settingsOf(const std::map<std::string, std::string>& files, const std::string& name) {
  const auto it = files.find(name);
  return it == files.end() ? XmlNode() : parsedXml(it->second);
}

const XmlNode* findObject(const XmlNode& config, unsigned id) {
  for (const XmlNode* object : config.all("object"))
    if (number((*object)["id"]) == id) return object;
  return nullptr;
}

/// Returns the path of a build item's object. [BBS] and [P29] _handle_start_item.
std::string pathOf(const XmlNode& item) { return item["p:path"].empty() ? kRootPath : item["p:path"]; }

/// Returns all meshes of the build, in order.
std::vector<Placed> placedMeshes(const std::map<std::string, std::string>& files, const Resources& resources) {
  std::vector<Placed> placed;
  const XmlNode root = parsedXml(files.at(kRootModel));
  for (const XmlNode* item : root.first("build").all("item"))
    collect(resources, pathOf(*item), number((*item)["objectid"]), transformOf((*item)["transform"]), placed);
  return placed;
}

/// Makes PrusaSlicer's object from a mesh. @returns none if a volume's range is invalid
std::optional<Object> prusaObject(const Placed& mesh, const XmlNode& config, PrusaVersion version) {
  Object object;
  // [P29] m_objects_metadata.find(object.first.second): by id, whatever the part
  const XmlNode* known = findObject(config, mesh.id);
  // [P29] "config data not found … add the entire geometry as the single volume"
  std::vector<std::pair<std::size_t, std::size_t>> ranges = {{0, mesh.mesh->triangles.size() - 1}};
  std::vector<const XmlNode*> volumes = {nullptr};
  if (known) {
    object.name = metadataOf(*known)["name"];
    volumes = known->all("volume");
    ranges.clear();
    for (const XmlNode* v : volumes) ranges.emplace_back(number((*v)["firstid"]), number((*v)["lastid"]));
  }
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const std::size_t first = ranges[i].first, last = ranges[i].second;
    // [P29] _generate_volumes: "Found invalid triangle id"
    if (first > last || last >= mesh.mesh->triangles.size()) return std::nullopt;
    auto values = volumes[i] ? metadataOf(*volumes[i]) : std::map<std::string, std::string>();
    Volume volume;
    volume.name = values["name"];
    volume.kind = values["volume_type"].empty() ? "ModelPart" : values["volume_type"];
    const std::string own = values["extruder"], whole = known ? metadataOf(*known)["extruder"] : "";
    volume.filament = std::max(1u, number(own.empty() ? whole : own));
    // [P29] _handle_start_triangle: mmu_segmentation, and since #12502 paint_color where it is missing
    addTriangles(mesh, first, last + 1, volume, [&](std::size_t t) {
      const std::string& prusa = mesh.mesh->prusaPaint[t];
      if (!prusa.empty() || version == PrusaVersion::V2_5) return filamentOr0(prusa);
      return filamentOr0(mesh.mesh->bambuPaint[t]);
    });
    object.volumes.push_back(std::move(volume));
  }
  return object;
}

/// Makes Bambu Studio's object from the meshes of a build item.
Object bambuObject(unsigned id, unsigned pid, const std::vector<Placed>& placed, const XmlNode& config,
                   const std::map<unsigned, std::string>& groups) {
  Object object;
  unsigned whole = 1;
  const XmlNode* known = findObject(config, id);  // [BBS] by id, whatever program wrote the file
  if (known) {
    auto values = metadataOf(*known);
    object.name = values["name"];
    whole = std::max(1u, number(values["extruder"]));
  } else if (groups.count(pid)) {
    // [BBS] colours are numbered in the order of their groups; only the build object's own pid counts
    std::set<std::string> before;
    for (const auto& entry : groups)
      if (before.insert(entry.second).second && entry.second == groups.at(pid))
        whole = static_cast<unsigned>(before.size());
  }
  for (const Placed& mesh : placed) {
    Volume volume;
    volume.kind = "normal_part";
    volume.filament = whole;
    if (known)
      for (const XmlNode* part : known->all("part"))
        if (number((*part)["id"]) == mesh.id) {  // [BBS] _generate_volumes_new: subobject id
          auto values = metadataOf(*part);
          volume.name = values["name"];
          volume.kind = (*part)["subtype"];
          if (!values["extruder"].empty()) volume.filament = number(values["extruder"]);
        }
    const bool keepsPaint = mesh.path != kRootPath;  // [SNAP] paint of a mesh in the root model is dropped
    addTriangles(mesh, 0, mesh.mesh->triangles.size(), volume,
                 [&](std::size_t t) { return keepsPaint ? filamentOr0(mesh.mesh->bambuPaint[t]) : 0; });
    object.volumes.push_back(std::move(volume));
  }
  // [BBS] _load_model_from_file: "if (mo->volumes.size() == 1) mo->volumes[0]->config.erase("extruder")"
  if (object.volumes.size() == 1) object.volumes.front().filament = whole;
  return object;
}

/// Returns the colour of each colour group, by id.
std::map<unsigned, std::string> colourGroups(const std::map<std::string, std::string>& files,
                                             const std::set<std::string>& parts) {
  std::map<unsigned, std::string> groups;
  const auto read = [&](const std::string& part) {
    std::map<unsigned, std::string> own;
    const XmlNode model = parsedXml(files.at(part));
    for (const XmlNode* g : model.first("resources").all("m:colorgroup"))
      for (const XmlNode* colour : g->all("m:color")) own[number((*g)["id"])] = (*colour)["color"];
    return own;
  };
  // [BBS] _handle_start_color: a group keeps its last colour. Groups of all parts are in one list: the first part file
  // counts, and the root model, which is read last, over all of them.
  for (const std::string& part : parts)
    if (part != kRootModel) groups.merge(read(part));
  for (const auto& [id, colour] : read(kRootModel)) groups[id] = colour;
  return groups;
}

}  // namespace

std::vector<unsigned> Project::filaments() const {
  std::set<unsigned> used;
  for (const Object& object : objects)
    for (const Volume& volume : object.volumes) {
      used.insert(volume.filament);
      used.insert(volume.paint.begin(), volume.paint.end());
    }
  used.erase(0);
  return {used.begin(), used.end()};
}

Project openInPrusaSlicer(std::span<const std::uint8_t> file, PrusaVersion version) {
  const auto files = unzipped(file);
  Project project;
  std::set<std::string> parts;
  for (const auto& [name, text] : files)
    if (name.starts_with("3D/") && name.ends_with(".model")) parts.insert(name);
  const Resources resources = resourcesOf(files, parts);
  // [P25] _handle_start_component: "Found component with invalid object id", for ids are looked up in the root model.
  for (const auto& [key, resource] : resources)
    for (const auto& component : resource.components)
      if (version == PrusaVersion::V2_5 && !component.path.empty()) project.refused = "component with a path";
  if (!project.refused.empty()) return project;
  const XmlNode config = settingsOf(files, "Metadata/Slic3r_PE_model.config");
  for (const Placed& mesh : placedMeshes(files, resources)) {  // [P29] _create_object_instance: each is an object
    auto object = prusaObject(mesh, config, version);
    if (!object) {
      project.refused = "invalid triangle id";
      return project;
    }
    project.objects.push_back(std::move(*object));
  }
  // [P29] Model::looks_like_multipart_object: several objects, not all from the same height
  for (const Object& object : project.objects)
    project.asksAboutParts |= std::abs(lowest(object) - lowest(project.objects.front())) > 1e-4;
  return project;
}

Project openInBambuStudio(std::span<const std::uint8_t> file) {
  const auto files = unzipped(file);
  Project project;
  // [BBS] _handle_start_config_object: "Duplicated object id"
  const XmlNode config = settingsOf(files, "Metadata/model_settings.config");
  std::set<std::string> ids;
  for (const XmlNode* object : config.all("object"))
    if (!ids.insert((*object)["id"]).second) project.refused = "duplicated object id";
  if (!project.refused.empty()) return project;
  // [BBS] _extract_xml_from_archive(sub_rels): only declared parts are read, before the root
  std::set<std::string> parts = {kRootModel};
  const XmlNode relationships = settingsOf(files, "3D/_rels/3dmodel.model.rels");
  for (const XmlNode* r : relationships.all("Relationship")) parts.insert((*r)["Target"].substr(1));
  const Resources resources = resourcesOf(files, parts);
  const auto groups = colourGroups(files, parts);
  // [BBS] _handle_start_triangle of Bambu Studio: the pid of a triangle or its object is looked up in the colour groups
  for (const auto& [key, resource] : resources)
    for (const unsigned pid : resource.pids)
      if (!groups.count(pid)) project.refused = "pid without a colour group";
  const XmlNode root = parsedXml(files.at(kRootModel));
  for (const XmlNode* item : root.first("build").all("item")) {
    const unsigned id = number((*item)["objectid"]);
    std::vector<Placed> placed;
    collect(resources, pathOf(*item), id, transformOf((*item)["transform"]), placed);
    project.objects.push_back(bambuObject(id, resources.at({pathOf(*item), id}).pid, placed, config, groups));
  }
  if (const auto palette = files.find("Metadata/project_settings.config"); palette != files.end())
    project.filamentColours =
        nlohmann::json::parse(palette->second).at("filament_colour").get<std::vector<std::string>>();
  return project;
}

}  // namespace qrelief::slicer_rules
