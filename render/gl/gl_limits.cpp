#include "render/gl/gl_limits.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

#include "render/gl/gl.h"

namespace isolux::render {

namespace {

constexpr const char* kNvidiaMemory = "GL_NVX_gpu_memory_info";
constexpr const char* kAtiMemory = "GL_ATI_meminfo";
// Not in glcorearb.h; both in KiB.
constexpr GLenum kTotalMemoryNvx = 0x9048, kTextureFreeMemoryAti = 0x87FC;

// Less is no card's memory, but the part of an integrated one that the firmware sets aside.
constexpr std::uint64_t kLeastMemory = std::uint64_t{64} << 20;

constexpr std::array kUses{
    GlUse{"MAX_3D_TEXTURE_SIZE", "largest axis of a volume in one texture",
          "volumes with a longer axis are drawn in bricks"},
    GlUse{"MAX_TEXTURE_SIZE", "largest axis of an image", "larger images are drawn in tiles"},
    GlUse{"MAX_TEXTURE_BUFFER_SIZE", "baked light and its page table",
          "light beyond it stays unshadowed (4.5 guarantees 65536)"},
    GlUse{"MAX_SHADER_STORAGE_BLOCK_SIZE", "marks of the bricks that rays use",
          "volumes of more bricks than it holds marks for are rejected"},
    GlUse{"POINT_SIZE_RANGE", "squares of tiles that rays start in", "more and smaller squares are drawn"},
    GlUse{"QUERY_COUNTER_BITS", "times of passes and of parts of draws",
          "draws are cut by wall time, and the driver finishes each part"},
    GlUse{"NUM_PROGRAM_BINARY_FORMATS", "linked programs in the cache folder",
          "each start compiles the programs it needs"},
    GlUse{kNvidiaMemory, "memory of the card", "GL_ATI_meminfo is read instead"},
    GlUse{kAtiMemory, "memory of the card", "memory.gpu_budget_mb is the only limit"},
    GlUse{"EGL_EXT_device_enumeration", "a GPU without a display", "EGL surfaceless, then OSMesa"},
    GlUse{"EGL_EXT_platform_device", "a GPU without a display", "EGL surfaceless, then OSMesa"},
    GlUse{"EGL_MESA_platform_surfaceless", "Mesa without a device", "OSMesa"},
    GlUse{"EGL_KHR_surfaceless_context", "contexts without a surface", "OSMesa"},
    GlUse{"EGL_KHR_no_config_context", "contexts where no configuration suits", "OSMesa"},
};

GLint integerOf(const Gl& gl, GLenum name) {
  GLint value = 0;
  gl.GetIntegerv(name, &value);
  return value;
}

bool isSoftware(const std::string& renderer) {
  for (const char* name : {"llvmpipe", "softpipe", "swrast", "SWR", "Software Rasterizer"})
    if (renderer.find(name) != std::string::npos) return true;
  return false;
}

// Textures of software drivers are in main memory, which has its own budget.
void askMemory(const Gl& gl, GlLimits& limits) {
  if (limits.software) return;
  GLint kib[4] = {0, 0, 0, 0};
  if (hasExtension(gl, kNvidiaMemory)) {
    gl.GetIntegerv(kTotalMemoryNvx, kib);
    limits.memorySource = kNvidiaMemory;
  } else if (hasExtension(gl, kAtiMemory)) {
    gl.GetIntegerv(kTextureFreeMemoryAti, kib);
    limits.memorySource = kAtiMemory;
  }
  limits.memoryBytes = static_cast<std::uint64_t>(static_cast<GLuint>(kib[0])) << 10;
  if (limits.memoryBytes < kLeastMemory) {
    limits.memoryBytes = 0;
    limits.memorySource = "";
  }
}

std::string mebibytes(std::uint64_t bytes) {
  return std::to_string(bytes >> 20) + " MiB";
}

std::string valueOf(const Gl& gl, std::string_view name) {
  if (name == "MAX_3D_TEXTURE_SIZE") return std::to_string(gl.max3dTexture) + " texels";
  if (name == "MAX_TEXTURE_SIZE") return std::to_string(gl.maxImage) + " texels";
  if (name == "MAX_TEXTURE_BUFFER_SIZE") return std::to_string(gl.maxBufferTexels) + " texels";
  if (name == "MAX_SHADER_STORAGE_BLOCK_SIZE")
    return mebibytes(static_cast<std::uint64_t>(std::max(gl.maxStorageBytes, 0)));
  if (name == "POINT_SIZE_RANGE") return std::to_string(gl.maxPointSize) + " pixels";
  if (name == "QUERY_COUNTER_BITS") return std::to_string(gl.timestampBits) + " bits";
  if (name == "NUM_PROGRAM_BINARY_FORMATS") return std::to_string(gl.programFormats);
  if (!hasExtension(gl, name.data())) return "no";
  return "yes";
}

}  // namespace

int GlLimits::budgetMb(int asked) const {
  if (memoryBytes == 0) return asked;
  return static_cast<int>(
      std::min<std::uint64_t>(static_cast<std::uint64_t>(std::max(asked, 0)), (memoryBytes >> 20) / 4 * 3));
}

GlLimits askLimits(const Gl& gl) {
  GlLimits limits;
  limits.software = isSoftware(gl.string(GL_RENDERER));
  limits.max3dTexture = integerOf(gl, GL_MAX_3D_TEXTURE_SIZE);
  limits.maxImage = integerOf(gl, GL_MAX_TEXTURE_SIZE);
  limits.maxBufferTexels = integerOf(gl, GL_MAX_TEXTURE_BUFFER_SIZE);
  limits.maxStorageBytes = integerOf(gl, GL_MAX_SHADER_STORAGE_BLOCK_SIZE);
  GLint points[2] = {1, 1};
  gl.GetIntegerv(GL_POINT_SIZE_RANGE, points);
  limits.maxPointSize = points[1];
  gl.GetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &limits.timestampBits);
  limits.programFormats = integerOf(gl, GL_NUM_PROGRAM_BINARY_FORMATS);
  askMemory(gl, limits);
  return limits;
}

bool hasExtension(const Gl& gl, const char* name) {
  const GLint count = integerOf(gl, GL_NUM_EXTENSIONS);
  for (GLint i = 0; i < count; ++i)
    if (const GLubyte* const one = gl.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
        one && std::strcmp(reinterpret_cast<const char*>(one), name) == 0)
      return true;
  return false;
}

std::span<const GlUse> glUses() {
  return kUses;
}

std::vector<GlFact> glFacts(const Gl& gl) {
  std::vector<GlFact> facts;
  for (const GlUse& use : kUses)
    if (!std::string_view(use.name).starts_with("EGL_")) facts.push_back({use, valueOf(gl, use.name)});
  return facts;
}

}  // namespace isolux::render
