// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/label_pockets.h"

#include <gmock/gmock.h>

#include "messages/sentences.h"
#include "native/zxing_decoder.h"
#include "pipeline/add_inlay.h"
#include "pipeline/engrave.h"
#include "support/gl_test.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

class LabelPocketsTest : public GlTest {
 protected:
  static std::shared_ptr<const EngravableModel> upload(const Mesh& mesh) {
    auto prepared = prepareModel(shapes::soupOf(mesh), {});
    EXPECT_TRUE(prepared.has_value());
    return EngravableModel::upload(std::move(*prepared));
  }
  /// Returns a request for the top of a plate.
  static EngraveRequest request(double sizeMm) {
    EngraveRequest result;
    result.code.text = "https://qrelief.example";
    result.code.label = {"No. 0042", LabelFrame::Rounded};
    result.placement.upHint = {0, 1, 0};
    result.placement.sizeMode = SizeMode::Fixed;
    result.placement.sizeMm = sizeMm;
    return result;
  }
};

TEST_F(LabelPocketsTest, ALabelledCodeIsASolidThatDecodes) {
  const auto model = upload(shapes::plate({60, 60}, 6, 5, 5));
  EngraveRequest engraving = request(25);
  auto labelled = engrave(model, engraving);
  ASSERT_TRUE(labelled.has_value()) << labelled.error().message;
  ASSERT_TRUE(addInlay(*model, *labelled));
  EXPECT_TRUE(labelled->solidity.solid()) << testing::PrintToString(labelled->solidity.problems());
  EXPECT_TRUE(labelled->inlaySolidity.solid()) << testing::PrintToString(labelled->inlaySolidity.problems());
  EXPECT_EQ(readWithZxing(labelled->readerView), engraving.code.text);
  EXPECT_NEAR(labelled->label.depthMm, kLabelLayers * engraving.print.printer.layerMm, 1e-9);
  // The label takes its area times its depth from the model, and nothing else changes.
  engraving.code.label = {};
  const auto plain = engrave(model, engraving);
  ASSERT_TRUE(plain.has_value()) << plain.error().message;
  double area = 0;
  for (const Ring& ring : labelled->label.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) area += cross2(ring[i], ring[(i + 1) % ring.size()]) / 2;
  const double lost = plain->solidity.volumeMm3 - labelled->solidity.volumeMm3;
  EXPECT_NEAR(lost, area * labelled->label.depthMm, 0.03 * lost);
}

TEST_F(LabelPocketsTest, AFoundSizeLeavesRoomForTheLabel) {
  const auto model = upload(shapes::plate({60, 60}, 6, 5, 5));
  EngraveRequest engraving = request(0);
  engraving.placement.sizeMode = SizeMode::Oriented;
  engraving.placement.pockets = {};
  const auto labelled = engrave(model, engraving);
  ASSERT_TRUE(labelled.has_value()) << labelled.error().message;
  const int modules = labelled->symbol.size;
  const double edge = modules + 2 * labelMarginModules(engraving.code.label, modules);
  EXPECT_LE(labelled->placement.moduleMm * edge, 60);
  EXPECT_GT(labelled->placement.moduleMm * edge, 57);
}

TEST_F(LabelPocketsTest, ACodeWithoutRoomForItsLabelIsRefused) {
  const auto model = upload(shapes::plate({40, 40}, 6, 5, 5));
  EngraveRequest engraving = request(28);
  EXPECT_FALSE(engrave(model, engraving).has_value());
  engraving.code.label = {};
  EXPECT_TRUE(engrave(model, engraving).has_value());
}

TEST_F(LabelPocketsTest, AThinWallTakesAShallowerLabelOrNone) {
  const Mesh thin = shapes::plate({60, 60}, 1.1, 5, 5), thinner = shapes::plate({60, 60}, 0.9, 5, 5);
  Placement placement;
  placement.frame = makeFrame({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 250);
  placement.moduleMm = 1;
  const auto shallow = labelPockets(request(25), thin, placement, 25, 0);
  ASSERT_TRUE(shallow.has_value()) << shallow.error().message;
  EXPECT_NEAR(shallow->depthMm, 0.3, 0.011);
  const auto none = labelPockets(request(25), thinner, placement, 25, 0);
  ASSERT_FALSE(none.has_value());
  EXPECT_EQ(none.error().message.code, "label-too-deep");
}

TEST_F(LabelPocketsTest, ALabelThatTheFontLacksIsRefusedBeforeTheSearch) {
  const auto model = upload(shapes::plate({60, 60}, 6, 5, 5));
  EngraveRequest engraving = request(25);
  engraving.code.label.text = "漢";
  const auto job = CarveJob::create(model, engraving);
  ASSERT_FALSE(job.has_value());
  EXPECT_EQ(job.error().message.code, "label-lacks-characters");
}

TEST_F(LabelPocketsTest, ALabelThatIsTooLongToMakeIsRefusedBeforeTheSearch) {
  const auto model = upload(shapes::plate({60, 60}, 6, 5, 5));
  EngraveRequest engraving = request(25);
  engraving.code.label.text = std::string(2000, 'x');
  const auto job = CarveJob::create(model, engraving);
  ASSERT_FALSE(job.has_value());
  EXPECT_EQ(job.error().message.code, "label-strokes-too-thin");
}

TEST_F(LabelPocketsTest, ASmallLabelGetsAnAdvice) {
  const auto model = upload(shapes::plate({60, 60}, 6, 5, 5));
  EngraveRequest engraving = request(25);
  const auto codes = [&](const std::string& label) {
    engraving.code.label.text = label;
    const auto result = engrave(model, engraving);
    EXPECT_TRUE(result.has_value());
    std::vector<std::string> named;
    for (const Message& advice : advisePrinting(featuresOf(*result), engraving.print.printer))
      named.push_back(advice.code);
    return named;
  };
  EXPECT_THAT(codes("No. 7"), testing::Not(testing::Contains("label-too-small")));
  EXPECT_THAT(codes("https://example.org/parts/0123456789"), testing::Contains("label-too-small"));
}

}  // namespace
}  // namespace qrelief
