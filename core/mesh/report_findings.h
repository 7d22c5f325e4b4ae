// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "mesh/prepare.h"
#include "mesh/repair.h"

namespace qrelief {

/// Everything that is said about one model; places are given in file units, facets by their number in the file.
class FindingList {
 public:
  explicit FindingList(double scaleToMm) : scale_(scaleToMm) {}

  void note(std::string code, std::size_t count, std::string message) {
    add(Finding::Severity::Note, std::move(code), count, std::move(message), {});
  }
  void warn(std::string code, std::size_t count, std::string message, std::string hint) {
    add(Finding::Severity::Warning, std::move(code), count, std::move(message), std::move(hint));
  }
  void block(std::string code, std::size_t count, std::string message, std::string hint) {
    add(Finding::Severity::Blocking, std::move(code), count, std::move(message), std::move(hint));
  }
  std::string place(Vec3 p) const;
  /// A length in file units, and in mm where that is something else.
  std::string length(double mm) const;
  double scaleToMm() const { return scale_; }

  /// What blocks comes first, then warnings; each in the order it was said in.
  std::vector<Finding> take();

 private:
  void add(Finding::Severity severity, std::string code, std::size_t count, std::string message, std::string hint) {
    findings_.push_back({severity, std::move(code), count, std::move(message), std::move(hint)});
  }

  double scale_;
  std::vector<Finding> findings_;
};

/// "1 edge", "7 edges".
std::string counted(std::size_t count, std::string_view one, std::string_view many);

/// What each repair found and did, and what is left.
/// @param parts           of the soup
/// @param partOfTriangle  of the repaired mesh, empty: one part
void reportRepairs(const Repaired& repaired, const RepairOptions& options, std::span<const ModelPart> parts,
                   std::span<const std::uint32_t> partOfTriangle, FindingList& findings);

}  // namespace qrelief
