// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/facts.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/symbol_facts.h"
#include "io/write_stl.h"
#include "settings/engrave_request.h"
#include "settings/setting_json.h"
#include "support/shapes.h"
#include "support/zip_file.h"

namespace qrelief {
namespace {

using Json = nlohmann::json;

Json modelOf(const std::vector<std::uint8_t>& bytes, double scaleToMm) {
  return Json::parse(Facts().model(bytes, "box.stl", scaleToMm));
}

TEST(Facts, DescribeAModelInMillimetres) {
  const Json answer = modelOf(writeStl(shapes::box({1, 2, 3})), 10);
  ASSERT_EQ(answer["ok"], true) << answer;
  const Json& model = answer["model"];
  EXPECT_EQ(model["format"], "STL (binary)");
  EXPECT_EQ(model["scaleToMm"], 10);
  EXPECT_EQ(model["triangles"], 12);
  EXPECT_EQ(model["vertices"], 8);
  EXPECT_EQ(model["sizeMm"], Json({10, 20, 30}));
  EXPECT_EQ(model["shells"], 1);
  EXPECT_EQ(model["engravable"], true);
  EXPECT_EQ(model["findings"], Json::array());
  EXPECT_FALSE(model.contains("centre"));
}

TEST(Facts, NameWhatOnly3mfKeeps) {
  std::string box = zip_file::boxObject(1, 10, 20, 30);
  box.insert(box.find("<triangle ") + 10, "paint_color=\"8\" ");
  const auto bytes = zip_file::threeMf(zip_file::modelPart(box, "<item objectid=\"1\"/>"),
                                       {{"Metadata/model_settings.config", "<config><plate/><plate/></config>"}});
  const auto only3mf = [&](double scaleToMm) {
    return Json::parse(Facts().model(bytes, "a.3mf", scaleToMm))["model"]["only3mf"];
  };
  EXPECT_EQ(only3mf(0), Json({"paint", "plates"}));
  EXPECT_EQ(only3mf(25.4), Json::array()) << "the file is written anew";
  EXPECT_EQ(modelOf(writeStl(shapes::box({1, 2, 3})), 1)["model"]["only3mf"], Json::array());
}

TEST(Facts, RefuseAFileThatIsCutOffAndAScaleThatIsNone) {
  auto bytes = writeStl(shapes::box({1, 2, 3}));
  EXPECT_EQ(modelOf(bytes, -1)["error"]["code"], "scale-unusable");
  bytes.resize(bytes.size() - 30);
  EXPECT_EQ(modelOf(bytes, 1)["error"]["code"], "stl-cut-off");
}

TEST(Facts, DescribeTheSymbolOfSettingsAndNameAnUnknownOne) {
  const std::string settings = R"({"text": "https://example.org", "ecc": "H"})";
  EXPECT_EQ(Facts().symbol(settings), describeSymbol(*requestFromJson(settings)));
  EXPECT_EQ(Json::parse(Facts().symbol(R"({"colour": 1})"))["error"]["kind"], "BadUsage");
}

TEST(Facts, AdviseOnATextThatWasMeantToBeALink) {
  const Json answer = Json::parse(Facts().textAdvice("example.org"));
  ASSERT_EQ(answer["advice"].size(), 1u);
  EXPECT_EQ(answer["advice"][0]["severity"], "warning");
  EXPECT_EQ(answer["advice"][0]["message"]["code"], "link-without-scheme");
  EXPECT_EQ(answer["advice"][0]["fixed"], "https://example.org");
  const Json good = Json::parse(Facts().textAdvice("https://www.example.org/a"));
  EXPECT_EQ(good["advice"], Json::array());
  EXPECT_EQ(good["shorter"][0], Json({{"form", "capitals"}, {"text", "HTTPS://WWW.EXAMPLE.ORG/a"}}));
  EXPECT_EQ(good["shorter"][1]["form"], "www");
}

}  // namespace
}  // namespace qrelief
