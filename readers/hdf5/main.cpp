// isolux-reader-hdf5: what the HDF5 library parses.
#include <hdf5.h>

#include "readers/hdf5/dataset.h"
#include "readers/serve.h"

namespace {

std::string versions() {
  unsigned major = 0, minor = 0, release = 0;
  ::H5get_libversion(&major, &minor, &release);
  return "HDF5 " + std::to_string(major) + '.' + std::to_string(minor) + '.' + std::to_string(release);
}

}  // namespace

int main() {
  using namespace isolux;
  return readers::serve({.chunks = readers::describeDataset, .versions = versions});
}
