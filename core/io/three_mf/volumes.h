// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/message.h"
#include "io/three_mf/xml_reader.h"
#include "io/zip_archive.h"

namespace qrelief {

inline constexpr std::string_view kBambuSettings = "Metadata/model_settings.config";
inline constexpr std::string_view kPrusaSettings = "Metadata/Slic3r_PE_model.config";

/// What a slicer says of a volume or part.
struct VolumeTraits {
  std::string name;            ///< UTF-8; may be empty
  std::uint32_t filament = 0;  ///< from 1; its own or that of its object; 0: none is given
};

/// A range of a mesh's triangles, as PrusaSlicer divides it into volumes.
struct VolumeRange {
  std::size_t first = 0, last = 0;  ///< both included; first > last if the file has no such numbers
  bool isModel = true;              ///< false: a modifier, negative volume, support blocker or enforcer
  VolumeTraits traits = {};
};

/// Returns true if every range lies within a mesh and no two overlap. Triangles may be in no range.
///
/// Cost: O(n log n) in the number of ranges.
bool divideMesh(std::span<const VolumeRange> ranges, std::size_t triangles);

/// The volumes and parts into which slicers divide the objects of a 3MF file.
struct ThreeMfVolumes {
  std::map<std::uint32_t, std::vector<VolumeRange>> ranges;     ///< by object; of PrusaSlicer
  std::set<std::pair<std::uint32_t, std::uint32_t>> notModels;  ///< build object and part; of Bambu Studio, OrcaSlicer
  std::map<std::pair<std::uint32_t, std::uint32_t>, VolumeTraits> parts;  ///< by build object and part; of the same two
  std::size_t plates = 0;  ///< on which the same two arrange the objects; 0: none are named
};

/// Reads kinds, names and filaments of volumes from the model settings of PrusaSlicer, and of Bambu Studio and
/// OrcaSlicer. Kinds that are unknown are models, as in these programs.
/// @param maxBytes   unpacked size of both files
/// @param warnings   gets one for a file that cannot be read; its volumes are then models
ThreeMfVolumes readThreeMfVolumes(const ZipArchive& archive, std::uint64_t maxBytes, std::vector<Message>& warnings);

}  // namespace qrelief
