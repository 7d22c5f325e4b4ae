// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/version.h"

namespace qrelief {

const char* const kVersion = QRELIEF_VERSION;

}  // namespace qrelief
