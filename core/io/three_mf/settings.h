// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "io/three_mf/numbering.h"
#include "io/zip_writer.h"

namespace qrelief {

/// Writes Metadata/model_settings.config: the extruder of each object and part, as Bambu Studio and OrcaSlicer read it.
void putBambuSettings(std::span<const NumberedObject> objects, ZipWriter& zip);

/// Writes Metadata/project_settings.config: the filaments' colours, and the entries that both programs require.
void putBambuPalette(const Numbering& numbering, ZipWriter& zip);

/// Writes Metadata/Slic3r_PE_model.config: each mesh's volumes, as ranges of its triangles, with their extruders.
void putPrusaSettings(std::span<const NumberedObject> objects, ZipWriter& zip);

}  // namespace qrelief
