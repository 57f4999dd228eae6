// The datasets of an HDF5 file that may be volumes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <hdf5.h>

#include "volume/read/chunks/chunk_format.h"

namespace isolux::readers {

struct Candidate {
  std::string path;  // "/group/name"
  std::vector<std::uint64_t> dims;
  volume::FileNumber number;
  double voxels = 0.0;
};

// Nothing where the dataset at `path` is no volume and no picture.
std::optional<Candidate> candidateOf(hid_t dataset, const std::string& path);

// Datasets of numbers with two axes or more of more than one entry, the largest first; pictures behind
// volumes. At most 1000. Throws base::Error{input} where there are none but links to other files; `name` of
// the file.
std::vector<Candidate> candidatesOf(hid_t file, const std::string& name);

// The one at the path `wanted`, also through soft links; the first where that is empty. Throws
// base::Error{input} naming what there is, or the file that an external link leads to.
Candidate chosenOf(hid_t file, const std::vector<Candidate>& candidates, const std::string& wanted,
                   const std::string& name);

// "/a<TAB>/a, 10 x 20 x 30 uint16".
std::string describe(const Candidate& candidate);

}  // namespace isolux::readers
