#include "render/gl/gl_state.h"

#include "render/gl/gl.h"

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

}  // namespace

void setKnownState(const Gl& gl) {
  for (const GLenum off : kOff) gl.Disable(off);
  for (GLuint i = 0; i < kClipDistances; ++i) gl.Disable(GL_CLIP_DISTANCE0 + i);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFunc(GL_ONE, GL_ZERO);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  for (const GLenum store : kZeroStores) gl.PixelStorei(store, 0);
  for (const GLenum buffer : {GL_PIXEL_UNPACK_BUFFER, GL_PIXEL_PACK_BUFFER}) gl.BindBuffer(buffer, 0);
  for (GLuint unit = 0; unit < kTextureUnits; ++unit) gl.BindSampler(unit, 0);
}

}  // namespace isolux::render
