// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/model_file.h"

#include <cmath>
#include <utility>

#include "base/clock.h"
#include "io/read_model.h"
#include "io/three_mf/source.h"
#include "message_codes/engine.h"

namespace qrelief {

Result<ModelFile> readModelFile(std::vector<std::uint8_t> bytes, const std::string& fileName, double scaleToMm) {
  if (!(scaleToMm >= 0) || !std::isfinite(scaleToMm))
    return fail(ErrorKind::BadUsage, message<"scale-unusable">(with::number<"scale">(scaleToMm)));
  const auto start = Clock::now();
  auto soup = readModel(bytes, fileName);
  QRELIEF_TRY(soup);
  bytes = {};  // frees the file: file and model need not be in memory at once
  ModelFile file;
  file.format = soup->format;
  file.scaleToMm = scaleToMm > 0 ? scaleToMm : soup->unitMm.value_or(1);
  file.warnings = soup->warnings;
  for (ModelPart& part : soup->parts) file.partNames.push_back(std::move(part.name));
  file.loadMs = millisecondsSince(start);

  const auto preparing = Clock::now();
  auto prepared = prepareModel(*soup, {.scaleToMm = file.scaleToMm});
  QRELIEF_TRY(prepared);
  file.prepared = std::move(*prepared);
  file.prepareMs = millisecondsSince(preparing);
  return file;
}

namespace {

/// Lists the bodies as [{name, triangles}].
Json bodiesOf(const PreparedModel& prepared) {
  const std::vector<std::size_t> triangles = prepared.bodySizes();
  Json bodies = Json::array();
  for (std::size_t b = 0; b < triangles.size(); ++b)
    bodies.push_back({{"name", prepared.bodies[b].name}, {"triangles", triangles[b]}});
  return bodies;
}

/// Lists what a carved model keeps only in its own 3MF file (delivery/carved_file.h).
Json only3mf(const PreparedModel& prepared) {
  Json contents = Json::array();
  if (!prepared.source || prepared.scaleToMm != prepared.source->unitMm) return contents;
  if (prepared.source->isPainted) contents.push_back("paint");
  if (prepared.source->plates > 1) contents.push_back("plates");
  return contents;
}

}  // namespace

Json describeModel(const std::string& format, double scaleToMm, const std::vector<Message>& warnings,
                   const PreparedModel& prepared) {
  return {{"format", format},
          {"scaleToMm", scaleToMm},
          {"triangles", prepared.mesh.triangles.size()},
          {"vertices", prepared.mesh.positions.size()},
          {"sizeMm", jsonOf(boundingBox(prepared.mesh).size())},
          {"shells", prepared.shells},
          {"bodies", bodiesOf(prepared)},
          {"engravable", prepared.engravable().has_value()},
          {"findings", jsonOf(warnings, prepared.findings)},
          {"only3mf", only3mf(prepared)}};
}

}  // namespace qrelief
