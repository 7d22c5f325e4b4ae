// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "settings/settings.h"

namespace qrelief {

/// What the command and its documentation say of a setting, in English.
struct OptionTexts {
  std::string flag;     ///< "--min-wall"; "--no-quiet-zone" of a switch that is on by default
  std::string values;   ///< "MM", "fast|paper-steps", "MM|free|oriented|best", "X,Y,Z"; empty of a switch
  std::string help;     ///< what it means
  std::string range;    ///< "0 to 1000"; empty if there is none
  std::string initial;  ///< what counts where it is not given; empty: it must be given
};
OptionTexts optionTexts(const Setting& setting);

}  // namespace qrelief
