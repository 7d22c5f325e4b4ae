// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "verdict/verdict.h"

namespace qrelief {

/// An attempt of an EngravePlan, and its outcome.
struct TriedCarving {
  std::vector<SettingChange> changes;                    ///< from the request; empty: as requested
  bool isOffer = false;                                  ///< made to tell the user about it, not to deliver it
  std::optional<Vec3> centreMm = {};                     ///< of the spot found for it; none: at the requested centre
  std::optional<Message> failure = {};                   ///< why it was not carved
  double symbolMm = 0;                                   ///< 0: not carved
  std::optional<ReadingCount> reads = {}, printed = {};  ///< decoding results of design and print; none: not looked at
  bool passed = false;                                   ///< Verdict::passed()
};

/// Returns the verdict with the remedies that are left: without those that were tried in vain, and with the marks that
/// were tried as an offer and passed.
Verdict withRemediesLeft(Verdict verdict, const std::vector<TriedCarving>& tried);

/// Returns the first offer that passed; null: none.
const TriedCarving* passedOffer(const std::vector<TriedCarving>& tried);

/// Returns the error, with the first offer that passed as its hint.
Error withOffer(Error error, const std::vector<TriedCarving>& tried);

}  // namespace qrelief
