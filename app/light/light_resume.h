// Bakes into a file, and goes on with what the file holds of the same light.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/light/light_controller.h"
#include "gi/file/bake_file.h"

namespace isolux::app {

// `wanted`: the part that is baked. Throws base::Error{input} naming the file where it is of another part,
// or, unless `mixArithmetic`, was computed by other arithmetic than `arithmetic`.
void checkMayGoOn(const std::filesystem::path& file, const gi::BakeFacts& facts,
                  const std::optional<gi::LatticePart>& wanted, const std::string& arithmetic,
                  bool mixArithmetic);

// "FILE held other light and was replaced: WHY"
std::string replacedNote(const std::filesystem::path& file, const std::string& why);
// Loads the light of `file`, if there is one. Returns a note where it is other light, which is replaced; else
// "". Throws as checkMayGoOn().
std::string resumeBake(LightController& controller, const std::filesystem::path& file,
                       const std::optional<gi::LatticePart>& wanted, bool mixArithmetic,
                       base::Progress& progress);
// Finishes the bake and writes it, and meanwhile every `checkpointSeconds` and before a stop what there is of
// it. `part`: of a bake, which the file names.
void bakeToFile(LightController& controller, const std::filesystem::path& file,
                std::optional<gi::BakedPart> part, double checkpointSeconds, base::Progress& progress);

}  // namespace isolux::app
