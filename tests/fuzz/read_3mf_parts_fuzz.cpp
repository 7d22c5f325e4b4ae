// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes are the parts of a 3MF file, separated by zero bytes: first the main model, then the models that its paths
// may name, a.model, b.model, … The archive that delivers them has correct checksums.
#include <algorithm>
#include <fmt/format.h>
#include <string>

#include "fuzz/check.h"
#include "io/read_3mf.h"
#include "support/zip_file.h"

namespace qrelief::fuzz {
namespace {

std::vector<std::uint8_t> fileFrom(std::string_view text) {
  constexpr std::string_view kNames = "abcdef";
  std::vector<std::string> parts;
  for (;;) {
    const std::size_t end = std::min(text.find('\0'), text.size());
    parts.emplace_back(text.substr(0, end));
    if (end == text.size() || parts.size() > kNames.size()) break;
    text.remove_prefix(end + 1);
  }
  std::vector<zip_file::File> others;
  for (std::size_t i = 1; i < parts.size(); ++i) others.push_back({fmt::format("{}.model", kNames[i - 1]), parts[i]});
  return zip_file::threeMf(parts.front(), others);
}

}  // namespace
}  // namespace qrelief::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace qrelief;
  const std::string_view parts(reinterpret_cast<const char*>(data), size);
  fuzz::checkSoup(read3mf(fuzz::fileFrom(parts), fuzz::kLimits));
  return 0;
}
