// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>

#include "io/write_model.h"
#include "mesh/prepare.h"
#include "pipeline/engrave.h"

namespace qrelief {

/// A carved model as 3MF.
struct Carved3mf {
  std::vector<std::uint8_t> bytes;
  std::optional<Message> notKept;  ///< why the contents of the model's own 3MF file are lost
};

/// Writes a carved model as 3MF. If the model comes from a 3MF file, this file is written again with the carved
/// object's new mesh, and everything else stays as it was (io/rewrite_3mf.h): other objects, names, plates, modifiers,
/// and the paint of facets. Facets under the code lose their paint. Pieces of facets that the code's edge cuts keep it
/// if it covers the whole facet; paint that divides a cut facet is lost. Where the file cannot be written again, the
/// models' objects are written anew (carvedObjects()).
/// @param before     the model before carving
/// @param partNames  names of the model's parts; empty: one part only
/// @param painted    triangles of the carved mesh in the second filament, ascending
/// @returns the errors of writeChecked()
Result<Carved3mf> writeCarved3mf(const PreparedModel& before, const EngraveResult& result,
                                 std::span<const std::string> partNames, bool withInlay, const WriteOptions& options,
                                 std::span<const std::uint32_t> painted = {});

}  // namespace qrelief
