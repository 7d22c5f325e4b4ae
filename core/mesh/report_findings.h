// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "mesh/prepare.h"
#include "mesh/repair.h"

namespace qrelief {

/// Everything that is said about one model; places are given in file units, facets by their number in the file.
class FindingList {
 public:
  explicit FindingList(double scaleToMm) : scale_(scaleToMm) {}

  void note(Message message) { findings_.push_back({Finding::Severity::Note, std::move(message)}); }
  void warn(Message message) { findings_.push_back({Finding::Severity::Warning, std::move(message)}); }
  void block(Message message) { findings_.push_back({Finding::Severity::Blocking, std::move(message)}); }
  /// A repair that was made, or one that was needed and is switched off.
  void mended(bool allowed, Message message) { allowed ? warn(std::move(message)) : block(std::move(message)); }

  /// A place in file units.
  Vec3 inFile(Vec3 mm) const { return mm / scale_; }

  /// What blocks comes first, then warnings; each in the order it was said in.
  std::vector<Finding> take();

 private:
  double scale_;
  std::vector<Finding> findings_;
};

/// What each repair found and did, and what is left.
/// @param parts           of the soup
/// @param partOfTriangle  of the repaired mesh, empty: one part
void reportRepairs(const Repaired& repaired, const RepairOptions& options, std::span<const ModelPart> parts,
                   std::span<const std::uint32_t> partOfTriangle, FindingList& findings);

}  // namespace qrelief
