// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict/print_words.h"

#include <cmath>

#include "message_codes/verdict.h"
#include "printing/print_process.h"

namespace qrelief {

Message facing(double facingDeg) {
  constexpr double kFacingDeg = 15;
  if (facingDeg <= kFacingDeg) return message<"facing-up">();
  if (std::abs(facingDeg - 90) <= kFacingDeg) return message<"facing-aside">();
  return facingDeg < 90 ? message<"facing-slanted">(with::angleDeg<"angle">(std::round(facingDeg)))
                        : message<"facing-down">(with::angleDeg<"angle">(std::round(facingDeg)));
}

Message printing(const Printer& printer) {
  switch (printer.technique) {
    case PrintTechnique::Filament:
      break;
    case PrintTechnique::Resin:
      return message<"printed-in-resin">(with::lengthMm<"layer">(printer.layerMm));
    case PrintTechnique::Powder:
      return message<"printed-in-powder">(with::lengthMm<"layer">(printer.layerMm));
  }
  return message<"printed-by-nozzle">(with::lengthMm<"nozzle">(printer.nozzleMm),
                                      with::lengthMm<"layer">(printer.layerMm));
}

}  // namespace qrelief
