// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/geometry_pass.h"

#include <algorithm>

#include "gl/pass_timings.h"
#include "shaders.h"

namespace qrelief {

Result<GeometryPass> GeometryPass::create() {
  GeometryPass pass;
  auto front = gl::Program::create("geometry", shaders::geometry_vert, shaders::geometry_frag);
  QRELIEF_TRY(front);
  auto back = gl::Program::create("back distance", shaders::geometry_vert, shaders::back_distance_frag);
  QRELIEF_TRY(back);
  pass.front_ = std::move(*front);
  pass.back_ = std::move(*back);
  return pass;
}

void GeometryPass::draw(const gl::Program& program, GLenum culled, const GpuMesh& mesh, const ProjectionFrame& frame,
                        const MapWindow& window) const {
  const Vec3 centre = frame.centre - mesh.origin();
  const double reach = mesh.box().diagonal() / 2;
  const double middle = frame.distanceAlongAxis(mesh.origin());
  const double nearest = std::max(frame.eyeDistance / 100, middle - reach);
  const double farthest = std::max(nearest * 1.01, middle + reach);

  program.use();
  program.set("u_right", Vec3f(frame.right));
  program.set("u_up", Vec3f(frame.up));
  program.set("u_normal", Vec3f(frame.normal));
  program.set("u_centre", Vec3f(centre));
  program.set("u_eyeDistance", static_cast<float>(frame.eyeDistance));
  program.set("u_extent", static_cast<float>(window.extentMm));
  program.set("u_depthRange", glm::vec2(nearest, farthest));
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glEnable(GL_CULL_FACE);
  glFrontFace(GL_CCW);
  glCullFace(culled);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  mesh.draw(ViewPyramid(frame, window.extentMm));
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
}

Result<SurfaceMaps> GeometryPass::render(const GpuMesh& mesh, const ProjectionFrame& frame,
                                         const MapWindow& window) const {
  const gl::TimedPass timed("geometry");
  SurfaceMaps maps;
  maps.window = window;
  maps.surface = gl::Texture(window.texels, window.texels, gl::Format::RGBA32F);
  maps.smooth = gl::Texture(window.texels, window.texels, gl::Format::RGBA32F);
  const gl::Texture* const colours[] = {&maps.surface, &maps.smooth};
  auto framebuffer = gl::Framebuffer::create(colours, true);
  QRELIEF_TRY(framebuffer);
  maps.framebuffer = std::move(*framebuffer);
  maps.framebuffer.bind();
  draw(front_, GL_BACK, mesh, frame, window);
  return maps;
}

Result<BackDistanceMap> GeometryPass::renderBack(const GpuMesh& mesh, const ProjectionFrame& frame,
                                                 const MapWindow& window) const {
  const gl::TimedPass timed("back distance");
  BackDistanceMap map;
  map.distance = gl::Texture(window.texels, window.texels, gl::Format::R32F);
  const gl::Texture* const colours[] = {&map.distance};
  auto framebuffer = gl::Framebuffer::create(colours, true);
  QRELIEF_TRY(framebuffer);
  map.framebuffer = std::move(*framebuffer);
  map.framebuffer.bind();
  draw(back_, GL_FRONT, mesh, frame, window);
  return map;
}

}  // namespace qrelief
