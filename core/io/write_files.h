// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "io/write_model.h"

namespace qrelief {

/// A file and its name.
struct NamedFile {
  std::string name;
  std::vector<std::uint8_t> bytes;
};

/// Returns the names of the files that hold a model in two colours, the given one first: "a.stl" and "a-2.stl", which
/// has the bodies of the second colour; "a.obj" and "a.mtl", which has the colours; for other formats one file.
/// @param name  may have folders; its extension sets the format
std::vector<std::string> fileNames(const std::string& name, bool isTwoColoured);

/// Calls writeChecked() for each file that the objects need. STL gets one file for each colour, OBJ a material for
/// each.
/// @returns the errors of writeChecked(); BadUsage for painted facets in STL
Result<std::vector<NamedFile>> writeCheckedFiles(std::span<const ModelObject> objects, const std::string& name,
                                                 WriteOptions options = {});

}  // namespace qrelief
