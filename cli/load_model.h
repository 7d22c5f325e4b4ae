// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/result.h"
#include "mesh/prepare.h"

namespace qrelief {

/// A model from a file, checked.
struct LoadedModel {
  std::string format;
  double scaleToMm = 1;
  PreparedModel prepared;
};

/// Reads and prepares a model that is to be engraved; what was mended is said on stderr. Blocking findings are errors.
Result<LoadedModel> loadEngravable(const std::string& path, double scale, const std::string& units);

}  // namespace qrelief
