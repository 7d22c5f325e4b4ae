// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <memory>
#include <vector>

#include "support/gl_test.h"
#include "support/shapes.h"
#include "viewer/display_mesh.h"
#include "viewer/viewer.h"

namespace qrelief {

inline constexpr int kWidth = 240, kHeight = 180;

/// Pixels of a picture, 0 … 1, addressed by the camera's screen position (from the upper left).
struct Picture {
  std::vector<float> rgba;  // row 0 at the bottom

  Vec3 at(Vec2 pixel) const {
    const int x = static_cast<int>(pixel.x), y = kHeight - 1 - static_cast<int>(pixel.y);
    const auto i = 4 * static_cast<std::size_t>(y * kWidth + x);
    return {rgba[i], rgba[i + 1], rgba[i + 2]};
  }
  double brightness(Vec2 pixel) const { return (at(pixel).x + at(pixel).y + at(pixel).z) / 3; }
};

/// A viewer of kWidth × kHeight pixels that draws into a texture.
class ViewerFixture : public GlTest {
 protected:
  void SetUp() override {
    auto viewer = Viewer::create();
    ASSERT_TRUE(viewer.has_value()) << viewer.error().message;
    viewer_ = std::make_unique<Viewer>(std::move(*viewer));
    viewer_->resize(kWidth, kHeight);
    camera_.setViewport(kWidth, kHeight);
    canvas_ = gl::Texture(kWidth, kHeight, gl::Format::RGBA32F);
    const gl::Texture* const colours[] = {&canvas_};
    auto target = gl::Framebuffer::create(colours, false);
    ASSERT_TRUE(target.has_value());
    target_ = std::move(*target);
  }
  void show(const Mesh& mesh) {
    const DisplayMesh display = splitAtCreases(mesh);
    viewer_->setMesh(std::make_shared<GpuMesh>(display.mesh, display.normals));
    camera_.setScene(boundingBox(mesh));
    camera_.fitFromDefaultSide();
  }
  /// Shows a box whose upper side has the value 1, the others 0.
  void showBoxWithValuesOnTop() {
    const DisplayMesh display = splitAtCreases(shapes::box({40, 40, 40}));
    auto mesh = std::make_shared<GpuMesh>(display.mesh, display.normals);
    std::vector<float> values(display.normals.size(), 0);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (display.normals[i].z > 0.5f) values[i] = 1;
    mesh->setValues(values);
    viewer_->setMesh(mesh);
    camera_.setScene(mesh->box());
    camera_.fitFromDefaultSide();
  }
  bool draw(double nowMs, bool always = false) {
    const auto more = viewer_->draw(camera_.view(), nowMs, &target_, always);
    EXPECT_TRUE(more.has_value());
    return more.value_or(false);
  }
  /// Draws until the picture is refined, and returns it.
  Picture refined() {
    double now = clock_;
    int frames = 0;
    while (draw(now += 200) && frames < 100) ++frames;
    EXPECT_LT(frames, 100);
    clock_ = now + 1000;
    return {target_.readRgba()};
  }
  std::unique_ptr<Viewer> viewer_;
  OrbitCamera camera_;
  gl::Texture canvas_;
  gl::Framebuffer target_;
  double clock_ = 0;
};

}  // namespace qrelief
