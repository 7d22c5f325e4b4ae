// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "inspector/request_overrides.h"

namespace qrelief {

// Names of settings in the inspector: the page's labels, which come with the translation as "setting:KEY",
// "choice:KEY:NAME", "group:KEY" and "unit:KEY" (web/i18n/inspector_texts.js). Without a translation, as in tests, the
// keys.

/// Returns "Minimum wall, mm".
std::string labelOf(const Tunable& tunable);
std::string groupLabelOf(const Setting& setting);
std::vector<std::string> choiceLabelsOf(const Tunable& tunable);
/// Returns "0.8", "on", "Thick plus".
std::string valueText(const Tunable& tunable, double value);
/// Lists the overrides in words: "Contrast 0.4, Minimum wall 1 mm"; empty if there are none.
std::string describe(const RequestOverrides& overrides);

}  // namespace qrelief
