#include "validate/gpu/gl_context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <vector>

#include "validate/gpu/unavailable.h"

namespace lumaknot::gpu {
namespace {

[[noreturn]] void fail(std::string_view what) {
  throw Unavailable(fmt::format("EGL can't {} (error 0x{:x})", what, eglGetError()));
}

EGLDisplay surfaceless_display() {
  if (!epoxy_has_egl()) throw Unavailable("libEGL is not installed");
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    throw Unavailable("EGL has no surfaceless platform; install Mesa's libEGL");
  }
  const EGLDisplay display =
      eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY) fail("open the surfaceless platform");
  if (!eglInitialize(display, nullptr, nullptr))
    fail("start; is Mesa's software driver installed?");
  return display;
}

std::vector<EGLDeviceEXT> devices() {
  if (!epoxy_has_egl()) throw Unavailable("libEGL is not installed");
  for (const char* extension : {"EGL_EXT_device_enumeration", "EGL_EXT_platform_device"}) {
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, extension)) {
      throw Unavailable(fmt::format("EGL has no {}", extension));
    }
  }
  EGLint count = 0;
  if (!eglQueryDevicesEXT(0, nullptr, &count)) fail("count the devices");
  std::vector<EGLDeviceEXT> all(std::size_t(count), nullptr);
  if (!eglQueryDevicesEXT(count, all.data(), &count)) fail("list the devices");
  return all;
}

bool is_software(EGLDeviceEXT device) {
  const char* extensions = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
  return extensions &&
         std::string_view(extensions).find("EGL_MESA_device_software") != std::string_view::npos;
}

EGLDisplay hardware_display() {
  for (const EGLDeviceEXT device : devices()) {
    if (is_software(device)) continue;
    const EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) return display;
  }
  throw Unavailable("EGL has no GPU with a driver");
}

EGLDisplay open_display(bool hardware) {
  const EGLDisplay display = hardware ? hardware_display() : surfaceless_display();
  for (const char* extension : {"EGL_KHR_no_config_context", "EGL_KHR_surfaceless_context"}) {
    if (!epoxy_has_egl_extension(display, extension)) {
      throw Unavailable(fmt::format("EGL has no {}", extension));
    }
  }
  return display;
}

EGLContext make_context(EGLDisplay display, Api api) {
  const bool es = api == Api::kGles;
  if (!eglBindAPI(es ? EGL_OPENGL_ES_API : EGL_OPENGL_API)) fail("provide this API");
  std::vector<EGLint> attributes{EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION,
                                 es ? 0 : 3};
  if (!es) {
    attributes.insert(attributes.end(),
                      {EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT});
  }
  attributes.push_back(EGL_NONE);
  const EGLContext context =
      eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
  if (context == EGL_NO_CONTEXT) fail(es ? "create a GLES 3.0 context" : "create a GL 3.3 context");
  return context;
}

/// Float textures are core in GL 3.3, extensions in GLES 3.0.
void check_extensions() {
  for (const char* extension : {"GL_EXT_color_buffer_float", "GL_OES_texture_float_linear"}) {
    if (!epoxy_has_gl_extension(extension)) {
      throw Unavailable(fmt::format("the GLES driver has no {}", extension));
    }
  }
}

std::string text_of(GLenum name) {
  const auto* bytes = glGetString(name);
  return bytes ? reinterpret_cast<const char*>(bytes) : "unknown";
}

}  // namespace

GlContext::GlContext(Api api, bool hardware) : display_(open_display(hardware)) {
  context_ = make_context(display_, api);
  if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
    fail("use a context without a surface");
  }
  if (api == Api::kGles) check_extensions();
}

GlContext::~GlContext() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  eglTerminate(display_);
}

std::string gl_renderer() { return text_of(GL_RENDERER); }

std::string gl_version() { return fmt::format("{}, {}", gl_renderer(), text_of(GL_VERSION)); }

}  // namespace lumaknot::gpu
