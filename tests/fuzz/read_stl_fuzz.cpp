// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes are an STL file.
#include "fuzz/check.h"
#include "io/read_stl.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace qrelief;
  fuzz::checkSoup(readStl(fuzz::bytesOf(data, size), fuzz::kLimits));
  return 0;
}
