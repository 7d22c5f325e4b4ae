// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/write_model.h"

namespace qrelief {

/// 3MF in millimetres: an item of the build for every object; bodies of one object are its components, so that they
/// keep their places to each other.
///
/// Where a body has a colour, the extruder that prints it (the first for the first colour, and so on) is said in the
/// way that each slicer looks for:
/// - all: `m:colorgroup` of the materials extension, by that prefix and required (Bambu Studio and OrcaSlicer read no
///   other; they turn it into filaments);
/// - Bambu Studio, OrcaSlicer: a part with its extruder in Metadata/model_settings.config;
/// - PrusaSlicer, which reads no colours: an extruder for every mesh in Metadata/Slic3r_PE_model.config; it asks
///   whether meshes at several heights are parts of one object: yes, and it numbers the extruders in the same order;
/// - Cura: `cura:extruder_nr` in each mesh's group of metadata.
Result<std::vector<std::uint8_t>> write3mf(std::span<const ModelObject> objects, const WriteOptions& options);

}  // namespace qrelief
