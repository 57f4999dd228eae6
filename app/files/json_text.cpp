#include "app/files/json_text.h"

#include <nlohmann/json.hpp>

namespace isolux::app {

std::string jsonText(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

void addContext(nlohmann::ordered_json& json, const render::ContextDescription& context) {
  json["context"] = context.kind;
  json["gl"] = {{"vendor", context.vendor},
                {"renderer", context.renderer},
                {"version", context.version},
                {"glsl", context.glsl},
                {"software", context.software}};
}

}  // namespace isolux::app
