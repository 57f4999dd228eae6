// A scene as a line for a shell: what draws the same picture without the window.
#pragma once

#include <string>

#include <glm/vec2.hpp>
#include <nlohmann/json_fwd.hpp>

#include "scene/scene.h"
#include "scene/settings/host_settings.h"

namespace isolux::app {

// As it is typed: in single quotes unless it is plain. Any text without a zero byte.
std::string shellWord(const std::string& text);

// "PATH=VALUE" as --set reads it back to the same bits.
std::string assignmentText(const std::string& path, const nlohmann::json& value);

// `isolux render PATH --set ... --size WxH --out FILE`: every setting that is not at its default, and of the
// machine what computes pictures. `out`: the name of the picture, ending in .png or .exr. The volume's path
// is made absolute.
std::string renderCommand(const scene::Scene& scene, const scene::HostSettings& host, glm::ivec2 size,
                          const std::string& out);

}  // namespace isolux::app
