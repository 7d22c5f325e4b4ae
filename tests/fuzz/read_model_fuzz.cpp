// SPDX-License-Identifier: GPL-3.0-or-later
// The first byte chooses the file's name, the rest is its content. Tests readModel with misleading names, and
// prepareModel with the result.
#include <array>

#include "fuzz/check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace qrelief;
  constexpr std::array<std::string_view, 8> kNames = {"a.stl", "a.OBJ", "a.ply", "a.off", "a.3mf", "a.glb", "a", ""};
  if (size == 0) return 0;
  const auto soup = readModel(fuzz::bytesOf(data + 1, size - 1), kNames[data[0] % kNames.size()], fuzz::kLimits);
  fuzz::checkSoup(soup);
  if (soup) fuzz::checkPrepared(prepareModel(*soup, {}));
  return 0;
}
