// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace qrelief {

extern const char* const kVersion;  ///< such as "0.2.0"

}  // namespace qrelief
