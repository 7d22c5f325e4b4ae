// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "base/result.h"

namespace qrelief {

/// A current OpenGL ES 3 context without a window, for the thread that made it. Uses a GPU if one is available without
/// a display (EGL_EXT_platform_device), else Mesa's software renderer (surfaceless), which only tests need: see
/// Graphics. QRELIEF_GL=software in the environment skips the GPU.
class EglContext {
 public:
  /// @param onlyGpu  do not use the software renderer
  static Result<std::unique_ptr<EglContext>> create(bool onlyGpu = false);
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

 private:
  EglContext() = default;
  void* display_ = nullptr;
  void* context_ = nullptr;
};

}  // namespace qrelief
