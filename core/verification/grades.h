// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/grid.h"
#include "qr/symbol.h"

namespace qrelief {

/// A verifier's measurements of a symbol: the light that each module reflects, through an aperture of 80 % of its
/// width.
struct ModuleReflectances {
  const Symbol* symbol = nullptr;
  Grid<double> values;  ///< linear, 0 … 1; symbol and quiet zone

  double at(int row, int column) const { return values.at(row + kQuietZoneModules, column + kQuietZoneModules); }
};

/// Averages submodules over the aperture of each module.
/// @param submodules  linear; symbol and quiet zone, 5 × 5 per module
ModuleReflectances measureModules(const Symbol& symbol, const Grid<double>& submodules);

/// Finds the modules that a verifier takes for the other colour, with the threshold of ISO/IEC 29158 for the whole
/// symbol.
/// @returns 1 = taken for the other colour
Grid<std::uint8_t> misreadModules(const ModuleReflectances& measured);

struct Grade {
  double value = 0;  ///< in the parameter's own unit
  double grade = 0;  ///< 4 = A … 0 = F
};

/// Grades by ISO/IEC 15415 for printed symbols, and ISO/IEC 29158 for direct part marks, of a *simulated* picture. A
/// real verifier's light, lens and calibration are not simulated, so use the grades to compare carvings; they are not a
/// certificate. Axial and grid nonuniformity come from the projection alone and are 0, so they are not listed.
struct SymbolGrades {
  Grade decode;              ///< value 1: the blocks can be corrected as sampled; grade 4 or 0
  Grade unusedCorrection;    ///< UEC: unused fraction of the error correction, worst block
  Grade fixedPatternDamage;  ///< worst of finder patterns with separators, timing and alignment; value = damaged
                             ///< modules
  Grade formatInformation;   ///< value = wrong bits of both copies; includes version information from version 7 on
  // ISO/IEC 15415
  Grade symbolContrast;     ///< SC = brightest − darkest module, of 1
  Grade modulation;         ///< value = least MOD; grade allows for what error correction repairs
  Grade reflectanceMargin;  ///< as modulation, but modules on the wrong side of the threshold count 0
  double iso15415 = 0;      ///< the least of the above
  // ISO/IEC 29158
  Grade cellContrast;    ///< CC = (ML − MD) / ML, from the means of light and dark modules
  Grade cellModulation;  ///< value = least CMOD
  double iso29158 = 0;   ///< the least of CC, CMOD and the first four
};

/// Grades a symbol.
/// @param measured  from a symbol whose colours are the wanted ones
/// @param white     reflectance of an unoccluded surface of the material, 0 … 1, for symbol contrast
SymbolGrades gradeSymbol(const ModuleReflectances& measured, double white);

}  // namespace qrelief
