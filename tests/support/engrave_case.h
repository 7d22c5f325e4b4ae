// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "pipeline/engrave.h"
#include "support/choices.h"

namespace qrelief {

/// Generated model and the request for it.
struct EngraveCase {
  std::string shape;  ///< "torus"
  Mesh mesh;
  EngraveRequest request;

  /// Describes the case in one line, for reports.
  std::string describe() const;
};

/// Generates a solid and a request. Solids are round, saddled, boxy, thin, hollow, noisy, coarse, full of slivers or
/// made of several shells; a few have a hole; they are rotated and moved. Requests cover every setting, with centres
/// exactly on vertices and edges included, so some have no solution.
EngraveCase makeEngraveCase(Choices& choices);

}  // namespace qrelief
