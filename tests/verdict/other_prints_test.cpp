// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict/other_prints.h"

#include <gmock/gmock.h>

namespace qrelief {
namespace {

using testing::ElementsAre;

class OtherPrintsTest : public testing::Test {
 protected:
  OtherPrintsTest() {
    request_.frame = makeFrame({1, 2, 3}, {1, 0, 1}, {0, 0, 1}, 250);  // on a slope of 45 degrees
    request_.process = 0;
    request_.printer = namedPrinters()[0].printer;
  }

  VerifyRequest request_;
};

TEST_F(OtherPrintsTest, ListsPosesBeforeProcessesAndNothingCoarserOrEqual) {
  EXPECT_THAT(otherPrints(request_),
              ElementsAre(SettingChange{"buildUp", "code-up"}, SettingChange{"buildUp", "code-upright"},
                          SettingChange{"process", "fdm-0.4/0.12"}, SettingChange{"process", "fdm-0.25/0.1"},
                          SettingChange{"process", "resin-0.05"}));
}

TEST_F(OtherPrintsTest, OmitsAPoseThatHardlyTurnsTheModel) {
  for (const NamedPrinter& named : namedPrinters())
    if (named.name == "resin-0.05") request_.printer = named.printer;  // no printer is finer
  request_.buildUp = request_.frame.normal + 0.1 * request_.frame.up;
  EXPECT_THAT(otherPrints(request_),
              ElementsAre(SettingChange{"buildUp", "as-modelled"}, SettingChange{"buildUp", "code-upright"}));
  request_.frame = makeFrame({0, 0, 0}, {0.1, 0, 1}, {0, 1, 0}, 250);  // faces up as it was modelled
  request_.buildUp = {0, 0, 1};
  EXPECT_THAT(otherPrints(request_), ElementsAre(SettingChange{"buildUp", "code-upright"}));
}

TEST_F(OtherPrintsTest, NeverLetsTheCodeFaceDown) {
  request_.frame = makeFrame({0, 0, 0}, {0.5, 0, -1}, {0, 1, 0}, 250);
  request_.buildUp = request_.frame.normal;
  EXPECT_EQ(otherPrints(request_).front(), (SettingChange{"buildUp", "code-upright"}));
}

TEST_F(OtherPrintsTest, ChangesOnlyPoseOrProcess) {
  const VerifyRequest upright = printedOtherwise(request_, {"buildUp", "code-upright"});
  EXPECT_EQ(upright.buildUp, request_.frame.up);
  EXPECT_EQ(upright.printer, request_.printer);
  const VerifyRequest finer = printedOtherwise(request_, {"process", "fdm-0.4/0.12"});
  EXPECT_EQ(finer.buildUp, request_.buildUp);
  EXPECT_EQ(finer.printer.layerMm, 0.12);
  EXPECT_EQ(namedPrinters()[*finer.process].name, "fdm-0.4/0.12");
}

}  // namespace
}  // namespace qrelief
