// Shaders by themselves: a fragment shader, or functions of one, on values that no picture shows.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "render/gl/gl_objects.h"
#include "render/gl/shader_library.h"
#include "tests/render/gl_fixture.h"

namespace isolux::test {

using ShaderRow = std::vector<glm::vec4>;  // a texel or a result for each pixel

class ShaderGlTest : public RenderGlTest {
 protected:
  static constexpr float kHuge = 3e38f;

  void SetUp() override {
    RenderGlTest::SetUp();
    array_ = render::VertexArray(context_->gl());
  }
  void TearDown() override {
    context_->gl()->UseProgram(0);
    context_->gl()->BindVertexArray(0);
    context_->gl()->BindFramebuffer(GL_FRAMEBUFFER, 0);
    program_ = {};
    images_.clear();
    textures_.clear();
    array_ = {};
    RenderGlTest::TearDown();
  }

  // The whole fragment shader.
  void useShader(const std::string& name, const std::string& defines = "") {
    program_ = render::Program(context_->gl(), "fullscreen.vert.glsl", name, defines);
  }
  // Functions of `files`, of which a main() does not count. `body` sees given(k), the k-th input's texel of
  // this pixel (in constants a compiler would do the arithmetic itself), and writes `result`.
  void useFunctions(const std::vector<std::string>& files, const std::string& body,
                    const std::string& defines = "") {
    std::string text = "#define main mainOfShader\n";
    for (const std::string& file : files) text += "#include \"" + file + "\"\n";
    text +=
        "#undef main\nuniform sampler2D uInputs[4];\n"
        "#define given(k) texelFetch(uInputs[k], ivec2(int(gl_FragCoord.x), 0), 0)\n"
        "layout(location = " +
        std::to_string(kResult) +
        ") out vec4 result;\n"
        "void main() {\n" +
        body + "\n}\n";
    program_ = render::Program::ofTexts(context_->gl(), render::shaderSource("fullscreen.vert.glsl"),
                                        render::shaderSourceOf(text, defines), files.back());
  }

  template <class Value>
  void set(const char* name, const Value& value) {
    program_.set(name, value);
  }
  // Pictures of this many rows: shaders that look at their neighbours are judged in the middle one.
  void setRows(int rows) { rows_ = rows; }
  // A texture: one row that is repeated, or each.
  void setRow(const std::string& name, const ShaderRow& texels) {
    setImage(name, std::vector<ShaderRow>(static_cast<std::size_t>(rows_), texels));
  }
  void setImage(const std::string& name, const std::vector<ShaderRow>& rows) {
    const auto width = static_cast<int>(rows[0].size());
    render::Texture texture =
        render::Texture::make2D(context_->gl(), GL_RGBA32F, {width, static_cast<int>(rows.size())});
    for (std::size_t y = 0; y < rows.size(); ++y)
      context_->gl()->TextureSubImage2D(texture.id(), 0, 0, static_cast<int>(y), width, 1, GL_RGBA, GL_FLOAT,
                                        rows[y].data());
    bind(name, std::move(texture));
  }
  void setInput(int k, const ShaderRow& texels) { setRow("uInputs[" + std::to_string(k) + "]", texels); }
  // A texture of a volume, x fastest.
  template <class F>
  void setVolume(const char* name, glm::ivec3 dims, const F& texelAt) {
    std::vector<float> texels;
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y)
        for (int x = 0; x < dims.x; ++x) texels.push_back(static_cast<float>(texelAt(glm::ivec3(x, y, z))));
    render::Texture texture = render::Texture::make3D(context_->gl(), GL_R32F, dims, false);
    context_->gl()->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    context_->gl()->TextureSubImage3D(texture.id(), 0, 0, 0, 0, dims.x, dims.y, dims.z, GL_RED, GL_FLOAT,
                                      texels.data());
    bind(name, std::move(texture));
  }
  // A ray's surroundings: orthographic, along +z, one pixel a mm; world and voxels are one.
  void setPlainView(int pixels) {
    set("uRightWorld", glm::vec3(1, 0, 0));
    set("uUpWorld", glm::vec3(0, 1, 0));
    set("uForwardWorld", glm::vec3(0, 0, 1));
    set("uRightVoxel", glm::vec3(1, 0, 0));
    set("uUpVoxel", glm::vec3(0, 1, 0));
    set("uForwardVoxel", glm::vec3(0, 0, 1));
    set("uWorldFromVoxel", glm::mat3(1.0f));
    set("uVoxelFromWorld", glm::mat3(1.0f));
    set("uOrthographic", 1);
    set("uHalfExtent", 0.5f * glm::vec2(pixels, rows_));
    set("uPictureSize", glm::ivec2(pixels, rows_));
    set("uOutward", -1.0f);
  }

  // Draws `pixels` side by side; each output by its location.
  std::vector<ShaderRow> outputs(int pixels) {
    const render::GlPtr& gl = context_->gl();
    images_.clear();
    std::vector<const render::Texture*> targets;
    for (int i = 0; i <= kResult; ++i)
      images_.push_back(render::Texture::make2D(gl, GL_RGBA32F, {pixels, rows_}));
    for (const render::Texture& image : images_) targets.push_back(&image);
    const render::Framebuffer framebuffer(gl, targets);
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    gl->Viewport(0, 0, pixels, rows_);
    gl->UseProgram(program_.id());
    gl->BindVertexArray(array_.id());
    gl->DrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<ShaderRow> rows;
    for (const render::Texture& image : images_) {
      const std::vector<float> values = image.readFloats(4, {{0, rows_ / 2}, {pixels, 1}});
      ShaderRow& row = rows.emplace_back();
      for (std::size_t i = 0; i < values.size(); i += 4)
        row.emplace_back(values[i], values[i + 1], values[i + 2], values[i + 3]);
    }
    return rows;
  }
  ShaderRow results(int pixels) { return outputs(pixels)[kResult]; }
  glm::vec4 result() { return results(1)[0]; }

 private:
  static constexpr int kResult = 7;  // the last location that every driver has

  void bind(const std::string& name, render::Texture texture) {
    auto unit =
        std::find_if(textures_.begin(), textures_.end(), [&](const auto& one) { return one.first == name; });
    if (unit == textures_.end()) unit = textures_.emplace(unit, name, render::Texture());
    unit->second = std::move(texture);
    program_.setTexture(name.c_str(), static_cast<int>(unit - textures_.begin()), unit->second);
  }

  int rows_ = 1;
  render::VertexArray array_;
  render::Program program_;
  std::vector<std::pair<std::string, render::Texture>> textures_;  // by unit
  std::vector<render::Texture> images_;
};

}  // namespace isolux::test
