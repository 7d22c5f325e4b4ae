// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "qr/symbol.h"

namespace qrelief {

struct CodeRequest;

/// Returns the symbol of a request; for a text alone the blank symbol, whose square the text fills.
///
/// Cost: milliseconds.
/// @returns the errors of encodeSymbol(), or of layOutLabel() for a text alone
Result<Symbol> requestedSymbol(const CodeRequest& code);

}  // namespace qrelief
