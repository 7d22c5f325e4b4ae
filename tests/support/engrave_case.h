// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "pipeline/engrave.h"
#include "support/choices.h"

namespace qrelief {

/// A made-up model and what is asked of it.
struct EngraveCase {
  std::string shape;  ///< "torus"
  Mesh mesh;
  EngraveRequest request;

  /// In one line, for reports.
  std::string describe() const;
};

/// Solids round, saddled, boxy, thin, hollow, noisy, coarse, with slivers, in several shells, a few of them with a
/// hole; turned and moved; and requests of every kind, centres exactly on vertices and edges included. Everything a
/// user may ask for is asked for, so some requests have no solution.
EngraveCase makeEngraveCase(Choices& choices);

}  // namespace qrelief
