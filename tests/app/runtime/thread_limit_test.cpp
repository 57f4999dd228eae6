#include "app/runtime/thread_limit.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/app/commands/run_isolux.h"
#include "tests/support/test_data.h"

namespace isolux::test {
namespace {

using testing::HasSubstr;
using Words = std::vector<std::string>;

// A copy that any user may run: the folder of the build may be closed to others.
std::filesystem::path programForEverybody() {
  namespace fs = std::filesystem;
  const fs::path built = ISOLUX_BINARY, folder = temporaryFolder();
  for (const char* name : {"isolux", "isolux-program"})
    fs::copy_file(built.parent_path() / name, folder / name);
  fs::permissions(folder, fs::perms::others_read | fs::perms::others_exec, fs::perm_options::add);
  return folder / built.filename();
}

TEST(ThreadLimit, WithoutALimitAllAreGivenAndNothingChanges) {
  EXPECT_EQ(app::threadsAvailable(7), 7);
  EXPECT_EQ(app::shareThreads().note, "");
}

TEST(ThreadLimit, WhereTheSystemRefusesThreadsFewerDoTheWork) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can run the program as a user of its own";
  const std::filesystem::path program = programForEverybody();
  for (const std::size_t limit : {3u, 5u, 8u, 12u})
    for (const Words& command :
         {Words{"info", "phantom:ball:32"}, Words{"phantom", "ball", "--size", "32", "--out", "b.vti"},
          Words{"render", "phantom:ball:32", "--size", "64x64", "--out", "r.png"},
          Words{"bake", "phantom:ball:16", "--out", "l.vti", "--set", "gi.samples=4", "--set",
                "gi.threads=1024"},
          Words{"reference", "phantom:ball:16", "--size", "16x16", "--spp", "4", "--set", "gi.threads=64",
                "--out", "f.exr"}}) {
      const RunResult result =
          runIsolux(command, {.program = program, .folder = temporaryFolder(), .threads = limit});
      ASSERT_TRUE(result.exitCode != 97 && result.exitCode != 98) << "another user cannot run the program";
      const std::string what = command.front() + " with " + std::to_string(limit) + " threads: " + result.err;
      // Light needs one thread beside the command's own.
      EXPECT_TRUE(result.exitCode == 0 || (limit <= 5 && result.exitCode == 5)) << what;
      EXPECT_THAT(result.err,
                  testing::AnyOf(HasSubstr("cannot create a thread"), HasSubstr("the system provides")))
          << what;
    }
}

}  // namespace
}  // namespace isolux::test
