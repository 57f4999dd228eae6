// Loads of every kind of file that are stopped at any moment leave the rest undone. How soon that is by the
// clock is printed.
#include <gtest/gtest.h>

#include "tests/support/stop_latency.h"
#include "tests/support/test_data.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::volume {
namespace {

TEST(StoppedLoad, LeavesMostOfTheRestUndone) {
  ISOLUX_NEEDS_DATA();
  for (const char* name :
       {"volumes/heptane.nii.gz", "volumes/ct_cranium.mhd", "volumes/viscous_fingers_060.vti",
        "dicom/ct_head_64", "mesh/stanford-bunny.obj"}) {
    SCOPED_TRACE(name);
    scene::Source source;
    source.path = (test::dataFolder() / name).string();
    source.meshVoxels = 48;
    test::expectStopsSoon([&](base::Progress& progress) { loadVolume(source, progress); }, 5);
  }
}

}  // namespace
}  // namespace isolux::volume
