// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "settings/settings.h"

namespace qrelief {

/// English texts of a setting, for the command and its documentation.
struct OptionTexts {
  std::string flag;     ///< "--min-wall"; "--no-quiet-zone" for a switch that is on by default
  std::string values;   ///< "MM", "fast|paper-steps", "MM|free|oriented|best", "X,Y,Z"; empty for a switch
  std::string help;     ///< meaning of the setting
  std::string range;    ///< "0 to 1000"; empty if there is none
  std::string initial;  ///< default; empty: the setting is required
};
OptionTexts optionTexts(const Setting& setting);

}  // namespace qrelief
