// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verdict/verdict.h"

namespace qrelief {

/// Judges whether people can read a text alone, by the size of its letters.
Aspect judgeLegibility(const EngraveRequest& request, const EngraveResult& result);

/// Judges whether the printer makes the strokes of a text alone.
Aspect judgeStrokes(const EngraveRequest& request, const EngraveResult& result);

}  // namespace qrelief
