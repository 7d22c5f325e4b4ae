// SPDX-License-Identifier: GPL-3.0-or-later
#include "delivery/second_colour.h"

#include "messages/sentences.h"
#include "pipeline/coloured_code.h"
#include "pipeline/engrave.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

class SecondColourTest : public GlTest {};

TEST_F(SecondColourTest, LayersOfACodeAreItsFilamentChangesWithLabelAndFrame) {
  const auto model = EngravableModel::upload(*prepareModel(shapes::soupOf(shapes::box({80, 20, 80})), {}));
  for (const Mark mark : {Mark::Inlay, Mark::Paint})
    for (const LabelOptions& label :
         {LabelOptions{}, LabelOptions{"No. 0042", LabelFrame::None}, LabelOptions{"No. 0042", LabelFrame::Rounded}})
      for (const BuildPose pose : {BuildPose::AsModelled, BuildPose::CodeUp}) {
        EngraveRequest request;
        request.code.text = "https://qrelief.example";
        request.code.label = label;
        request.marking.mark = mark;
        request.placement.centreMm = {0, -10, 0};  // on a wall
        request.placement.sizeMode = SizeMode::Fixed;
        request.placement.sizeMm = 30;
        request.print.buildUp.pose = pose;
        const auto result = engrave(model, request);
        ASSERT_TRUE(result.has_value()) << sentence(result.error().message);
        const int layers = layersOfCode(result->placement, result->symbol.size, colouredCodeOf(request));
        EXPECT_NEAR(layers, secondColourOf(*result).cost.changes, 2)
            << markName(mark) << label.text << labelFrameName(label.frame) << buildPoseName(pose);
      }
}

TEST_F(SecondColourTest, AnUnknownPrinterHasNoLayers) {
  ColouredCode code;
  code.print.process.reset();
  EXPECT_EQ(layersOfCode({}, 25, code), 0);
}

}  // namespace
}  // namespace qrelief
