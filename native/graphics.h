// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "gl/objects.h"
#include "native/egl_context.h"
#include "render/geometry_pass.h"

namespace qrelief {

/// The GPU of a native program, with a current GL context. Without a GPU all members are empty, and the processor draws
/// and lights (EngravableModel::create()): it is faster than a software renderer of GL.
struct Graphics {
  std::unique_ptr<EglContext> context;
  std::shared_ptr<const GeometryPass> pass;
  gl::Capabilities capabilities;  ///< without a GPU, the renderer is "processor"

  /// Opens the GPU, if there is one that EglContext can use.
  static Graphics open();
};

}  // namespace qrelief
