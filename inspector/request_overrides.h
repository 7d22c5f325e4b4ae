// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/engrave.h"

namespace qrelief {

/// Something of a request that can be tuned, as a number: a choice by its index, a switch as 0 or 1.
struct Tunable {
  const char* group;
  const char* name;
  const char* unit;  ///< "" if it has none
  double least = 0, most = 1, step = 0.1;
  std::span<const char* const> choices = {};  ///< their names; empty for a number or a switch
  bool isSwitch = false;
  double (*read)(const EngraveRequest&) = nullptr;
  void (*write)(EngraveRequest&, double) = nullptr;
};

/// Everything of a request but its text, centre, up axis and what is recorded; groups stand together.
std::span<const Tunable> tunables();

/// What differs from the page's request on purpose, by index in `tunables()`. The page's own controls stay what they
/// are: what is not overridden follows them.
class RequestOverrides {
 public:
  RequestOverrides();

  /// @param value  is brought into the tunable's range; the page's own value ends the override
  void set(std::size_t index, double value, const EngraveRequest& page);
  void reset(std::size_t index) { values_[index].reset(); }
  void resetAll();
  bool isSet(std::size_t index) const { return values_[index].has_value(); }
  std::size_t count() const;
  double valueOf(std::size_t index, const EngraveRequest& page) const;
  EngraveRequest appliedTo(EngraveRequest page) const;
  /// "contrast 0.4, solver paper's steps"; empty if there are none
  std::string describe() const;

 private:
  std::vector<std::optional<double>> values_;
};

}  // namespace qrelief
