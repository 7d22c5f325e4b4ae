// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "mesh/prepare.h"
#include "mesh/repair.h"

namespace qrelief {

/// List of findings about one model. Places are in file units; facets have their index in the file.
class FindingList {
 public:
  explicit FindingList(double scaleToMm) : scale_(scaleToMm) {}

  void note(Message message) { findings_.push_back({Finding::Severity::Note, std::move(message)}); }
  void warn(Message message) { findings_.push_back({Finding::Severity::Warning, std::move(message)}); }
  void block(Message message) { findings_.push_back({Finding::Severity::Blocking, std::move(message)}); }
  /// Adds a warning of a repair that was made, or a blocking finding if the repair is switched off.
  void mended(bool allowed, Message message) { allowed ? warn(std::move(message)) : block(std::move(message)); }

  /// Converts a place to file units.
  Vec3 inFile(Vec3 mm) const { return mm / scale_; }

  /// Returns the findings: blocking ones first, then warnings, then notes; each in the order added.
  std::vector<Finding> take();

 private:
  double scale_;
  std::vector<Finding> findings_;
};

/// Reports what each repair found and did, and which defects remain.
void reportRepairs(const Repaired& repaired, const RepairOptions& options, FindingList& findings);

}  // namespace qrelief
