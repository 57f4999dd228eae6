#include "app/files/file_names.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "tests/support/test_data.h"

namespace isolux::app {
namespace {

TEST(PlainName, IsWithoutFolderAndFormat) {
  EXPECT_EQ(plainName("/scans/ct_head_skin_bone.nii.gz"), "ct_head_skin_bone");
  EXPECT_EQ(plainName("/scans/CT.NII.GZ"), "CT");
  EXPECT_EQ(plainName("ct_head.isolux"), "ct_head");
  EXPECT_EQ(plainName("scan.v2.mhd"), "scan.v2");
  EXPECT_EQ(plainName("noformat"), "noformat");
  EXPECT_EQ(plainName(".hidden"), ".hidden");
  EXPECT_EQ(plainName("phantom:head:64"), "head");
  EXPECT_EQ(plainName("phantom:torus"), "torus");
  EXPECT_EQ(plainName(""), "");
}

TEST(PlainName, OfAFolderIsItsWholeName) {
  const auto folder = test::temporaryFolder() / "1.2.840.113";
  std::filesystem::create_directories(folder);
  EXPECT_EQ(plainName(folder.string()), "1.2.840.113");
  EXPECT_EQ(plainName(folder.string() + "/"), "1.2.840.113");
}

}  // namespace
}  // namespace isolux::app
