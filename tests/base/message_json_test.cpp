// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/message_json.h"

#include <gtest/gtest.h>

#include "message_codes/text.h"

namespace qrelief {
namespace {

using Json = nlohmann::ordered_json;

/// Returns the JSON of a value named "n".
Json valueOf(const NamedValue<"n">& n) { return jsonOf(Message("any", {&n.value})).at("values").at("n"); }

TEST(MessageJson, WritesTheKindOfEachValue) {
  struct Point {
    double x, y, z;
  };
  EXPECT_EQ(valueOf(with::count<"n">(3u)), Json({{"count", 3}}));
  EXPECT_EQ(valueOf(with::index<"n">(3u)), Json({{"index", 3}}));
  EXPECT_EQ(valueOf(with::number<"n">(0.3)), Json({{"number", 0.3}}));
  EXPECT_EQ(valueOf(with::lengthMm<"n">(0.24)), Json({{"lengthMm", 0.24}}));
  EXPECT_EQ(valueOf(with::angleDeg<"n">(12.5)), Json({{"angleDeg", 12.5}}));
  EXPECT_EQ(valueOf(with::fraction<"n">(0.4)), Json({{"fraction", 0.4}}));
  EXPECT_EQ(valueOf(with::place<"n">(Point{1, 2, 3})), Json({{"place", {1.0, 2.0, 3.0}}}));
  EXPECT_EQ(valueOf(with::extentMm<"n">(Point{1, 2, 3})), Json({{"extentMm", {1.0, 2.0, 3.0}}}));
  EXPECT_EQ(valueOf(with::quoted<"n">("a")), Json({{"quoted", "a"}}));
  EXPECT_EQ(valueOf(with::term<"n">("STL")), Json({{"term", "STL"}}));
  EXPECT_EQ(valueOf(with::setting<"n">("minWallMm")), Json({{"setting", "minWallMm"}}));
  EXPECT_EQ(valueOf(with::choice<"n">("ecc", "L")), Json({{"choice", {{"key", "ecc"}, {"value", "L"}}}}));
  EXPECT_EQ(valueOf(with::indices<"n">({4, 2})), Json({{"indices", {4.0, 2.0}}}));
  EXPECT_EQ(valueOf(with::cause<"n">(message<"text-empty">())),
            Json({{"cause", {{"code", "text-empty"}, {"values", Json::object()}}}}));
}

TEST(MessageJson, WritesACountBeyondIntegerRangeAsANumber) {
  EXPECT_EQ(valueOf(with::count<"n">(9007199254740991.0)).dump(), R"({"count":9007199254740991})");
  EXPECT_EQ(valueOf(with::count<"n">(18446744073709551615ull)), Json({{"count", 18446744073709551616.0}}));
}

}  // namespace
}  // namespace qrelief
