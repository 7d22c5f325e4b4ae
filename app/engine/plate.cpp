// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/plate.h"

#include <utility>

#include "batch/plate_layout.h"
#include "io/write_checked.h"
#include "pipeline/carved_objects.h"
#include "pipeline/engrave.h"

namespace qrelief {

void Plate::start(const LoadedModel& model, std::size_t copies) {
  objects_.clear();
  offsets_ = plateOffsets(model.engravable->box, copies);
}

void Plate::add(const LoadedModel& model, const EngraveResult& result, const EngraveRequest& request, std::size_t place,
                const std::string& id) {
  if (place >= offsets_.size()) return;
  for (ModelObject& object : copyOnPlate(carvedObjects(result, model.partNames, request.marking.hasInlay(), true), id,
                                         request.code.text, offsets_[place]))
    objects_.push_back(std::move(object));
}

std::vector<std::uint8_t> Plate::taken(const std::string& title) {
  const std::vector<ModelObject> objects = std::exchange(objects_, {});
  if (objects.empty()) return {};
  const auto bytes = writeChecked(objects, ModelFormat::ThreeMf, {.title = title});
  return bytes ? *bytes : std::vector<std::uint8_t>();
}

}  // namespace qrelief
