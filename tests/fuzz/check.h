// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "io/read_model.h"
#include "mesh/prepare.h"

/// What must hold whatever the bytes are. A broken promise ends the process, which the fuzzer takes for a crash.
namespace qrelief::fuzz {

/// Small, so that going beyond them is within a fuzzer's reach.
inline constexpr ReadLimits kLimits{.maxBytes = std::size_t{1} << 16, .maxTriangles = 5000};

/// Ends the process with a message unless `holds`.
void require(bool holds, std::string_view promise);

/// An error of the given kinds, with a message of printable characters (UTF-8 passes) and no full stop at its end.
void checkError(const Error& error);

/// Either a soup within the limits, whose indices are valid and whose positions are finite, or BadInput.
void checkSoup(const Result<PolygonSoup>& soup);

/// Either a mesh of the kind that the header promises, searched by plain counting, or BadInput.
void checkPrepared(const Result<PreparedModel>& prepared);

inline std::span<const std::uint8_t> bytesOf(const std::uint8_t* data, std::size_t size) { return {data, size}; }

}  // namespace qrelief::fuzz

/// libFuzzer's entry point.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
