// Parses "a.b=VALUE" as on the command line: numbers, "x,y,z", words; VALUE may be "auto" where allowed.
#pragma once

#include <string_view>

#include "scene/settings/setting.h"

namespace isolux::scene {

std::string_view pathOf(std::string_view assignment);  // without surrounding blanks
// Returns the value that the text means for this setting. Text that cannot be parsed stays text, which
// Setting::set rejects with the reason. Throws base::Error of kind usage if '=' is missing.
nlohmann::json valueOf(const SettingInfo& target, std::string_view assignment);
// Convert a list of positions to and from the form "x,y,z; x,y,z", "" for none; text that is not such a list
// stays text.
std::string textOfPositions(const nlohmann::json& positions);
nlohmann::json positionsOf(std::string_view text);
// As above for planes, "px,py,pz nx,ny,nz; ...".
std::string textOfPlanes(const nlohmann::json& planes);
nlohmann::json planesOf(std::string_view text);

}  // namespace isolux::scene
