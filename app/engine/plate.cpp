// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/plate.h"

#include <algorithm>
#include <utility>

#include "batch/plate_layout.h"
#include "delivery/carved_objects.h"
#include "io/write_checked.h"
#include "pipeline/engrave.h"

namespace qrelief {

bool Plate::isEmpty() const {
  return std::all_of(copies_.begin(), copies_.end(), [](const auto& copy) { return copy.empty(); });
}

void Plate::start(std::size_t copies) {
  copies_.clear();
  copies_.resize(copies);
}

void Plate::add(const LoadedModel& model, const EngraveResult& result, const EngraveRequest& request, std::size_t place,
                const std::string& id) {
  if (place >= copies_.size()) return;
  copies_[place] = namedCopy(carvedObjects(result, model.partNames, request.marking.mark == Mark::Inlay, true), id,
                             request.code.text);
}

std::vector<std::uint8_t> Plate::taken(const std::string& title) {
  const std::vector<ModelObject> objects = onPlate(std::exchange(copies_, {}));
  if (objects.empty()) return {};
  const auto bytes = writeChecked(objects, ModelFormat::ThreeMf, {.title = title});
  return bytes ? *bytes : std::vector<std::uint8_t>();
}

}  // namespace qrelief
