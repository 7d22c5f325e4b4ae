// SPDX-License-Identifier: GPL-3.0-or-later
#include "native/engrave.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace qrelief {
namespace {

struct Observed {
  Engraved engraved;
  std::vector<int> attempts;  ///< of the calls while a print was simulated
  bool knewPrint = false;     ///< one of them came after the print was known
};

/// Engraves a plate of 20 mm.
Observed engravePlate(const EngraveRequest& request) {
  Engraver engraver(EngravableModel::create(*prepareModel(shapes::soupOf(shapes::box({60, 50, 20})), {}), nullptr));
  Observed result;
  auto engraved = engrave(
      engraver, request, {}, [](const Progress&) {},
      [&](const Engraved& carving) {
        result.attempts.push_back(carving.attempt);
        result.knewPrint |= carving.printed.has_value();
        EXPECT_GT(carving.reading.count.reads, 0);
        EXPECT_FALSE(carving.result.mesh.triangles.empty());
      });
  EXPECT_TRUE(engraved);
  if (engraved) result.engraved = std::move(*engraved);
  return result;
}

EngraveRequest request() {
  EngraveRequest request = defaultRequest();
  request.code.text = "https://example.org/a";
  request.placement.centreMm = {0, 0, 10};
  request.placement.sizeMode = SizeMode::Fixed;
  request.placement.sizeMm = 30;
  return request;
}

TEST(Engrave, GivesTheCarvingWhileItsPrintIsSimulated) {
  const Observed result = engravePlate(request());
  ASSERT_FALSE(result.attempts.empty());
  EXPECT_EQ(result.attempts.back(), result.engraved.attempt);
  EXPECT_FALSE(result.knewPrint);
  EXPECT_TRUE(result.engraved.printed);
}

TEST(Engrave, GivesNothingWhileNoPrintIsSimulated) {
  EngraveRequest designOnly = request();
  designOnly.print.process.reset();
  const Observed result = engravePlate(designOnly);
  EXPECT_TRUE(result.attempts.empty());
  EXPECT_FALSE(result.engraved.printed);
}

}  // namespace
}  // namespace qrelief
