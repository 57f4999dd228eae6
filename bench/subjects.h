// The volumes and isovalues that the sections about pictures compare on.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "volume/prepared/prepared_volume.h"

namespace isolux::bench {

using VolumePointer = std::shared_ptr<const volume::PreparedVolume>;

struct Subject {
  std::string name;
  VolumePointer volume;
  double isovalue;  // data units
};

// "phantom:NAME[:SIZE]" or a file.
VolumePointer load(const std::string& path);

// A dense synthetic surface, a smooth head, and a real scan; the last only where the data folder is (else a
// line says so).
std::vector<Subject> subjects();

}  // namespace isolux::bench
