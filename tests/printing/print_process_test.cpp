// SPDX-License-Identifier: GPL-3.0-or-later
#include "printing/print_process.h"

#include <gtest/gtest.h>
#include <string>

namespace qrelief {
namespace {

TEST(PrintProcess, EveryNamedPrinterHasAProcess) {
  for (const NamedPrinter& named : namedPrinters()) {
    const auto process = processOf(named.printer);
    ASSERT_TRUE(process) << named.name;
    EXPECT_EQ(process->layerMm, named.printer.layerMm) << named.name;
    EXPECT_LE(process->layerMm, process->finestMm) << named.name;
  }
}

TEST(PrintProcess, LineWidthsDefaultToTheSlicersProfiles) {
  EXPECT_DOUBLE_EQ(processOf({.nozzleMm = 0.4})->cornerRadiusMm, 0.45 / 2);
  EXPECT_DOUBLE_EQ(processOf({.nozzleMm = 0.4, .lineWidthMm = 0.6})->cornerRadiusMm, 0.3);
}

TEST(PrintProcess, RefusesImpossiblePrinters) {
  const auto code = [](const Printer& printer) {
    const auto process = processOf(printer);
    return process ? std::string() : process.error().message.code;
  };
  EXPECT_EQ(code({.nozzleMm = 0.4, .layerMm = 0.5}), "layer-above-nozzle");
  EXPECT_EQ(code({.nozzleMm = 0.4, .layerMm = 0}), "layer-above-nozzle");
  EXPECT_EQ(code({.nozzleMm = 0.4, .layerMm = 0.2, .lineWidthMm = 0.3}), "line-below-nozzle");
  EXPECT_EQ(code({.nozzleMm = 0.4, .layerMm = 0.05, .technique = PrintTechnique::Resin}), "");
}

}  // namespace
}  // namespace qrelief
