// isolux bake --part I/N: which part, its file, and which texels of the whole bake it is a part of.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "gi/lattice/lattice_part.h"
#include "scene/scene.h"

namespace isolux::app {

// "2/5"; empty: none. Throws Error{usage}.
std::optional<gi::LatticePart> partOf(const std::string& text);
// L.vti, or of a part L.part-2-of-5.vti.
std::filesystem::path fileOf(const std::filesystem::path& out, const std::optional<gi::LatticePart>& part);
// Which texels, in words that are the same for every part of a bake. `size`: of the view, "WxH"; `scene` is
// resolved.
std::string texelsText(const std::string& size, const scene::Scene& scene);

}  // namespace isolux::app
