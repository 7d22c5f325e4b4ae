// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace qrelief {

/// Folder of the sources, for tests that read the project's own files.
std::filesystem::path sourceFolder();

}  // namespace qrelief
