// What is written is whole or not there, and a write that fails at the last byte is an error. A limit of the
// size of files stands for a full disk: the same calls fail at the same places.
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "tests/app/commands/run_isolux.h"
#include "tests/support/test_data.h"

namespace isolux::app {
namespace {

namespace fs = std::filesystem;
using test::callIsolux;
using testing::HasSubstr;
using testing::IsEmpty;

// Soft, so that it can be taken back.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(std::size_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &before_); }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
};

// Writes once without a limit, then with limits below the size of the file.
void expectWholeOrNothing(const std::string& file, const std::vector<std::string>& arguments) {
  const fs::path free = test::temporaryFolder();
  const test::RunResult whole = callIsolux(arguments, free);
  ASSERT_EQ(whole.exitCode, 0) << whole.err;
  const std::size_t bytes = fs::file_size(free / file);
  ASSERT_GT(bytes, 600u) << "what is said on stderr goes to a file here, and must fit";
  for (const std::size_t limit : {bytes - 1, bytes / 2}) {
    const fs::path folder = test::temporaryFolder();
    const test::RunResult result = [&] {
      const FileSizeLimit limited(limit);
      return callIsolux(arguments, folder);
    }();
    EXPECT_EQ(result.exitCode, 3) << file << " at " << limit << " of " << bytes << '\n' << result.err;
    EXPECT_TRUE(result.isOneErrorLine()) << result.err;
    EXPECT_THAT(result.err, HasSubstr("File too large")) << file;
    EXPECT_THAT(test::filesIn(folder), IsEmpty()) << file << " at " << limit;
  }
}

TEST(FullDisk, VolumesAreWholeOrNotThere) {
  for (const char* name : {"a.mha", "a.nrrd", "a.vti"})
    expectWholeOrNothing(name, {"phantom", "ball", "--size", "12", "--out", name});
  expectWholeOrNothing("a.raw", {"phantom", "ball", "--size", "12", "--out", "a.mhd"});
}

TEST(FullDisk, StoredLightIsWholeOrNotThere) {
  expectWholeOrNothing("a.vti", {"bake", "phantom:ball:10", "--out", "a.vti", "--set", "gi.samples=1",
                                 "--set", "gi.lattice_scale=0.5"});
}

TEST(FullDisk, ReferencePicturesAreWholeOrNotThere) {
  for (const char* name : {"a.png", "a.exr"})
    expectWholeOrNothing(name,
                         {"reference", "phantom:ball:10", "--out", name, "--spp", "1", "--size", "24x18"});
}

TEST(FullDiskGl, PicturesAreWholeOrNotThere) {
  for (const char* name : {"a.png", "a.exr"})
    expectWholeOrNothing(name, {"render", "phantom:ball:10", "--out", name, "--size", "48x36"});
}

// The program itself, which the system would end by a signal if it did not say otherwise.
TEST(FullDisk, ALimitOfFileSizesEndsWithALine) {
  const fs::path folder = test::temporaryFolder();
  const test::RunResult result = test::runIsolux({"phantom", "ball", "--size", "16", "--out", "a.mha"},
                                                 {.folder = folder, .fileSize = 5000});
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_TRUE(result.isOneErrorLine()) << result.err;
  EXPECT_THAT(test::filesIn(folder), IsEmpty());
}

}  // namespace
}  // namespace isolux::app
