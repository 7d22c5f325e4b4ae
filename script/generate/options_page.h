// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace qrelief {

/// Returns docs/options.md: every setting by its group, with its flag, its key in JSON, values, meaning and default.
std::string optionsPage();

}  // namespace qrelief
