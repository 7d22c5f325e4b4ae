// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes are a 3MF file. What is in its archive seldom gets past the check sums once it has been changed, so this is
// about the archive itself; read_3mf_parts_fuzz is about what is in it.
#include "fuzz/check.h"
#include "io/read_3mf.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace qrelief;
  fuzz::checkSoup(read3mf(fuzz::bytesOf(data, size), fuzz::kLimits));
  return 0;
}
