// Parts of one bake (BakedPart), each a file, into the file that the bake made at once would have written.
#pragma once

#include <filesystem>
#include <span>

#include "base/progress.h"

namespace isolux::gi {

// `files` in any order; all parts of one bake, each finished and there once. The result has the bytes of a
// file that writeBakeFile() would write of all texels. Memory: about 2 MiB a file.
//
// Errors: base::Error{input} naming the file that is no part, of another volume, light or lattice, there
// twice, not finished, of other arithmetic (unless `mixArithmetic`), or damaged; and naming `out` with the
// numbers of the parts that are missing. {interrupted}. `out` is whole or as it was before.
void mergeBakeFiles(std::span<const std::filesystem::path> files, const std::filesystem::path& out,
                    bool mixArithmetic, base::Progress& progress);

}  // namespace isolux::gi
