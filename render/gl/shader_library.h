// Provides the GLSL sources, embedded at build time from resources/shaders, with #include "file" resolved.
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

// Returns the file's text after #version 450 core and `defines` ("#define X 1\n..."), includes expanded once
// each, with #line directives. Throws std::logic_error if the name is not embedded.
std::string shaderSource(std::string_view name, std::string_view defines = "");
// As shaderSource(), for a text that is not embedded but may include embedded files: to run parts of shaders
// on their own.
std::string shaderSourceOf(std::string_view text, std::string_view defines = "");

}  // namespace isolux::render
