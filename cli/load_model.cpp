// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/load_model.h"

#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/files.h"
#include "io/read_model.h"

namespace qrelief {

Result<LoadedModel> loadEngravable(const std::string& path, double scale, const std::string& units) {
  const Result<double> scaleToMm = scaleFrom(scale, units);
  if (!scaleToMm) return tl::unexpected(scaleToMm.error());
  const auto bytes = readFile(path);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto soup = readModel(*bytes, path);
  if (!soup) return tl::unexpected(soup.error());
  auto prepared = prepareModel(*soup, {.scaleToMm = *scaleToMm});
  if (!prepared) return tl::unexpected(prepared.error());
  for (const std::string& warning : soup->warnings) fmt::print(stderr, "qrelief: {}\n", warning);
  for (const Finding& finding : prepared->findings)
    if (finding.severity == Finding::Severity::Warning) fmt::print(stderr, "qrelief: {}\n", finding.message);
  if (const Status engravable = prepared->engravable(); !engravable) return tl::unexpected(engravable.error());
  return LoadedModel{soup->format, *scaleToMm, std::move(*prepared)};
}

}  // namespace qrelief
