// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes are a PLY file.
#include "fuzz/check.h"
#include "io/read_ply.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace qrelief;
  fuzz::checkSoup(readPly(fuzz::bytesOf(data, size), fuzz::kLimits));
  return 0;
}
