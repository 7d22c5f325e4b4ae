// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/declared_uniforms.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace qrelief::gl {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(DeclaredUniforms, ListsUniformsInOrderForAnyTypeAndPrecision) {
  EXPECT_THAT(declaredUniforms("uniform float u_a;\nuniform highp sampler2D u_b;\nuniform\n  mat4 u_c ;"),
              ElementsAre("u_a", "u_b", "u_c"));
}

TEST(DeclaredUniforms, ListsSeveralUniformsOfOneDeclaration) {
  EXPECT_THAT(declaredUniforms("uniform vec3 u_right, u_up,u_lamps[2], u_normal;"),
              ElementsAre("u_right", "u_up", "u_lamps", "u_normal"));
}

TEST(DeclaredUniforms, IgnoresComments) {
  EXPECT_THAT(declaredUniforms(
                  "// share of a uniform sky;\n/* uniform int u_old; */uniform/* of all */int u_a;// uniform int b;"),
              ElementsAre("u_a"));
}

TEST(DeclaredUniforms, IgnoresWordsThatContainTheKeyword) {
  EXPECT_THAT(declaredUniforms("float nonuniform = 1.0; int uniforms = 2; in float uniform_share;"), IsEmpty());
}

TEST(DeclaredUniforms, ReadsATruncatedTextToItsEnd) {
  EXPECT_THAT(declaredUniforms("uniform float u_a"), ElementsAre("u_a"));
  EXPECT_THAT(declaredUniforms("uniform float u_a; /* uniform int u_b;"), ElementsAre("u_a"));
}

}  // namespace
}  // namespace qrelief::gl
