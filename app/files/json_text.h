// What commands write as JSON.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "render/gl/gl_context.h"

namespace isolux::app {

std::string jsonText(const nlohmann::ordered_json& json);  // indented, ends in a newline
// The keys "context" and "gl": what drew a picture.
void addContext(nlohmann::ordered_json& json, const render::ContextDescription& context);

}  // namespace isolux::app
