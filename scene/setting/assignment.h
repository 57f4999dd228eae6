// "a.b=VALUE" as on the command line: numbers, "x,y,z", words; VALUE may be "auto" where allowed.
#pragma once

#include <string_view>

#include "scene/setting/setting.h"

namespace isolux::scene {

std::string_view pathOf(std::string_view assignment);  // without the blanks around it
// What the words mean for this setting; a word that makes no sense stays a word, which Setting::set refuses
// with the reason. Throws base::Error of kind usage where there is no '='.
nlohmann::json valueOf(const SettingInfo& target, std::string_view assignment);
// A list of positions as it is typed and read, "x,y,z; x,y,z", "" for none; a text that is no such list stays
// one.
std::string textOfPositions(const nlohmann::json& positions);
nlohmann::json positionsOf(std::string_view text);
// The same of planes, "px,py,pz nx,ny,nz; ...".
std::string textOfPlanes(const nlohmann::json& planes);
nlohmann::json planesOf(std::string_view text);

}  // namespace isolux::scene
