// Where tests find the shared data folder: $ISOLUX_DATA, else ../shared/data beside the source tree.
#pragma once

#include <filesystem>

#include <gtest/gtest.h>

namespace isolux::test {

// Empty when the folder is not there.
std::filesystem::path dataFolder();

// A fresh, empty folder of the running test, removed when the process ends.
std::filesystem::path temporaryFolder();

}  // namespace isolux::test

// At the start of a test that reads shared data: skips and says so where there is none.
#define ISOLUX_NEEDS_DATA()               \
  if (isolux::test::dataFolder().empty()) \
  GTEST_SKIP() << "no test data: set ISOLUX_DATA to the shared data folder"
