// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_checked.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

#include "messages/sentences.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using ::testing::HasSubstr;

std::vector<ModelObject> objectOf(const Mesh& mesh) { return {{"shape", {{"", mesh, {}}}}}; }

TEST(WriteChecked, WritesTheSameAsWriteModel) {
  const auto objects = objectOf(shapes::icosphere(7, 2));
  for (const ModelFormat format : {ModelFormat::Stl, ModelFormat::Obj, ModelFormat::Ply, ModelFormat::ThreeMf}) {
    const auto bytes = writeChecked(objects, format);
    ASSERT_TRUE(bytes) << bytes.error().message;
    EXPECT_EQ(*bytes, *writeModel(objects, format));
  }
}

TEST(WriteChecked, ReportsErrorsOfWriting) {
  EXPECT_EQ(writeChecked(objectOf(shapes::box({1, 1, 1})), ModelFormat::Off).error().kind, ErrorKind::BadUsage);
}

TEST(WriteChecked, RefusesAFileThatCannotBeReadBack) {
  Mesh mesh = shapes::box({1, 1, 1});
  mesh.positions[3].x = std::numeric_limits<float>::infinity();
  for (const ModelFormat format : {ModelFormat::Stl, ModelFormat::Obj, ModelFormat::Ply, ModelFormat::ThreeMf}) {
    const auto bytes = writeChecked(objectOf(mesh), format);
    ASSERT_FALSE(bytes);
    EXPECT_EQ(bytes.error().kind, ErrorKind::Internal);
    EXPECT_THAT(sentence(bytes.error().message), HasSubstr("could not be read back"));
  }
}

}  // namespace
}  // namespace qrelief
