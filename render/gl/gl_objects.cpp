#include "render/gl/gl_objects.h"

#include <algorithm>
#include <stdexcept>

#include "base/error.h"
#include "render/gl/gl_messages.h"
#include "render/gl/program_cache.h"
#include "render/gl/shader_library.h"

namespace isolux::render {

namespace {

template <class Create>
GLuint created(Create create) {
  GLuint id = 0;
  create(&id);
  return id;
}

std::size_t texelBytes(GLenum internalFormat) {
  switch (internalFormat) {
    case GL_R8:
      return 1;
    case GL_R16:
    case GL_R16F:
      return 2;
    case GL_RG16F:
    case GL_R32F:
    case GL_R32UI:
    case GL_RGBA8:
      return 4;
    case GL_RG32F:
    case GL_RG32UI:
    case GL_RGBA16UI:
    case GL_RGBA16F:
      return 8;
    case GL_RGB32F:
      return 12;
    case GL_RGBA32F:
    case GL_RGBA32UI:
      return 16;
    default:
      throw std::logic_error("texelBytes: unknown internal format");
  }
}

void checkMemory(const Gl& gl, const char* what, std::size_t bytes) {
  if (gl.GetError() != GL_OUT_OF_MEMORY) return;
  forgetGlErrors();  // it is answered here
  throw base::Error(base::ErrorKind::memory, "", "graphics memory",
                    "no room for " + std::string(what) + " of " + std::to_string(bytes >> 20) + " MiB");
}

// Asks for what a software driver is about to allocate; nothing for a GPU, which has memory of its own.
base::MemoryBudget::Held ownMemory(const Gl& gl, std::size_t bytes, const char* what, const char* remedy) {
  if (!gl.software) return {};
  return base::machineMemory().reserve(bytes, what, remedy);
}

// Throws where something is larger than the driver allows.
void checkSize(const char* what, std::size_t asked, GLint most, const char* unit) {
  if (asked <= static_cast<std::size_t>(std::max(most, 0))) return;
  throw base::Error(base::ErrorKind::memory, "", "graphics memory",
                    std::string(what) + " of " + std::to_string(asked) + ' ' + unit +
                        " is too large for this driver, which allows " + std::to_string(most));
}

std::size_t longestOf(glm::ivec3 size) {
  return static_cast<std::size_t>(std::max({size.x, size.y, size.z, 0}));
}

constexpr const char* kSmallerPicture = "a smaller image or a lower picture.supersampling needs less";
constexpr const char* kLessOnGpu = "a lower memory.gpu_budget_mb needs less";

}  // namespace

Texture::Texture(const GlPtr& gl, GLenum target, glm::ivec3 size, std::size_t bytes, const char* what,
                 const char* remedy)
    : GlObject(gl, created([&](GLuint* id) { gl->CreateTextures(target, 1, id); })),
      size_(size),
      bytes_(bytes),
      held_(ownMemory(*gl, bytes, what, remedy)) {
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl->TextureParameteri(id(), wrap, GL_CLAMP_TO_EDGE);
}

Texture Texture::make2D(const GlPtr& gl, GLenum internalFormat, glm::ivec2 size) {
  checkSize("an image", longestOf({size, 1}), gl->maxImage, "texels on an axis");
  const std::size_t bytes = volume::Extent2{size}.count() * texelBytes(internalFormat);
  Texture texture(gl, GL_TEXTURE_2D, {size, 1}, bytes, "an image of the picture", kSmallerPicture);
  gl->TextureStorage2D(texture.id(), 1, internalFormat, size.x, size.y);
  checkMemory(*gl, "an image", bytes);
  texture.setFilter(GL_NEAREST);
  return texture;
}

Texture Texture::make3D(const GlPtr& gl, GLenum internalFormat, glm::ivec3 size, bool linear) {
  checkSize("a volume", longestOf(size), gl->max3dTexture, "texels on an axis");
  const std::size_t bytes = volume::Extent3{size}.count() * texelBytes(internalFormat);
  Texture texture(gl, GL_TEXTURE_3D, size, bytes, "the volume's texture", kLessOnGpu);
  gl->TextureStorage3D(texture.id(), 1, internalFormat, size.x, size.y, size.z);
  checkMemory(*gl, "a volume", bytes);
  texture.setFilter(linear ? GL_LINEAR : GL_NEAREST);
  return texture;
}

void Texture::write(GLenum format, GLenum type, const void* texels, const volume::Rectangle& part) const {
  gl().PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl().TextureSubImage2D(id(), 0, part.low.x, part.low.y, part.size.x, part.size.y, format, type, texels);
}

void Texture::write(GLenum format, GLenum type, const void* texels, glm::ivec3 low, glm::ivec3 size) const {
  gl().PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl().TextureSubImage3D(id(), 0, low.x, low.y, low.z, size.x, size.y, size.z, format, type, texels);
}

void Texture::setFilter(GLenum filter) {
  for (const GLenum which : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl().TextureParameteri(id(), which, static_cast<GLint>(filter));
}

std::vector<float> Texture::readFloats(int channels, const volume::Rectangle& part) const {
  constexpr GLenum formats[] = {0, GL_RED, GL_RG, GL_RGB, GL_RGBA};
  const std::size_t row = static_cast<std::size_t>(part.size.x) * static_cast<std::size_t>(channels);
  const std::size_t count = row * static_cast<std::size_t>(part.size.y);
  base::machineMemory().check(count * sizeof(float), "a copy of the image", kSmallerPicture);
  std::vector<float> values(count);
  gl().PixelStorei(GL_PACK_ALIGNMENT, 1);
  // Rows at a time: sizes are 32 bits for GL, and a card does nothing else during one copy.
  constexpr std::size_t most = std::size_t{1} << 25;  // bytes
  const int rows = static_cast<int>(std::max<std::size_t>(most / (row * sizeof(float)), 1));
  for (int y = 0; y < part.size.y; y += rows) {
    const int height = std::min(rows, part.size.y - y);
    gl().GetTextureSubImage(id(), 0, part.low.x, part.low.y + y, 0, part.size.x, height, 1, formats[channels],
                            GL_FLOAT,
                            static_cast<GLsizei>(row * static_cast<std::size_t>(height) * sizeof(float)),
                            &values[static_cast<std::size_t>(y) * row]);
  }
  return values;
}

Buffer::Buffer(const GlPtr& gl) : GlObject(gl, created([&](GLuint* id) { gl->CreateBuffers(1, id); })) {}

void Buffer::setData(const void* data, std::size_t bytes) {
  if (bytes > bytes_) {
    held_.release();
    held_ = ownMemory(gl(), bytes, "a buffer of the renderer", kLessOnGpu);
  }
  gl().NamedBufferData(id(), static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
  checkMemory(gl(), "a buffer", bytes);
  bytes_ = bytes;
}

void Buffer::write(std::size_t offset, const void* data, std::size_t bytes) {
  if (bytes > 0)
    gl().NamedBufferSubData(id(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), data);
}

BufferTexture::BufferTexture(const Buffer& buffer, GLenum internalFormat)
    : GlObject(buffer.pointer(),
               created([&](GLuint* id) { buffer.gl().CreateTextures(GL_TEXTURE_BUFFER, 1, id); })) {
  checkSize("a texture in a buffer", buffer.bytes() / texelBytes(internalFormat), gl().maxBufferTexels,
            "texels");
  gl().TextureBuffer(id(), internalFormat, buffer.id());
}

VertexArray::VertexArray(const GlPtr& gl)
    : GlObject(gl, created([&](GLuint* id) { gl->CreateVertexArrays(1, id); })) {}

Framebuffer::Framebuffer(const GlPtr& gl, const std::vector<const Texture*>& colors)
    : GlObject(gl, created([&](GLuint* id) { gl->CreateFramebuffers(1, id); })),
      colors_(static_cast<int>(colors.size())) {
  std::vector<GLenum> attachments;
  for (const Texture* color : colors) {
    attachments.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(attachments.size()));
    gl->NamedFramebufferTexture(id(), attachments.back(), color->id(), 0);
  }
  gl->NamedFramebufferDrawBuffers(id(), static_cast<GLsizei>(attachments.size()), attachments.data());
  if (gl->CheckNamedFramebufferStatus(id(), GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw base::Error(base::ErrorKind::graphics, "", "OpenGL", "the driver cannot draw into float images");
}

Query::Query(const GlPtr& gl, GLenum kind)
    : GlObject(gl, created([&](GLuint* id) { gl->CreateQueries(kind, 1, id); })) {}

GLuint64 Query::result(GLenum what) const {
  GLuint64 value = 0;
  gl().GetQueryObjectui64v(id(), what, &value);
  return value;
}

double millisecondsBetween(const Query& from, const Query& to) {
  const GLuint64 begin = from.result(), end = to.result();
  return end > begin ? static_cast<double>(end - begin) * 1e-6 : 0.0;
}

namespace {

using Shader = GlObject<&Gl::DeleteShader>;

Shader compiled(const GlPtr& pointer, GLenum stage, const std::string& source, const std::string& words) {
  const Gl& gl = *pointer;
  const char* text = source.c_str();
  Shader shader(pointer, gl.CreateShader(stage));
  gl.ShaderSource(shader.id(), 1, &text, nullptr);
  gl.CompileShader(shader.id());
  GLint good = 0;
  gl.GetShaderiv(shader.id(), GL_COMPILE_STATUS, &good);
  if (!good) {
    char log[4096] = "";
    gl.GetShaderInfoLog(shader.id(), sizeof log, nullptr, log);
    throw std::logic_error("shader " + words + " does not compile: " + log);
  }
  return shader;
}

}  // namespace

Program::Program(const GlPtr& gl, const std::string& vertex, const std::string& fragment,
                 const std::string& defines)
    : Program(ofTexts(gl, shaderSource(vertex, defines), shaderSource(fragment, defines),
                      vertex + " + " + fragment)) {}

Program Program::ofTexts(const GlPtr& gl, const std::string& vertex, const std::string& fragment,
                         const std::string& words) {
  Program program(gl, gl->CreateProgram());
  ProgramCache* const cache = gl->programs.get();
  if (cache && cache->load(*gl, program.id(), vertex, fragment)) return program;
  if (cache) cache->beforeLink(*gl, program.id());
  const Shader vertexShader = compiled(gl, GL_VERTEX_SHADER, vertex, words);
  const Shader fragmentShader = compiled(gl, GL_FRAGMENT_SHADER, fragment, words);
  gl->AttachShader(program.id(), vertexShader.id());
  gl->AttachShader(program.id(), fragmentShader.id());
  gl->LinkProgram(program.id());
  gl->DetachShader(program.id(), vertexShader.id());
  gl->DetachShader(program.id(), fragmentShader.id());
  GLint good = 0;
  gl->GetProgramiv(program.id(), GL_LINK_STATUS, &good);
  if (!good) {
    char log[4096] = "";
    gl->GetProgramInfoLog(program.id(), sizeof log, nullptr, log);
    throw std::logic_error("program " + words + " does not link: " + log);
  }
  if (cache) cache->store(*gl, program.id(), vertex, fragment);
  return program;
}

GLint Program::location(const char* name) {
  const auto found = locations_.find(name);
  if (found != locations_.end()) return found->second;
  return locations_[name] = gl().GetUniformLocation(id(), name);
}

void Program::setTexture(const char* name, int unit, const GlObject<&Gl::DeleteTextures>& texture) {
  gl().BindTextureUnit(static_cast<GLuint>(unit), texture.id());
  set(name, unit);
}

}  // namespace isolux::render
