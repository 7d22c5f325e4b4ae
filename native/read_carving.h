// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "base/progress.h"
#include "verdict/verdict.h"

namespace qrelief {

/// Decodes pictures of a carving with ZXing.
ReadingEvidence readCarving(const EngraveRequest& request, const EngraveResult& result);

/// Simulates the print of a carved model and decodes it with ZXing; none if the request names no process.
/// @param carved    a solid
/// @param progress  of printing and tracing
Result<std::optional<PrintedEvidence>> readPrinted(const VerifyRequest& request, const Mesh& carved,
                                                   const std::function<void(const Progress&)>& progress);

}  // namespace qrelief
