// SPDX-License-Identifier: GPL-3.0-or-later
#include "native/egl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <array>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "message_codes/command.h"

namespace qrelief {
namespace {

std::vector<EGLDisplay> candidateDisplays(bool onlyGpu) {
  std::vector<EGLDisplay> displays;
  const char* choice = std::getenv("QRELIEF_GL");
  const bool softwareOnly = choice && std::string_view(choice) == "software";
  const auto queryDevices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  const auto queryString =
      reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(eglGetProcAddress("eglQueryDeviceStringEXT"));
  if (queryDevices && !softwareOnly) {
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (queryDevices(static_cast<EGLint>(devices.size()), devices.data(), &count)) {
      for (EGLint i = 0; i < count; ++i) {
        const EGLDeviceEXT device = devices[i];
        // Mesa lists its software renderer as a device, too. It comes last, as surfaceless.
        const char* extensions = queryString ? queryString(device, EGL_EXTENSIONS) : nullptr;
        if (extensions && std::string_view(extensions).find("EGL_MESA_device_software") != std::string_view::npos)
          continue;
        displays.push_back(eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
      }
    }
  }
  if (!onlyGpu) displays.push_back(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  return displays;
}

EGLContext createContext(EGLDisplay display) {
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return EGL_NO_CONTEXT;
  eglBindAPI(EGL_OPENGL_ES_API);
  const std::array<EGLint, 3> configAttributes = {EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  // Only the context matters, as no surface is ever made. If no configuration offers ES 3, use none.
  if (!eglChooseConfig(display, configAttributes.data(), &config, 1, &count) || count == 0) config = EGL_NO_CONFIG_KHR;
  const std::array<EGLint, 3> contextAttributes = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, contextAttributes.data());
  if (context == EGL_NO_CONTEXT) return EGL_NO_CONTEXT;
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) return context;
  eglDestroyContext(display, context);
  return EGL_NO_CONTEXT;
}

}  // namespace

Result<std::unique_ptr<EglContext>> EglContext::create(bool onlyGpu) {
  for (const EGLDisplay display : candidateDisplays(onlyGpu)) {
    const EGLContext context = createContext(display);
    if (context == EGL_NO_CONTEXT) continue;
    std::unique_ptr<EglContext> owner(new EglContext);
    owner->display_ = display;
    owner->context_ = context;
    return owner;
  }
  return fail(ErrorKind::Internal, message<"no-gl-context">());
}

EglContext::~EglContext() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
}

}  // namespace qrelief
