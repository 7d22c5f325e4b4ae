// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "io/read_model.h"
#include "mesh/prepare.h"

/// Invariants that hold for any input bytes. A violation ends the process, which the fuzzer counts as a crash.
namespace qrelief::fuzz {

/// Limits of the readers, small enough for a fuzzer to exceed.
inline constexpr ReadLimits kLimits{.maxBytes = std::size_t{1} << 16, .maxTriangles = 5000};

/// Ends the process with a message unless `holds`.
void require(bool holds, std::string_view promise);

/// Requires kind BadInput or NoSolution, and a message of printable characters (UTF-8 passes) without a full stop at
/// its end.
void checkError(const Error& error);

/// Requires a soup within the limits, with valid indices and finite positions, or BadInput.
void checkSoup(const Result<PolygonSoup>& soup);

/// Requires a mesh that keeps the promises of mesh/prepare.h, checked by plain counting, or BadInput.
void checkPrepared(const Result<PreparedModel>& prepared);

inline std::span<const std::uint8_t> bytesOf(const std::uint8_t* data, std::size_t size) { return {data, size}; }

}  // namespace qrelief::fuzz

/// libFuzzer's entry point.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
