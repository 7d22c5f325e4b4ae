// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/lamp_light.h"

#include "math/frame.h"
#include "shaders.h"

namespace qrelief {
namespace {

constexpr double kWholeMesh = 0.51;    // half edge of the window round the mesh, as a part of the mesh's diagonal
constexpr float kEmptyHeight = -1e9f;  // of a texel without surface
constexpr int kFirstTexel = 1;         // edge of the texture before there are lamps

constexpr double kFarDiagonals = 200;    // distance of an eye whose sight is nearly parallel, in diagonals of the mesh
constexpr double kPyramidMargin = 1.02;  // so far away it narrows by at most 2 · 0.51 / 200 on the way through the mesh

ProjectionFrame axesTowards(Vec3 lamp) { return makeFrame({}, lamp, {0, 0, 1}, 1); }

ViewPyramid rays(Vec3 middle, Vec3 towards, double edgeMm, const GpuMesh& mesh) {
  ProjectionFrame frame = axesTowards(towards);
  frame.centre = middle;
  frame.eyeDistance = kFarDiagonals * mesh.box().diagonal();
  return {frame, kPyramidMargin * edgeMm};
}

}  // namespace

Result<LampShadows> LampShadows::create() {
  auto program = gl::Program::create("view shadow", shaders::view_shadow_vert, shaders::view_shadow_frag);
  QRELIEF_TRY(program);
  LampShadows shadows;
  shadows.program_ = std::move(*program);
  shadows.heights_ = gl::Texture(kFirstTexel, kFirstTexel, gl::Format::R32F);
  return shadows;
}

Status LampShadows::makeRoom(int lamps, int texels) {
  if (heights_.width() == lamps * texels && heights_.height() == 2 * texels) return {};
  forget();
  heights_ = gl::Texture(lamps * texels, 2 * texels, gl::Format::R32F);
  const gl::Texture* const colours[] = {&heights_};
  auto target = gl::Framebuffer::create(colours, true);
  QRELIEF_TRY(target);
  target_ = std::move(*target);
  return {};
}

Status LampShadows::draw(const LampLight& light, const GpuMesh& mesh, const std::optional<CuttingPlane>& cut,
                         int texels) {
  QRELIEF_TRY(makeRoom(static_cast<int>(light.lamps.size()), texels));
  light_ = light;
  windows_ = {Window{mesh.box().centre(), kWholeMesh * mesh.box().diagonal()}, Window{light.centre, light.radiusMm}};
  for (std::size_t lamp = 0; lamp < light.lamps.size(); ++lamp) {
    for (std::size_t row = 0; row < windows_.size(); ++row) {
      const Map map{light.lamps[lamp].towards, windows_[row]};
      if (drawn_[lamp][row] == map) continue;
      drawMap(map, static_cast<int>(lamp), static_cast<int>(row), mesh, cut);
      drawn_[lamp][row] = map;
    }
  }
  return {};
}

void LampShadows::drawMap(const Map& map, int column, int row, const GpuMesh& mesh,
                          const std::optional<CuttingPlane>& cut) const {
  const int texels = heights_.height() / 2;
  target_.bind();
  glViewport(column * texels, row * texels, texels, texels);
  glEnable(GL_SCISSOR_TEST);
  glScissor(column * texels, row * texels, texels, texels);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glClearColor(kEmptyHeight, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const ProjectionFrame axes = axesTowards(map.towards);
  program_.use();
  program_.set("u_right", Vec3f(axes.right));
  program_.set("u_up", Vec3f(axes.up));
  program_.set("u_towards", Vec3f(map.towards));
  program_.set("u_middle", Vec3f(map.window.middle - mesh.origin()));
  program_.set("u_half", static_cast<float>(map.window.halfMm));
  program_.set("u_reach", static_cast<float>(mesh.box().diagonal() + glm::distance(map.window.middle, mesh.origin())));
  const Vec3 normal = cut ? cut->normal : Vec3(0);
  const double along = cut ? glm::dot(cut->point - mesh.origin(), cut->normal) : 0;
  program_.set("u_cut", glm::vec4(Vec3f(normal), static_cast<float>(along)));
  mesh.draw(rays(map.window.middle, map.towards, 2 * map.window.halfMm, mesh));
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_SCISSOR_TEST);
}

void LampShadows::set(const gl::Program& program, const CameraView& camera, int unit) const {
  constexpr std::array<const char*, kMaxLights> kLamp = {"u_lamp[0]", "u_lamp[1]"};
  constexpr std::array<const char*, kMaxLights> kRight = {"u_lampRight[0]", "u_lampRight[1]"};
  constexpr std::array<const char*, kMaxLights> kUp = {"u_lampUp[0]", "u_lampUp[1]"};
  constexpr std::array<const char*, 2> kWindow = {"u_shadowWindow[0]", "u_shadowWindow[1]"};
  program.set("u_lamps", static_cast<int>(light_.lamps.size()));
  for (std::size_t i = 0; i < light_.lamps.size(); ++i) {
    const auto& [towards, strength] = light_.lamps[i];
    const ProjectionFrame axes = axesTowards(towards);
    program.set(kLamp[i], glm::vec4(camera.inView(towards), static_cast<float>(strength)));
    program.set(kRight[i], camera.inView(axes.right));
    program.set(kUp[i], camera.inView(axes.up));
  }
  for (std::size_t row = 0; row < windows_.size(); ++row)
    program.set(kWindow[row],
                glm::vec4(camera.pointInView(windows_[row].middle), static_cast<float>(windows_[row].halfMm)));
  program.set("u_albedo", static_cast<float>(light_.albedo));
  program.set("u_openIrradiance", static_cast<float>(light_.openIrradiance));
  program.setTexture("u_shadow", unit, heights_);
}

void LampShadows::setNone(const gl::Program& program, int unit) const {
  program.set("u_lamps", -1);
  program.setTexture("u_shadow", unit, heights_);
}

}  // namespace qrelief
