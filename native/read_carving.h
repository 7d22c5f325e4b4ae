// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "base/progress.h"
#include "verdict/verdict.h"

namespace qrelief {

/// Text that ZXing decodes from pictures of a carving.
ReadingEvidence readCarving(const EngraveRequest& request, const EngraveResult& result);

/// What ZXing makes of a carved model as it comes off the printer; nothing if the request names no process.
/// @param carved    a solid
/// @param progress  of the printing and tracing
Result<std::optional<PrintedEvidence>> readPrinted(const VerifyRequest& request, const Mesh& carved,
                                                   const std::function<void(const Progress&)>& progress);

}  // namespace qrelief
