// Whether a bake may go on from a file of its light.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "gi/file/bake_file.h"

namespace isolux::app {

// `wanted`: the part that is baked. Throws base::Error{input} naming the file where it is of another part,
// or, unless `mixArithmetic`, was computed by other arithmetic than `arithmetic`.
void checkMayGoOn(const std::filesystem::path& file, const gi::BakeFacts& facts,
                  const std::optional<gi::LatticePart>& wanted, const std::string& arithmetic,
                  bool mixArithmetic);

}  // namespace isolux::app
