// Provides owners of GL objects: move-only, created and edited without binding (direct state access), deleted
// with their owner. Requires that the context that created an object is current when it is deleted.
#pragma once

#include <memory>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "base/memory_budget.h"
#include "render/gl/gl.h"
#include "volume/cast/picture_area.h"

namespace isolux::render {

using GlPtr = std::shared_ptr<const Gl>;

// Holds an object's id and the table it was created with; `Delete` is the table's function that deletes it.
template <auto Delete>
class GlObject {
 public:
  GlObject() = default;
  GlObject(GlPtr gl, GLuint id) : gl_(std::move(gl)), id_(id) {}
  GlObject(GlObject&& other) noexcept : gl_(std::move(other.gl_)), id_(std::exchange(other.id_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(id_, other.id_);
    return *this;
  }
  ~GlObject() {
    if (!id_) return;
    if constexpr (std::is_invocable_v<decltype(gl_.get()->*Delete), GLuint>)
      (gl_.get()->*Delete)(id_);
    else
      (gl_.get()->*Delete)(1, &id_);
  }
  GLuint id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }
  const Gl& gl() const { return *gl_; }
  const GlPtr& pointer() const { return gl_; }

 private:
  GlPtr gl_;
  GLuint id_ = 0;
};

// A 2D or 3D texture with immutable storage and one level.
class Texture : public GlObject<&Gl::DeleteTextures> {
 public:
  Texture() = default;
  // Create a texture. `internalFormat`: GL_RGBA32F ...; nearest filtering, clamped. Throw
  // base::Error{memory}: an axis is longer than the driver allows, or memory is short.
  static Texture make2D(const GlPtr& gl, GLenum internalFormat, glm::ivec2 size);
  static Texture make3D(const GlPtr& gl, GLenum internalFormat, glm::ivec3 size, bool linear);
  glm::ivec3 size() const { return size_; }
  std::size_t bytes() const { return bytes_; }
  void setFilter(GLenum filter);  // GL_NEAREST, GL_LINEAR
  // Uploads texels without gaps between their rows, bottom row first: all of a 2D texture, or a part of one.
  void write(GLenum format, GLenum type, const void* texels) const {
    write(format, type, texels, {glm::ivec2(0), glm::ivec2(size_)});
  }
  void write(GLenum format, GLenum type, const void* texels, const volume::Rectangle& part) const;
  // The same of a 3D texture.
  void write(GLenum format, GLenum type, const void* texels, glm::ivec3 low, glm::ivec3 size) const;
  // Returns the whole image as floats, `channels` interleaved, bottom row first.
  std::vector<float> readFloats(int channels) const {
    return readFloats(channels, {glm::ivec2(0), glm::ivec2(size_)});
  }
  std::vector<float> readFloats(int channels, const volume::Rectangle& part) const;

 private:
  Texture(const GlPtr& gl, GLenum target, glm::ivec3 size, std::size_t bytes, const char* what,
          const char* remedy);
  glm::ivec3 size_{0};
  std::size_t bytes_ = 0;
  base::MemoryBudget::Held held_;  // of a software driver, whose textures are in main memory
};

class Buffer : public GlObject<&Gl::DeleteBuffers> {
 public:
  Buffer() = default;
  explicit Buffer(const GlPtr& gl);
  void setData(const void* data, std::size_t bytes);  // reallocates; null: contents undefined
  // Requires that the range is within what setData() allocated.
  void write(std::size_t offset, const void* data, std::size_t bytes);
  std::size_t bytes() const { return bytes_; }

 private:
  std::size_t bytes_ = 0;
  base::MemoryBudget::Held held_;  // as for textures
};

// A buffer viewed as a texture (usamplerBuffer): GL_R32UI, GL_RG32UI.
class BufferTexture : public GlObject<&Gl::DeleteTextures> {
 public:
  BufferTexture() = default;
  // Throws base::Error{memory} if the buffer has more texels than the driver allows.
  BufferTexture(const Buffer& buffer, GLenum internalFormat);
};

class VertexArray : public GlObject<&Gl::DeleteVertexArrays> {
 public:
  VertexArray() = default;
  explicit VertexArray(const GlPtr& gl);
};

class Framebuffer : public GlObject<&Gl::DeleteFramebuffers> {
 public:
  Framebuffer() = default;
  // Takes the colour attachments 0.. in order. Throws base::Error{graphics} if incomplete.
  Framebuffer(const GlPtr& gl, const std::vector<const Texture*>& colors);
  int colors() const { return colors_; }  // attached

 private:
  int colors_ = 0;
};

class Query : public GlObject<&Gl::DeleteQueries> {
 public:
  Query() = default;
  explicit Query(const GlPtr& gl, GLenum kind = GL_TIMESTAMP);
  GLuint64 result(GLenum what = GL_QUERY_RESULT) const;  // waits for it
};

double millisecondsBetween(const Query& from, const Query& to);  // of timestamps

// A linked vertex and fragment program. Sets uniforms by name and caches their locations. Setting a uniform
// that the compiler removed is allowed (it depends on defines).
class Program : public GlObject<&Gl::DeleteProgram> {
 public:
  Program() = default;
  // Takes names of embedded shaders. Throws std::logic_error with the compiler's log: an error in them is
  // internal.
  Program(const GlPtr& gl, const std::string& vertex, const std::string& fragment,
          const std::string& defines = "");
  // Makes a program from GLSL texts (shader_library.h); `words` name them in errors.
  static Program ofTexts(const GlPtr& gl, const std::string& vertex, const std::string& fragment,
                         const std::string& words);

  bool uses(const char* name) { return location(name) >= 0; }
  void set(const char* name, float value) { gl().ProgramUniform1f(id(), location(name), value); }
  void set(const char* name, const std::vector<float>& values) {
    gl().ProgramUniform1fv(id(), location(name), static_cast<GLsizei>(values.size()), values.data());
  }
  void set(const char* name, int value) { gl().ProgramUniform1i(id(), location(name), value); }
  void set(const char* name, glm::vec2 v) { gl().ProgramUniform2f(id(), location(name), v.x, v.y); }
  void set(const char* name, glm::ivec2 v) { gl().ProgramUniform2i(id(), location(name), v.x, v.y); }
  void set(const char* name, glm::vec3 v) { gl().ProgramUniform3f(id(), location(name), v.x, v.y, v.z); }
  void set(const char* name, glm::vec4 v) { gl().ProgramUniform4f(id(), location(name), v.x, v.y, v.z, v.w); }
  void set(const char* name, glm::ivec3 v) { gl().ProgramUniform3i(id(), location(name), v.x, v.y, v.z); }
  void set(const char* name, const glm::mat3& v) {
    gl().ProgramUniformMatrix3fv(id(), location(name), 1, GL_FALSE, &v[0][0]);
  }
  void set(const char* name, const glm::mat4& v) {
    gl().ProgramUniformMatrix4fv(id(), location(name), 1, GL_FALSE, &v[0][0]);
  }
  // Binds `texture` to unit `unit` and assigns the unit to the sampler.
  void setTexture(const char* name, int unit, const GlObject<&Gl::DeleteTextures>& texture);

 private:
  Program(GlPtr gl, GLuint id) : GlObject(std::move(gl), id) {}
  GLint location(const char* name);
  std::unordered_map<std::string, GLint> locations_;
};

}  // namespace isolux::render
