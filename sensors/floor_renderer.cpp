#include "sensors/floor_renderer.hpp"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>
#include <dlfcn.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/check.hpp"
#include "core/error.hpp"

namespace cogslam {
namespace {

void* open_library() {
  // llvmpipe would start a thread per core; runs are parallel by process or particle instead.
  setenv("LP_NUM_THREADS", "0", /*overwrite=*/0);
  std::string reasons;
  for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6"}) {
    if (void* library = dlopen(name, RTLD_NOW | RTLD_LOCAL)) return library;
    reasons += std::string("; ") + dlerror();
  }
  throw InputError("the floor camera needs libOSMesa (Debian package libosmesa6), which cannot be loaded" + reasons);
}

/// The functions of libOSMesa that are used here, found by name.
class OsMesa {
 public:
  static const OsMesa& get() {
    static const OsMesa loaded;  // stays loaded: Mesa's threads and caches do not survive dlclose
    return loaded;
  }

#define COGSLAM_GL_FUNCTION(name) decltype(&::name) name = find<decltype(&::name)>(#name)

 private:
  template <class F>
  F find(const char* name) const {
    void* symbol = dlsym(library_, name);
    if (symbol == nullptr) throw InputError(std::string("libOSMesa has no function ") + name);
    return reinterpret_cast<F>(symbol);
  }
  void* library_ = open_library();

 public:
  COGSLAM_GL_FUNCTION(OSMesaCreateContextExt);
  COGSLAM_GL_FUNCTION(OSMesaDestroyContext);
  COGSLAM_GL_FUNCTION(OSMesaMakeCurrent);
  COGSLAM_GL_FUNCTION(OSMesaGetCurrentContext);
  COGSLAM_GL_FUNCTION(OSMesaPixelStore);
  COGSLAM_GL_FUNCTION(glGenTextures);
  COGSLAM_GL_FUNCTION(glBindTexture);
  COGSLAM_GL_FUNCTION(glTexImage2D);
  COGSLAM_GL_FUNCTION(glTexParameteri);
  COGSLAM_GL_FUNCTION(glGenerateMipmap);
  COGSLAM_GL_FUNCTION(glPixelStorei);
  COGSLAM_GL_FUNCTION(glEnable);
  COGSLAM_GL_FUNCTION(glDisable);
  COGSLAM_GL_FUNCTION(glTexEnvi);
  COGSLAM_GL_FUNCTION(glViewport);
  COGSLAM_GL_FUNCTION(glBegin);
  COGSLAM_GL_FUNCTION(glEnd);
  COGSLAM_GL_FUNCTION(glTexCoord2d);
  COGSLAM_GL_FUNCTION(glVertex2d);
  COGSLAM_GL_FUNCTION(glFinish);
#undef COGSLAM_GL_FUNCTION
};

}  // namespace

struct FloorRenderer::Context {
  const OsMesa& gl = OsMesa::get();
  int width;
  int height;
  std::vector<std::uint8_t> rgba;
  OSMesaContext handle = nullptr;

  Context(int w, int h) : width(w), height(h), rgba(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * 4) {
    handle = gl.OSMesaCreateContextExt(OSMESA_RGBA, 0, 0, 0, nullptr);
    if (handle == nullptr) throw InputError("libOSMesa gives no drawing context");
  }
  ~Context() { gl.OSMesaDestroyContext(handle); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  void make_current() {
    if (gl.OSMesaGetCurrentContext() == handle) return;
    if (gl.OSMesaMakeCurrent(handle, rgba.data(), GL_UNSIGNED_BYTE, width, height) != GL_TRUE) {
      throw InputError("libOSMesa cannot draw a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                       " pixels");
    }
    gl.OSMesaPixelStore(OSMESA_Y_UP, 0);
  }

  void upload(const FloorTexture& texture) {
    GLuint name = 0;
    gl.glGenTextures(1, &name);
    gl.glBindTexture(GL_TEXTURE_2D, name);
    gl.glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE8, FloorTexture::kSize, FloorTexture::kSize, 0, GL_LUMINANCE,
                    GL_UNSIGNED_BYTE, texture.grey.data());
    gl.glGenerateMipmap(GL_TEXTURE_2D);
    gl.glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    gl.glEnable(GL_TEXTURE_2D);
    gl.glDisable(GL_DITHER);
  }
};

FloorRenderer::FloorRenderer(const FloorTexture& texture, int width, int height) {
  EXPECTS(width > 0 && height > 0);
  context_ = std::make_unique<Context>(width, height);
  context_->make_current();
  context_->upload(texture);
}

FloorRenderer::~FloorRenderer() = default;

void FloorRenderer::render(const Corners& corners_map, std::span<std::uint8_t> grey) {
  Context& context = *context_;
  EXPECTS(grey.size() * 4 == context.rgba.size());
  context.make_current();
  const OsMesa& gl = context.gl;
  // Whole periods are taken off first: texture coordinates are floats, and must stay exact far from the origin.
  const Eigen::Vector2d period(std::floor(corners_map[0].x() / FloorTexture::kPeriod),
                               std::floor(corners_map[0].y() / FloorTexture::kPeriod));
  static constexpr std::array<std::array<double, 2>, 4> kScreen{{{-1.0, 1.0}, {1.0, 1.0}, {1.0, -1.0}, {-1.0, -1.0}}};
  gl.glViewport(0, 0, context.width, context.height);
  gl.glBegin(GL_QUADS);
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector2d p = corners_map[i] / FloorTexture::kPeriod - period;
    gl.glTexCoord2d(p.x(), p.y());
    gl.glVertex2d(kScreen[i][0], kScreen[i][1]);
  }
  gl.glEnd();
  gl.glFinish();
  for (std::size_t i = 0; i < grey.size(); ++i) grey[i] = context.rgba[4 * i];
}

}  // namespace cogslam
