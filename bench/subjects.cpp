#include "bench/subjects.h"

#include <cstdio>

#include "tests/support/test_data.h"

namespace isolux::bench {

VolumePointer load(const std::string& path) {
  base::Progress progress;
  scene::Source source;
  source.path = path;
  return volume::loadVolume(source, progress);
}

std::vector<Subject> subjects() {
  std::vector<Subject> list;
  list.push_back({"gyroid 256", load("phantom:gyroid:256"), 0.0});
  list.push_back({"head phantom, bone", load("phantom:head"), 300.0});
  if (const auto data = test::dataFolder(); data.empty())
    std::printf(" ct_head_skin_bone is left out: no test data (ISOLUX_DATA)\n");
  else
    list.push_back({"ct_head_skin_bone, bone", load(data / "volumes/ct_head_skin_bone.nii.gz"), 0.51});
  return list;
}

}  // namespace isolux::bench
