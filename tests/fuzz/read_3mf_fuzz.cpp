// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes are a 3MF file. Changed archive content seldom passes the checksums, so this target tests the archive
// itself; read_3mf_parts_fuzz tests its content.
#include "fuzz/check.h"
#include "io/three_mf/read_3mf.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace qrelief;
  fuzz::checkSoup(read3mf(fuzz::bytesOf(data, size), fuzz::kLimits));
  return 0;
}
