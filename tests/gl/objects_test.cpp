// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/objects.h"

#include "messages/sentences.h"
#include "shaders.h"
#include "support/gl_test.h"

namespace qrelief::gl {
namespace {

class GlObjects : public GlTest {};

TEST_F(GlObjects, CapabilitiesNameTheRendererAndTextureSize) {
  const auto capabilities = queryCapabilities();
  ASSERT_TRUE(capabilities.has_value()) << capabilities.error().message;
  EXPECT_NE(capabilities->version.find("OpenGL ES 3"), std::string::npos) << capabilities->version;
  EXPECT_GE(capabilities->maxTextureSize, 2048);
}

TEST_F(GlObjects, ReadsAFloatTextureBackBitForBit) {
  const std::vector<float> texels = {0.0f, 1.0f, -2.5f, 1e-20f, 250.123456f, 3.4e38f};
  const Texture texture(3, 2, Format::R32F, texels.data());
  const Texture* const colours[] = {&texture};
  const auto framebuffer = Framebuffer::create(colours, false);
  ASSERT_TRUE(framebuffer.has_value());
  EXPECT_EQ(framebuffer->readRed(), texels);
}

TEST_F(GlObjects, NamesAShaderThatDoesNotCompile) {
  const auto program =
      Program::create("broken pass", shaders::fullscreen_vert, "#version 300 es\nvoid main() { nonsense }");
  ASSERT_FALSE(program.has_value());
  EXPECT_EQ(program.error().kind, ErrorKind::Internal);
  EXPECT_NE(sentence(program.error().message).find("broken pass"), std::string::npos);
}

TEST_F(GlObjects, NamesShadersThatDoNotLink) {
  const char* fragment =
      "#version 300 es\nprecision highp float; in vec4 v_missing; layout(location=0) out vec4 o; void main() { o = "
      "v_missing; }";
  const auto program = Program::create("unlinked pass", shaders::fullscreen_vert, fragment);
  ASSERT_FALSE(program.has_value());
  EXPECT_NE(sentence(program.error().message).find("unlinked pass"), std::string::npos);
}

constexpr const char* kTinted =
    "#version 300 es\nprecision highp float; uniform vec4 u_tint[2]; uniform float u_unused; layout(location=0) out "
    "vec4 o; "
    "void main() { o = u_tint[1]; }";

TEST_F(GlObjects, IgnoresAUniformThatTheCompilerDropped) {
  const Texture texture(1, 1, Format::RGBA32F);
  const Texture* const colours[] = {&texture};
  const auto framebuffer = Framebuffer::create(colours, false);
  const auto program = Program::create("tinted", shaders::fullscreen_vert, kTinted);
  ASSERT_TRUE(framebuffer.has_value() && program.has_value());
  framebuffer->bind();
  program->use();
  program->set("u_unused", 3.0f);
  program->set("u_tint[0]", glm::vec4(9));
  program->set("u_tint[1]", glm::vec4(1, 2, 3, 4));
  drawFullscreen();
  EXPECT_EQ(framebuffer->readRgba(), (std::vector<float>{1, 2, 3, 4}));
}

#ifndef NDEBUG
using GlObjectsDeathTest = GlObjects;

TEST_F(GlObjectsDeathTest, AbortsOnAnUndeclaredUniformAndNamesIt) {
  const auto program = Program::create("tinted", shaders::fullscreen_vert, kTinted);
  ASSERT_TRUE(program.has_value());
  program->use();
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // the driver has threads, and a fork would not copy them
  EXPECT_DEATH(program->set("u_tinct", 3.0f), "\"tinted\" declares no uniform u_tinct");
}
#endif

TEST_F(GlObjects, AMovedFromTextureIsEmpty) {
  Texture a(2, 2, Format::R32F);
  const GLuint id = a.id();
  const Texture b = std::move(a);
  EXPECT_EQ(b.id(), id);
  EXPECT_EQ(a.id(), 0u);  // NOLINT(bugprone-use-after-move): that is what is tested
}

}  // namespace
}  // namespace qrelief::gl
