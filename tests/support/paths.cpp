// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/paths.h"

namespace qrelief {

std::filesystem::path sourceFolder() { return QRELIEF_SOURCE_DIR; }

}  // namespace qrelief
