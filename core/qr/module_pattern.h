// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bitset>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/grid.h"
#include "qr/symbol.h"

namespace qrelief {

/// Submodules along a module's edge [Papp 2022, §5].
inline constexpr int kSubmodulesPerModule = 5;

/// The same for the quiet zone on each side.
inline constexpr int kQuietZoneSubmodules = kSubmodulesPerModule * kQuietZoneModules;

/// The carved submodules of a dark module [Papp 2022, §6, figure 7].
///
///     None     Square   ThinPlus Diamond  ThickPlus
///     #####    .....    .....    ..#..    .###.
///     #####    .###.    ..#..    .###.    #####
///     #####    .###.    .###.    #####    #####
///     #####    .###.    ..#..    .###.    #####
///     #####    .....    .....    ..#..    .###.
enum class ModulePattern : std::uint8_t { None, Square, ThinPlus, Diamond, ThickPlus };

/// The carved submodules of one dark module: a named pattern, or a mask drawn by the user.
struct ModuleMask {
  std::bitset<kSubmodulesPerModule * kSubmodulesPerModule> carved;  ///< row by row from the module's top left

  ModuleMask() = default;
  ModuleMask(ModulePattern pattern);  // implicit: a pattern is a mask

  bool operator==(const ModuleMask&) const = default;
};

/// Parses a mask: five rows of five submodules, 1 = carved, such as `00100/01110/11111/01110/00100`.
/// @returns none for any other text, and if all submodules or none are carved
std::optional<ModuleMask> moduleMaskFromText(std::string_view text);

/// Writes a mask in this form.
std::string moduleMaskText(const ModuleMask& mask);

/// Edge of a finder pattern, in modules.
inline constexpr int kFinderModules = 7;

/// The carved submodules of the 7×7 finder patterns, the paper's position markers [figure 9]. With Diamond and
/// ThickPlus, the four corner modules of the ring become a Square, shifted by one submodule towards the finder's centre
/// along both axes so that it touches its neighbours. ThickPlusSharp keeps its corners whole: more decoders found it in
/// simulated pictures.
enum class FinderPattern : std::uint8_t { None, AsModules, Diamond, ThickPlus, ThickPlusSharp };

/// The submodules of a symbol to carve: 1 = carved.
using SubmoduleMask = Grid<std::uint8_t>;

SubmoduleMask submodulesToCarve(const Symbol& symbol, const ModuleMask& modules, FinderPattern finders);

/// Return names that scripts rely on, such as "thin-plus".
std::string_view modulePatternName(ModulePattern pattern);
std::string_view finderPatternName(FinderPattern pattern);

}  // namespace qrelief
