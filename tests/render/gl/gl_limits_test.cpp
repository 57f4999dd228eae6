// What is read from drivers, with drivers that have little.
#include "render/gl/gl_limits.h"

#include <cstring>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "base/error.h"
#include "render/gl/gl.h"
#include "render/gl/gl_objects.h"

namespace isolux::test {
namespace {

using ::testing::HasSubstr;

// A driver that answers questions and draws nothing.
struct LimitedDriver {
  static inline std::vector<std::string> extensions;
  static inline std::string renderer;
  static inline GLint nvidiaKib = 0, atiKib = 0;
  static inline int calls = 0;  // that would allocate

  static std::shared_ptr<render::Gl> make(const std::string& name, std::vector<std::string> has) {
    extensions = std::move(has);
    renderer = name;
    nvidiaKib = atiKib = calls = 0;
    auto gl = std::make_shared<render::Gl>();
    gl->GetString = [](GLenum) { return reinterpret_cast<const GLubyte*>(renderer.c_str()); };
    gl->GetStringi = [](GLenum, GLuint i) { return reinterpret_cast<const GLubyte*>(extensions[i].c_str()); };
    gl->GetIntegerv = [](GLenum what, GLint* value) {
      if (what == GL_NUM_EXTENSIONS) *value = static_cast<GLint>(extensions.size());
      if (what == GL_MAX_3D_TEXTURE_SIZE) *value = 2048;
      if (what == GL_MAX_TEXTURE_SIZE) *value = 16384;
      if (what == GL_MAX_TEXTURE_BUFFER_SIZE) *value = 65536;
      if (what == 0x9048) *value = nvidiaKib;
      if (what == 0x87FC) *value = atiKib;
    };
    gl->GetQueryiv = [](GLenum, GLenum, GLint* value) { *value = 64; };
    gl->GetError = []() -> GLenum { return GL_NO_ERROR; };
    gl->CreateTextures = [](GLenum, GLsizei, GLuint* id) { *id = 1; };
    gl->CreateBuffers = [](GLsizei, GLuint* id) { *id = 1; };
    gl->DeleteTextures = [](GLsizei, const GLuint*) {};
    gl->DeleteBuffers = [](GLsizei, const GLuint*) {};
    gl->NamedBufferData = [](GLuint, GLsizeiptr, const void*, GLenum) {};
    gl->TextureBuffer = [](GLuint, GLenum, GLuint) { ++calls; };
    gl->TextureStorage2D = [](GLuint, GLsizei, GLenum, GLsizei, GLsizei) { ++calls; };
    gl->TextureStorage3D = [](GLuint, GLsizei, GLenum, GLsizei, GLsizei, GLsizei) { ++calls; };
    gl->TextureParameteri = [](GLuint, GLenum, GLint) {};
    return gl;
  }
};

TEST(GlLimitsTest, TheBudgetIsAtMostThreeQuartersOfTheCard) {
  auto gl = LimitedDriver::make("A card", {"GL_X", "GL_NVX_gpu_memory_info"});
  LimitedDriver::nvidiaKib = 2 << 20;
  const render::GlLimits limits = askLimits(*gl);
  EXPECT_EQ(limits.memoryBytes, std::uint64_t{2} << 30);
  EXPECT_STREQ(limits.memorySource, "GL_NVX_gpu_memory_info");
  EXPECT_EQ(limits.budgetMb(2048), 1536);
  EXPECT_EQ(limits.budgetMb(100), 100);
  EXPECT_EQ(limits.budgetMb(0), 0);
}

TEST(GlLimitsTest, MemoryIsReadFromTheOtherExtensionToo) {
  auto gl = LimitedDriver::make("Another card", {"GL_ATI_meminfo"});
  LimitedDriver::atiKib = 1 << 20;
  EXPECT_EQ(askLimits(*gl).budgetMb(2048), 768);
}

TEST(GlLimitsTest, WithoutExtensionsTheSettingIsTheLimit) {
  auto gl = LimitedDriver::make("A third card", {});
  LimitedDriver::nvidiaKib = LimitedDriver::atiKib = 1 << 20;  // not asked for
  EXPECT_EQ(askLimits(*gl).budgetMb(2048), 2048);
  // What an integrated card sets aside, and nonsense, are not its memory.
  for (const GLint kib : {0, 1 << 15}) {
    gl = LimitedDriver::make("A fourth card", {"GL_NVX_gpu_memory_info"});
    LimitedDriver::nvidiaKib = kib;
    EXPECT_EQ(askLimits(*gl).budgetMb(2048), 2048) << kib;
  }
  // Textures of a software driver are in main memory.
  gl = LimitedDriver::make("llvmpipe (LLVM 15.0.6, 256 bits)", {"GL_NVX_gpu_memory_info"});
  LimitedDriver::nvidiaKib = 1 << 20;
  EXPECT_EQ(askLimits(*gl).budgetMb(2048), 2048);
}

void expectTooLarge(const std::function<void()>& make, const std::string& words) {
  try {
    make();
    FAIL() << words;
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::memory);
    EXPECT_EQ(error.place(), "graphics memory");
    EXPECT_THAT(error.reason(), HasSubstr(words));
  }
  EXPECT_EQ(LimitedDriver::calls, 0);
}

TEST(GlLimitsTest, WhatIsTooLargeIsAnErrorBeforeTheDriverIsAsked) {
  auto gl = LimitedDriver::make("A card", {});
  static_cast<render::GlLimits&>(*gl) = askLimits(*gl);
  using render::Texture;
  expectTooLarge([&] { Texture::make2D(gl, GL_RGBA8, {16385, 4}); }, "an image of 16385 texels");
  expectTooLarge([&] { Texture::make3D(gl, GL_R8, {4, 4, 2049}, true); }, "a volume of 2049 texels");
  expectTooLarge(
      [&] {
        render::Buffer buffer(gl);
        buffer.setData(nullptr, 65537 * 8);
        const render::BufferTexture texture(buffer, GL_RG32UI);
      },
      "65537 texels");
  Texture::make2D(gl, GL_RGBA8, {16384, 4});
  Texture::make3D(gl, GL_R8, {4, 4, 2048}, true);
  render::Buffer buffer(gl);
  buffer.setData(nullptr, 65536 * 8);
  const render::BufferTexture texture(buffer, GL_RG32UI);
  EXPECT_EQ(LimitedDriver::calls, 3);
}

TEST(GlLimitsTest, EachUseSaysWhatHappensWithoutIt) {
  for (const render::GlUse& use : render::glUses()) {
    EXPECT_GT(std::strlen(use.purpose), 5u) << use.name;
    EXPECT_GT(std::strlen(use.without), 5u) << use.name;
  }
  auto gl = LimitedDriver::make("A card", {"GL_NVX_gpu_memory_info"});
  LimitedDriver::nvidiaKib = 8 << 20;
  static_cast<render::GlLimits&>(*gl) = askLimits(*gl);
  std::map<std::string, std::string> values;
  for (const render::GlFact& fact : glFacts(*gl)) values[fact.use.name] = fact.value;
  EXPECT_EQ(values["MAX_3D_TEXTURE_SIZE"], "2048 texels");
  EXPECT_EQ(values["GL_NVX_gpu_memory_info"], "yes");
  EXPECT_EQ(values["GL_ATI_meminfo"], "no");
}

}  // namespace
}  // namespace isolux::test
