#include "render/gl/gl.h"

#include "render/gl/gl_messages.h"
#include "render/gl/program_cache.h"

namespace isolux::render {

namespace {
constexpr GLenum kOff[] = {GL_BLEND,
                           GL_DEPTH_TEST,
                           GL_CULL_FACE,
                           GL_SCISSOR_TEST,
                           GL_STENCIL_TEST,
                           GL_DITHER,
                           GL_FRAMEBUFFER_SRGB,
                           GL_RASTERIZER_DISCARD,
                           GL_SAMPLE_ALPHA_TO_COVERAGE,
                           GL_COLOR_LOGIC_OP,
                           GL_POLYGON_OFFSET_FILL,
                           GL_DEPTH_CLAMP,
                           GL_PRIMITIVE_RESTART,
                           GL_PRIMITIVE_RESTART_FIXED_INDEX,
                           GL_SAMPLE_COVERAGE,
                           GL_SAMPLE_MASK,
                           GL_MULTISAMPLE};
constexpr GLenum kZeroStores[] = {GL_UNPACK_ROW_LENGTH, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_PIXELS,
                                  GL_UNPACK_SKIP_ROWS,  GL_UNPACK_SKIP_IMAGES,  GL_UNPACK_SWAP_BYTES,
                                  GL_UNPACK_LSB_FIRST,  GL_PACK_ROW_LENGTH,     GL_PACK_SKIP_PIXELS,
                                  GL_PACK_SKIP_ROWS,    GL_PACK_IMAGE_HEIGHT,   GL_PACK_SKIP_IMAGES,
                                  GL_PACK_SWAP_BYTES,   GL_PACK_LSB_FIRST};
constexpr GLuint kClipDistances = 8, kTextureUnits = 16;

[[noreturn]] void fail(const std::string& reason) {
  throw base::Error(base::ErrorKind::graphics, "", "OpenGL", reason);
}
}  // namespace

std::shared_ptr<const Gl> Gl::load(const GlLoader& loader) {
  auto gl = std::make_shared<Gl>();
  // The version first: an old context lacks functions, and "GL 3.1" says more than a missing name.
  gl->GetString = reinterpret_cast<PFNGLGETSTRINGPROC>(loader("glGetString"));
  gl->GetIntegerv = reinterpret_cast<PFNGLGETINTEGERVPROC>(loader("glGetIntegerv"));
  if (!gl->GetString || !gl->GetIntegerv || !gl->GetString(GL_VERSION)) fail("no context is current");
  GLint major = 0, minor = 0;
  gl->GetIntegerv(GL_MAJOR_VERSION, &major);
  gl->GetIntegerv(GL_MINOR_VERSION, &minor);
  if (major * 10 + minor < 45)
    fail("version 4.5 core is needed, found " + gl->string(GL_VERSION) + " on " + gl->string(GL_RENDERER));
#define ISOLUX_GL(type, name)                            \
  gl->name = reinterpret_cast<type>(loader("gl" #name)); \
  if (!gl->name) fail("the driver has no gl" #name);
#include "render/gl/gl_functions.inc"
#undef ISOLUX_GL
  static_cast<GlLimits&>(*gl) = askLimits(*gl);
  gl->programs = std::make_shared<ProgramCache>(*gl, programStore());
  listenToGl(*gl);
  return gl;
}

std::string Gl::string(GLenum name) const {
  const GLubyte* text = GetString(name);
  return text ? reinterpret_cast<const char*>(text) : "";
}

void Gl::throwIfLost() const {
  if (GetGraphicsResetStatus() != GL_NO_ERROR) throw ContextLost();
}

void Gl::setKnownState() const {
  for (const GLenum off : kOff) Disable(off);
  for (GLuint i = 0; i < kClipDistances; ++i) Disable(GL_CLIP_DISTANCE0 + i);
  ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  BlendEquation(GL_FUNC_ADD);
  BlendFunc(GL_ONE, GL_ZERO);
  PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  for (const GLenum store : kZeroStores) PixelStorei(store, 0);
  for (const GLenum buffer : {GL_PIXEL_UNPACK_BUFFER, GL_PIXEL_PACK_BUFFER}) BindBuffer(buffer, 0);
  for (GLuint unit = 0; unit < kTextureUnits; ++unit) BindSampler(unit, 0);
}

}  // namespace isolux::render
