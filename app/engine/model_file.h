// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/answers.h"
#include "mesh/prepare.h"

namespace qrelief {

/// A model's file, read and repaired.
struct ModelFile {
  std::string format;
  double scaleToMm = 1, loadMs = 0, prepareMs = 0;
  std::vector<Message> warnings;  ///< of reading; those of repairs are in `prepared`
  std::vector<std::string> partNames;
  PreparedModel prepared;
};

/// Reads and repairs a file. Needs no GL context.
/// @param bytes      freed as soon as it is read
/// @param scaleToMm  file units → mm; 0: as the file says (3MF), else 1
/// @returns BadUsage for any other scale that is not above zero
Result<ModelFile> readModelFile(std::vector<std::uint8_t> bytes, const std::string& fileName, double scaleToMm);

/// Returns {format, scaleToMm, triangles, vertices, sizeMm, shells, bodies: [{name, triangles}], engravable, findings,
/// only3mf}. `only3mf`: the contents of the model's own 3MF file that only 3MF keeps: "paint", "plates".
Json describeModel(const std::string& format, double scaleToMm, const std::vector<Message>& warnings,
                   const PreparedModel& prepared);

}  // namespace qrelief
