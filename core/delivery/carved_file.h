// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>

#include "base/result.h"
#include "io/write_files.h"
#include "mesh/prepare.h"

namespace qrelief {

struct EngraveResult;

/// A carved model as 3MF.
struct Carved3mf {
  std::vector<std::uint8_t> bytes;
  std::optional<Message> notKept;  ///< why the contents of the model's own 3MF file are lost
};

/// A carved model as files.
struct CarvedFiles {
  std::vector<NamedFile> files;    ///< the named one first (io/write_files.h)
  std::optional<Message> notKept;  ///< why the contents of the model's own 3MF file are lost, see writeCarved3mf()
};

/// Writes a carved model as 3MF. If the model comes from a 3MF file, that file is rewritten with a new mesh for the
/// carved object, and everything else stays as it was (io/three_mf/rewrite_3mf.h): other objects, names, plates,
/// modifiers, and the paint of facets. Facets under the code lose their paint. If the code's edge cuts a facet, its
/// pieces keep paint that covers the whole facet, and lose paint that divides it. If the file cannot be rewritten, the
/// model's objects are written anew (carvedObjects()).
/// @param before     the model before carving
/// @param partNames  names of the model's parts; empty: one part only
/// @returns the errors of writeChecked()
Result<Carved3mf> writeCarved3mf(const PreparedModel& before, const EngraveResult& result,
                                 std::span<const std::string> partNames, bool withInlay, const WriteOptions& options);

/// Encodes a carved model in the format that the file name implies, with all files that the format needs. Includes the
/// inlay of Mark::Inlay.
/// @param before     the model before carving
/// @param partNames  names of the model's parts (PolygonSoup::parts), for 3MF and OBJ; empty: one part only
/// @returns the errors of writeCheckedFiles()
Result<CarvedFiles> encodeCarved(const PreparedModel& before, const EngraveResult& result, const std::string& fileName,
                                 std::span<const std::string> partNames = {}, const WriteOptions& options = {});

}  // namespace qrelief
