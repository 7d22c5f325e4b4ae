// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes are the parts of a 3MF file, separated by zero bytes: first the main model, then the models that its paths
// may name, a.model, b.model, … Parts that begin with "<config" are the model settings of both slicer families. The
// archive that delivers them has correct checksums. Files that can be read are written again.
#include <algorithm>
#include <fmt/format.h>
#include <string>

#include "fuzz/check.h"
#include "io/three_mf/read_3mf.h"
#include "io/three_mf/rewrite_3mf.h"
#include "io/three_mf/volumes.h"
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
  bool hasSettings = false;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const bool isSettings = parts[i].starts_with("<config") && !hasSettings;
    hasSettings |= isSettings;
    if (!isSettings) others.push_back({fmt::format("{}.model", kNames[i - 1]), parts[i]});
    if (isSettings)
      for (const std::string_view name : {kBambuSettings, kPrusaSettings})
        others.push_back({std::string(name), parts[i]});
  }
  return zip_file::threeMf(parts.front(), others);
}

/// Writes the file again with an own triangle in place of its first run.
void writeAgain(const PolygonSoup& soup) {
  ChangedRun change;
  change.mesh = {{Vec3f(0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)}, {{0, 1, 2}}};
  change.kept = {{KeptAttributes::What::WholePaint, 0}};
  change.painted = {0};
  change.inlay = ModelBody{"inlay", change.mesh, {}};
  const auto written = rewrite3mf(*soup.source, std::span(&change, 1), Slicer::Any, {});
  if (written)
    require(read3mf(*written, {}).has_value(), "what is written can be read");
  else
    checkError(written.error());
}

}  // namespace
}  // namespace qrelief::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace qrelief;
  const std::string_view parts(reinterpret_cast<const char*>(data), size);
  const auto soup = read3mf(fuzz::fileFrom(parts), fuzz::kLimits);
  fuzz::checkSoup(soup);
  if (soup) fuzz::writeAgain(*soup);
  return 0;
}
