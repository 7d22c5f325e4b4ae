// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "qr/symbol.h"

namespace qrelief {

/// What a verifier measures of a symbol: the light each module sends back, through an aperture of 80 % of its width.
struct ModuleReflectances {
  const Symbol* symbol = nullptr;
  std::vector<double> values;  ///< linear, 0 … 1; symbol and quiet zone, row-major from the quiet zone's top left

  double at(int row, int column) const {
    const int edge = symbol->size + 2 * kQuietZoneModules;
    return values[static_cast<std::size_t>((row + kQuietZoneModules) * edge + column + kQuietZoneModules)];
  }
};

/// Means over the apertures from means over submodules.
/// @param submodules  linear; symbol and quiet zone, 5 × 5 a module, row-major from the quiet zone's top left
ModuleReflectances measureModules(const Symbol& symbol, const std::vector<double>& submodules);

/// Which modules of a symbol a verifier takes for the other colour, with the threshold of ISO/IEC 29158 for the whole.
/// @returns row-major from the upper left, 1 = taken for the other colour
std::vector<std::uint8_t> misreadModules(const ModuleReflectances& measured);

struct Grade {
  double value = 0;  ///< in the parameter's own unit
  double grade = 0;  ///< 4 = A … 0 = F
};

/// Grades after ISO/IEC 15415 for printed symbols, and ISO/IEC 29158 for direct part marks, of a *simulated*
/// picture: a real verifier's light, lens and calibration are not in it, so the grades compare carvings, they certify
/// none. Axial and grid nonuniformity are those of the projection and hence 0: not listed.
struct SymbolGrades {
  Grade decode;              ///< 1: the blocks can be corrected as sampled; grade 4 or 0
  Grade unusedCorrection;    ///< UEC: fraction of the error correction that is left, worst block
  Grade fixedPatternDamage;  ///< finders with separators, timing, alignment: the worst; value = damaged modules
  Grade formatInformation;   ///< value = wrong bits of both copies; version information too, from version 7 on
  // ISO/IEC 15415
  Grade symbolContrast;     ///< SC = brightest − darkest module, of 1
  Grade modulation;         ///< value = least MOD; grade allows for what error correction repairs
  Grade reflectanceMargin;  ///< as modulation, modules on the wrong side of the threshold counting 0
  double iso15415 = 0;      ///< the least of the above
  // ISO/IEC 29158
  Grade cellContrast;    ///< CC = (ML − MD) / ML, of the means of light and dark modules
  Grade cellModulation;  ///< value = least CMOD
  double iso29158 = 0;   ///< the least of CC, CMOD and the first four
};

/// @param measured  of a symbol whose colours are the wanted ones
/// @param white     reflectance of an unoccluded surface of the material, 0 … 1, for symbol contrast
SymbolGrades gradeSymbol(const ModuleReflectances& measured, double white);

}  // namespace qrelief
