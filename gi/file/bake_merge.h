// Merges the files of all parts of one bake (BakedPart) into the file that a single bake would have written.
#pragma once

#include <filesystem>
#include <span>

#include "base/progress.h"

namespace isolux::gi {

// Merges `files`, in any order. Requires all parts of one bake, each finished and present once. The result is
// byte-identical to a file that writeBakeFile() writes of all texels. Memory: about 2 MiB per file.
//
// Throws base::Error{input} naming a file that is not a part, is a duplicate, is unfinished or is damaged.
// Also for a file of another volume, light or lattice, or of other arithmetic (unless `mixArithmetic`).
// Throws it naming `out`, with the numbers of the parts, if parts are missing. Throws Error{interrupted}.
// `out` is complete or as before.
void mergeBakeFiles(std::span<const std::filesystem::path> files, const std::filesystem::path& out,
                    bool mixArithmetic, base::Progress& progress);

}  // namespace isolux::gi
