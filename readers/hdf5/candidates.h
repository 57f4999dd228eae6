// The datasets of an HDF5 file that may be volumes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <hdf5.h>

#include "volume/bricks/chunks/chunk_format.h"

namespace isolux::readers {

struct Candidate {
  std::string path;  // "/group/name"
  std::vector<std::uint64_t> dims;
  volume::FileNumber number;
  double voxels = 0.0;
};

// Datasets of numbers with two axes or more of more than one entry, the largest first; pictures behind
// volumes. At least one, at most 1000. Throws base::Error{input}; `name` of the file.
std::vector<Candidate> candidatesOf(hid_t file, const std::string& name);

// The one called `wanted`, or else the first. Throws base::Error{input} naming what there is.
const Candidate& chosenOf(const std::vector<Candidate>& candidates, const std::string& wanted,
                          const std::string& file);

// "/a<TAB>/a, 10 x 20 x 30 uint16".
std::string describe(const Candidate& candidate);

}  // namespace isolux::readers
