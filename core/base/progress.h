// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace qrelief {

/// How far a job has come. `stage` is a static, human-readable name ("Finding the depth").
struct Progress {
  std::string_view stage;
  double fraction = 0;  ///< of the whole job, 0 … 1, never falls
  bool done = false;
};

}  // namespace qrelief
