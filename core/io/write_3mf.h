// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/write_model.h"

namespace qrelief {

/// Writes 3MF in millimetres, with one build item per object. Bodies of one object are its components, so they keep
/// their relative positions.
///
/// A body with a colour gets an extruder: the first for the first colour, and so on. Each slicer looks for it in a
/// different place:
/// - all: `m:colorgroup` of the materials extension, with exactly that prefix and marked as required (Bambu Studio and
///   OrcaSlicer read no other; they turn it into filaments);
/// - Bambu Studio, OrcaSlicer: a part with its extruder in Metadata/model_settings.config;
/// - PrusaSlicer, which reads no colours: an extruder for every mesh in Metadata/Slic3r_PE_model.config. It asks
///   whether meshes at several heights are parts of one object; if you answer yes, it numbers the extruders in the same
///   order;
/// - Cura: `cura:extruder_nr` in the metadata group of each mesh.
Result<std::vector<std::uint8_t>> write3mf(std::span<const ModelObject> objects, const WriteOptions& options);

}  // namespace qrelief
