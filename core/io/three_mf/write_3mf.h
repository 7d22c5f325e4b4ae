// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/write_model.h"
#include "math/affine.h"

namespace qrelief {

/// Writes 3MF in millimetres, with one build item per object.
///
/// Colours become filaments: the first for the first colour, and so on. Each slicer looks for them in a different
/// place, and `slicer` chooses (docs/decisions/0044):
/// - Any: bodies are components. Each has a colour group of one colour (`m:colorgroup` of the materials extension, with
///   exactly that prefix), an extruder in Metadata/model_settings.config and in Metadata/Slic3r_PE_model.config, and
///   `cura:extruder_nr`. PrusaSlicer asks whether meshes at several heights are parts of one object. Objects with
///   painted facets have a part file of their own, and each painted facet has the attributes of all programs and its
///   colour. `basematerials` of the core specification name the materials of the colours, in the same order.
/// - PrusaSlicer: one mesh for each object, which Metadata/Slic3r_PE_model.config divides into volumes, each with its
///   extruder. Nothing is asked. Painted facets have `slic3rpe:mmu_segmentation`.
/// - OrcaSlicer, BambuStudio: one part file for each object, which the root model refers to by components, because some
///   versions drop the paint of meshes in the root model; extruders in Metadata/model_settings.config;
///   `paint_color`; colour groups. All objects together are moved to the middle of a plate.
///
/// With `palette`, a file for OrcaSlicer or Bambu Studio says that Bambu Studio wrote it, and
/// Metadata/project_settings.config lists the colours. Only then do these programs take over the filaments' colours.
Result<std::vector<std::uint8_t>> write3mf(std::span<const ModelObject> objects, const WriteOptions& options);

/// Returns true if files for that program can list the filaments' colours.
bool hasPalette(Slicer slicer);

/// Returns the transform of each object's item, mm: it turns the object's `up` to the printer's vertical and moves it
/// to its place. If an object is turned, all together stand on the plate, with their middle above where it was.
std::vector<Affine> posesOnPlate(std::span<const ModelObject> objects, Slicer slicer);

}  // namespace qrelief
