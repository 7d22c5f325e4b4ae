// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "pipeline/engrave.h"

namespace qrelief {

/// Whether every number of a request is one that can be worked with; nothing is computed.
/// @returns BadUsage for the first that is not: what it is, and which values are possible
Status checkRequest(const EngraveRequest& request);

}  // namespace qrelief
