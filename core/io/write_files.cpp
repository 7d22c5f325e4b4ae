// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_files.h"

#include <algorithm>

#include "io/write_checked.h"
#include "io/write_obj.h"

namespace qrelief {
namespace {

bool hasSecondColour(std::span<const ModelObject> objects) { return coloursOf(objects).size() > 1; }

/// Returns the objects' bodies of one colour. Bodies without a colour have the first one.
std::vector<ModelObject> bodiesOf(std::span<const ModelObject> objects, Colour colour, bool isFirst) {
  std::vector<ModelObject> result;
  for (const ModelObject& object : objects)
    for (const ModelBody& body : object.bodies)
      if (body.colour ? *body.colour == colour : isFirst) result.push_back({object.name, {body}});
  return result;
}

}  // namespace

std::vector<std::string> fileNames(const std::string& name, bool isTwoColoured) {
  const ModelFormat format = formatOfName(name);
  if (!isTwoColoured) return {name};
  const std::size_t dot = name.rfind('.');
  const std::string stem = name.substr(0, dot), extension = name.substr(dot);
  if (format == ModelFormat::Stl) return {name, stem + "-2" + extension};
  if (format == ModelFormat::Obj) return {name, stem + ".mtl"};
  return {name};
}

Result<std::vector<NamedFile>> writeCheckedFiles(std::span<const ModelObject> objects, const std::string& name,
                                                 WriteOptions options) {
  const ModelFormat format = formatOfName(name);
  const std::vector<std::string> names = fileNames(name, hasSecondColour(objects));
  std::vector<NamedFile> files;
  if (names.size() > 1 && format == ModelFormat::Stl) {
    const std::vector<Colour> colours = coloursOf(objects);
    for (std::size_t i = 0; i < names.size(); ++i) {
      auto bytes = writeChecked(bodiesOf(objects, colours[i], i == 0), format, options);
      QRELIEF_TRY(bytes);
      files.push_back({names[i], std::move(*bytes)});
    }
    return files;
  }
  if (names.size() > 1) options.materialFile = names[1].substr(names[1].find_last_of("/\\") + 1);
  auto bytes = writeChecked(objects, format, options);
  QRELIEF_TRY(bytes);
  files.push_back({name, std::move(*bytes)});
  if (names.size() > 1) files.push_back({names[1], writeMaterials(objects)});
  return files;
}

}  // namespace qrelief
