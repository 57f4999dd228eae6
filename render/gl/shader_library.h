// The GLSL sources, embedded at build from resources/shaders, with #include "file" resolved.
#pragma once

#include <string>
#include <string_view>

namespace isolux::render {

struct EmbeddedShader {
  const char* name;  // file name, "hit.frag.glsl"
  const char* text;
};
extern const EmbeddedShader embeddedShaders[];
extern const int embeddedShaderCount;

// The file's text after #version 450 core and `defines` ("#define X 1\n..."), includes expanded once each,
// with #line marks. Throws std::logic_error for a name that is not embedded.
std::string shaderSource(std::string_view name, std::string_view defines = "");
// The same of a text that is not embedded, but may include what is: to run parts of shaders by themselves.
std::string shaderSourceOf(std::string_view text, std::string_view defines = "");

}  // namespace isolux::render
