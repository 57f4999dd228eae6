// Lists what Isolux reads from the driver: limits and extensions, with what happens where one is small or
// missing.
//
// OpenGL 4.5 core is required and not listed; everything beyond it is (glUses()). Objects check the sizes
// (gl_objects.cpp) and throw base::Error{memory, "graphics memory"}. `isolux doctor` prints glFacts().
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <GL/glcorearb.h>

namespace isolux::render {

struct Gl;

// Read once for each context. Zero: unknown.
struct GlLimits {
  bool software = true;           // a CPU rasteriser (llvmpipe, softpipe, swrast)
  GLint max3dTexture = 0;         // texels per axis
  GLint maxImage = 0;             // texels per axis of an image that is drawn into
  GLint maxBufferTexels = 0;      // texels of a buffer that is viewed as a texture
  GLint maxStorageBytes = 0;      // bytes of a buffer that shaders write to
  GLint maxPointSize = 0;         // pixels
  GLint timestampBits = 0;        // of GPU timers
  GLint programFormats = 0;       // formats of linked programs
  std::uint64_t memoryBytes = 0;  // for textures and buffers, as far as an extension tells
  const char* memorySource = "";  // that extension

  // Returns memory.gpu_budget_mb, but at most three quarters of the card's memory if it is known: images and
  // other programs need the rest.
  int budgetMb(int asked) const;
};

// Requires a current context and loaded functions.
GlLimits askLimits(const Gl& gl);
// Returns whether the context has the extension.
bool hasExtension(const Gl& gl, const char* name);

// A limit, or an extension, that Isolux uses.
struct GlUse {
  const char* name;     // of the limit without "GL_", or of the extension
  const char* purpose;  // what it serves
  const char* without;  // what happens if it is small or missing
};
std::span<const GlUse> glUses();

// A GlUse with the value of one context, as text: a number with its unit; of extensions "yes" or "no".
struct GlFact {
  GlUse use;
  std::string value;
};
// Omits extensions of EGL, which are known only while a context is made.
std::vector<GlFact> glFacts(const Gl& gl);

}  // namespace isolux::render
