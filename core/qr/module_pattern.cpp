// SPDX-License-Identifier: GPL-3.0-or-later
#include "qr/module_pattern.h"

#include <array>
#include <cstddef>
#include <utility>

namespace qrelief {
namespace {

/// A pattern's picture as in the header; '#' is carved.
using Picture = std::array<std::string_view, kSubmodulesPerModule>;

constexpr Picture kNone = {"#####", "#####", "#####", "#####", "#####"};
constexpr Picture kSquare = {".....", ".###.", ".###.", ".###.", "....."};
constexpr Picture kThinPlus = {".....", "..#..", ".###.", "..#..", "....."};
constexpr Picture kDiamond = {"..#..", ".###.", "#####", ".###.", "..#.."};
constexpr Picture kThickPlus = {".###.", "#####", "#####", "#####", ".###."};

const Picture& pictureOf(ModulePattern pattern) {
  switch (pattern) {
    case ModulePattern::None:
      return kNone;
    case ModulePattern::Square:
      return kSquare;
    case ModulePattern::ThinPlus:
      return kThinPlus;
    case ModulePattern::Diamond:
      return kDiamond;
    case ModulePattern::ThickPlus:
      return kThickPlus;
  }
  return kNone;
}

ModuleMask maskOf(FinderPattern pattern, const ModuleMask& modules) {
  switch (pattern) {
    case FinderPattern::None:
      return ModulePattern::None;
    case FinderPattern::AsModules:
      return modules;
    case FinderPattern::Diamond:
      return ModulePattern::Diamond;
    case FinderPattern::ThickPlus:
    case FinderPattern::ThickPlusSharp:
      return ModulePattern::ThickPlus;
  }
  return ModulePattern::None;
}

/// Returns +1 at the near end of a finder, -1 at the far end, 0 between, along one axis. In a corner module neither
/// axis gives 0, and the values point towards the finder's centre.
int towardsCentre(int position, int size) {
  const int within = position < kFinderModules ? position : position - (size - kFinderModules);
  return within == 0 ? 1 : within == kFinderModules - 1 ? -1 : 0;
}

void carveModule(SubmoduleMask& mask, const ModuleMask& module, int row, int column, int shiftDown, int shiftRight) {
  constexpr int n = kSubmodulesPerModule;
  for (int k = 0; k < n; ++k) {
    for (int l = 0; l < n; ++l) {
      if (!module.carved[k * n + l]) continue;
      const int y = row * n + k + shiftDown, x = column * n + l + shiftRight;
      mask.at(y, x) = 1;
    }
  }
}

// In the order of the enumerators.
constexpr std::array<std::string_view, 5> kModulePatternNames = {"none", "square", "thin-plus", "diamond",
                                                                 "thick-plus"};
constexpr std::array<std::string_view, 5> kFinderPatternNames = {"none", "as-modules", "diamond", "thick-plus",
                                                                 "thick-plus-sharp"};

}  // namespace

ModuleMask::ModuleMask(ModulePattern pattern) {
  const Picture& picture = pictureOf(pattern);
  for (std::size_t k = 0; k < carved.size(); ++k)
    carved[k] = picture[k / kSubmodulesPerModule][k % kSubmodulesPerModule] == '#';
}

std::optional<ModuleMask> moduleMaskFromText(std::string_view text) {
  constexpr std::size_t n = kSubmodulesPerModule;
  if (text.size() != n * n + n - 1) return {};
  ModuleMask mask;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const std::size_t row = k / (n + 1), column = k % (n + 1);
    const bool isSubmodule = column < n;
    if (isSubmodule ? text[k] != '0' && text[k] != '1' : text[k] != '/') return {};
    if (isSubmodule) mask.carved[row * n + column] = text[k] == '1';
  }
  if (mask.carved.all() || mask.carved.none()) return {};
  return mask;
}

std::string moduleMaskText(const ModuleMask& mask) {
  std::string text;
  for (std::size_t k = 0; k < mask.carved.size(); ++k) {
    if (k > 0 && k % kSubmodulesPerModule == 0) text += '/';
    text += mask.carved[k] ? '1' : '0';
  }
  return text;
}

SubmoduleMask submodulesToCarve(const Symbol& symbol, const ModuleMask& modules, FinderPattern finders) {
  SubmoduleMask mask(kSubmodulesPerModule * symbol.size, kSubmodulesPerModule * symbol.size);
  const bool squareCorners = finders == FinderPattern::Diamond || finders == FinderPattern::ThickPlus;
  for (int row = 0; row < symbol.size; ++row) {
    for (int column = 0; column < symbol.size; ++column) {
      if (!symbol.isDark(row, column)) continue;
      if (symbol.role(row, column) != ModuleRole::Finder) {
        carveModule(mask, modules, row, column, 0, 0);
        continue;
      }
      const int down = towardsCentre(row, symbol.size), right = towardsCentre(column, symbol.size);
      if (squareCorners && down != 0 && right != 0) {
        carveModule(mask, ModulePattern::Square, row, column, down, right);
      } else {
        carveModule(mask, maskOf(finders, modules), row, column, 0, 0);
      }
    }
  }
  return mask;
}

std::string_view modulePatternName(ModulePattern pattern) {
  return kModulePatternNames[static_cast<std::size_t>(pattern)];
}

std::string_view finderPatternName(FinderPattern pattern) {
  return kFinderPatternNames[static_cast<std::size_t>(pattern)];
}

}  // namespace qrelief
