// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/printed_view.h"

#include <gmock/gmock.h>

#include "native/read_carving.h"
#include "native/zxing_decoder.h"
#include "pipeline/engrave.h"
#include "support/follow_job.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

class PrintedViewTest : public GlTest {
 protected:
  /// Code on the upper face of a plate, with its `verify` request.
  struct Carved {
    Mesh mesh;
    VerifyRequest request;
  };
  static Carved carved(double symbolMm) {
    const auto model = EngravableModel::upload(*prepareModel(shapes::soupOf(shapes::box({50, 50, 10})), {}));
    EngraveRequest request;
    request.code.text = "QRELIEF";
    request.code.symbol.version = 1;
    request.placement.centreMm = {0, 0, 5};
    request.placement.upHint = {0, 1, 0};
    request.placement.sizeMode = SizeMode::Fixed;
    request.placement.sizeMm = symbolMm;
    const auto result = engrave(model, request);
    EXPECT_TRUE(result.has_value());
    return {result->mesh, verifyRequestOf(request, *result)};
  }
  static std::optional<PrintedEvidence> printed(const Carved& carved, Vec3 buildUp) {
    VerifyRequest request = carved.request;
    request.buildUp = buildUp;
    const auto evidence = readPrinted(request, carved.mesh, [](const Progress&) {});
    return evidence.value_or(std::nullopt);
  }
};

TEST_F(PrintedViewTest, IsPrintedAndThenLit) {
  const Carved plate = carved(25.2);
  EXPECT_THAT(followJob(**PrintedViewJob::create(plate.mesh, **printedViewOf(plate.request))),
              testing::ElementsAre("printing", "lighting-print"));
}

TEST_F(PrintedViewTest, ModulesMuchWiderThanTheNozzleDecodeInPrintLyingAndStanding) {
  const Carved plate = carved(25.2);
  const std::pair<Vec3, double> cases[] = {{{0, 0, 1}, 0}, {{0, 2, 0}, 90}};
  for (const auto& [up, facingDeg] : cases) {
    const auto evidence = printed(plate, up);
    ASSERT_TRUE(evidence) << facingDeg;
    EXPECT_TRUE(evidence->reading.count.enough()) << facingDeg << "°: " << evidence->reading.count.reads;
    EXPECT_EQ(evidence->reading.text, "QRELIEF");
    EXPECT_NEAR(evidence->facingDeg, facingDeg, 1e-9);
    EXPECT_EQ(evidence->process, "fdm-0.4/0.2");
  }
}

TEST_F(PrintedViewTest, ModulesFinerThanTheNozzleDoNotDecodeInPrintThoughTheDesignDoes) {
  const Carved plate = carved(7);  // modules of a third of a millimetre
  auto job = VerifyJob::create(plate.mesh, plate.request, zxingDecoders());
  ASSERT_TRUE(job);
  EXPECT_TRUE(runToEnd(**job)->reading.frontal.enough());
  const auto evidence = printed(plate, {0, 0, 1});
  ASSERT_TRUE(evidence);
  EXPECT_EQ(evidence->reading.count.reads, 0);
}

TEST_F(PrintedViewTest, ThePrintIsDarkWhereTheCodeIsDark) {
  const Carved plate = carved(25.2);
  const int modules = plate.request.symbol.size, edge = modules + 2 * 6;  // six modules around the symbol are seen
  auto job = PrintedViewJob::create(plate.mesh, {.process = *processOf({}),
                                                 .frame = plate.request.frame,
                                                 .symbol = plate.request.symbol,
                                                 .symbolMm = plate.request.symbolMm,
                                                 .buildUp = {0, 1, 1}});
  ASSERT_TRUE(job);
  const auto view = runToEnd(**job);
  ASSERT_TRUE(view);
  EXPECT_NEAR(view->facingDeg, 45, 1e-9);
  const int perModule = static_cast<int>(view->seen.pixelsPerModule), width = perModule * edge;
  ASSERT_EQ(view->seen.luminance.rows(), width);
  ASSERT_EQ(view->seen.clean.width, width);
  double dark = 0, light = 0;
  int darkPixels = 0, lightPixels = 0;
  for (int row = 0; row < perModule * modules; ++row)
    for (int column = 0; column < perModule * modules; ++column) {
      const int y = width - 1 - 6 * perModule - row, x = 6 * perModule + column;
      const double value = static_cast<double>(view->seen.luminance.at(y, x));
      const bool isDark = plate.request.symbol.isDark(row / perModule, column / perModule);
      (isDark ? dark : light) += value;
      ++(isDark ? darkPixels : lightPixels);
    }
  EXPECT_LT(dark / darkPixels, 0.9 * light / lightPixels);
}

TEST_F(PrintedViewTest, HasNoPrintWithoutAProcess) {
  VerifyRequest request;
  request.text = "x";
  const auto evidence = readPrinted(request, shapes::box({10, 10, 10}), [](const Progress&) { FAIL(); });
  ASSERT_TRUE(evidence);
  EXPECT_FALSE(*evidence);
}

TEST_F(PrintedViewTest, RefusesAnImpossiblePrinter) {
  VerifyRequest request;
  request.text = "x";
  request.symbolMm = 5;
  request.process = 0;
  const auto codeOf = [&] {
    const auto evidence = readPrinted(request, shapes::box({10, 10, 10}), [](const Progress&) {});
    return evidence ? std::string() : evidence.error().message.code;
  };
  request.buildUp = Vec3(0);
  EXPECT_EQ(codeOf(), "no-build-direction");
  request.buildUp = {0, 0, 1};
  request.printer.layerMm = 0.5;
  EXPECT_EQ(codeOf(), "layer-above-nozzle");
}

}  // namespace
}  // namespace qrelief
