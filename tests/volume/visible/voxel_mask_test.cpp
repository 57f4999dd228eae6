#include "volume/visible/voxel_mask.h"

#include <gtest/gtest.h>

namespace isolux {
namespace {

using volume::VoxelMask;

TEST(VoxelMask, HidesStretchesOfRowsAndNothingElse) {
  for (const auto& [begin, end] :
       {std::pair{0, 0}, {0, 1}, {5, 64}, {63, 65}, {0, 64}, {10, 150}, {128, 150}}) {
    VoxelMask hidden({150, 3, 2});
    hidden.hide(begin, end, 1, 1);
    for (int z = 0; z < 2; ++z)
      for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 150; ++x)
          ASSERT_EQ(hidden.at({x, y, z}), y == 1 && z == 1 && x >= begin && x < end)
              << begin << ' ' << end << ' ' << x;
    EXPECT_EQ(hidden.any(), end > begin);
  }
}

TEST(VoxelMask, KeysAreOfWhatIsHidden) {
  VoxelMask a({70, 2, 2}), b({70, 2, 2});
  EXPECT_EQ(a.key(), 0u);
  a.hide(3, 69, 1, 0);
  b.hide(3, 20, 1, 0);
  EXPECT_NE(a.key(), b.key());
  b.hide(20, 69, 1, 0);
  EXPECT_EQ(a.key(), b.key());
}

}  // namespace
}  // namespace isolux
