// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace qrelief {

/// Attributes that hold the paint of a facet. PrusaSlicer compares the whole name, prefix included.
inline constexpr std::string_view kPrusaPaint = "slic3rpe:mmu_segmentation", kBambuPaint = "paint_color";
inline constexpr std::string_view kPrusaSpace = "http://schemas.slic3r.org/3mf/2017/06";
/// Attributes that paint a facet, whole or in pieces, by PrusaSlicer and by Bambu Studio and OrcaSlicer: colours,
/// supports, seams and fuzzy skin.
inline constexpr std::array<std::string_view, 8> kFacetPaints = {
    kPrusaPaint, "slic3rpe:custom_supports", "slic3rpe:custom_seam", "slic3rpe:fuzzy_skin",
    kBambuPaint, "paint_supports",           "paint_seam",           "paint_fuzzy_skin"};

/// Writes the paint of a facet that has one filament all over: "4", "8", "0C", "1C" and so on. The text is a tree of
/// hexadecimal digits, the root last [PrusaSlicer, TriangleSelector::serialize and
/// FacetsAnnotation::get_triangle_as_string].
/// @param filament  1 to 17
std::string filamentCode(unsigned filament);

/// Reads the paint of a facet.
/// @returns the filament; none if the facet has several filaments, or if the text is not a valid code
std::optional<unsigned> filamentOfCode(std::string_view code);

/// Returns the filament of a code in a second colour: 2, or 1 if the body with the code has 2.
inline std::uint32_t secondFilament(std::size_t ofBody) { return ofBody == 2 ? 1 : 2; }

}  // namespace qrelief
