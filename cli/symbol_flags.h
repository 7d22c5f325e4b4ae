// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "qr/symbol.h"

namespace qrelief {

/// What the command line says about the symbol.
struct SymbolFlags {
  std::string ecc, mask = "auto";  ///< no ecc: M, raised where that needs no larger version
  int version = 0;                 ///< 0: the smallest
  bool raiseEcc = false, breakUp = false;
};

/// Adds --ecc, --raise-ecc, --version, --mask and --break-up.
void addSymbolFlags(CLI::App& command, SymbolFlags& flags);

SymbolOptions symbolOptionsFrom(const SymbolFlags& flags);

}  // namespace qrelief
