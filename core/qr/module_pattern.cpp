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

const Picture& pictureOf(FinderPattern pattern, ModulePattern modules) {
  switch (pattern) {
    case FinderPattern::None:
      return kNone;
    case FinderPattern::AsModules:
      return pictureOf(modules);
    case FinderPattern::Diamond:
      return kDiamond;
    case FinderPattern::ThickPlus:
    case FinderPattern::ThickPlusSharp:
      return kThickPlus;
  }
  return kNone;
}

/// Returns +1 at the near end of a finder, -1 at the far end, 0 between, along one axis. In a corner module neither
/// axis gives 0, and the values point towards the finder's centre.
int towardsCentre(int position, int size) {
  const int within = position < kFinderModules ? position : position - (size - kFinderModules);
  return within == 0 ? 1 : within == kFinderModules - 1 ? -1 : 0;
}

void carveModule(SubmoduleMask& mask, const Picture& picture, int row, int column, int shiftDown, int shiftRight) {
  constexpr int n = kSubmodulesPerModule;
  for (int k = 0; k < n; ++k) {
    for (int l = 0; l < n; ++l) {
      if (picture[k][l] != '#') continue;
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

SubmoduleMask submodulesToCarve(const Symbol& symbol, ModulePattern modules, FinderPattern finders) {
  SubmoduleMask mask(kSubmodulesPerModule * symbol.size, kSubmodulesPerModule * symbol.size);
  const bool squareCorners = finders == FinderPattern::Diamond || finders == FinderPattern::ThickPlus;
  for (int row = 0; row < symbol.size; ++row) {
    for (int column = 0; column < symbol.size; ++column) {
      if (!symbol.isDark(row, column)) continue;
      if (symbol.role(row, column) != ModuleRole::Finder) {
        carveModule(mask, pictureOf(modules), row, column, 0, 0);
        continue;
      }
      const int down = towardsCentre(row, symbol.size), right = towardsCentre(column, symbol.size);
      if (squareCorners && down != 0 && right != 0) {
        carveModule(mask, kSquare, row, column, down, right);
      } else {
        carveModule(mask, pictureOf(finders, modules), row, column, 0, 0);
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
