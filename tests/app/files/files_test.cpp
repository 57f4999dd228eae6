#include "app/files/files.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/runtime/progress_bar.h"
#include "base/error.h"
#include "tests/app/commands/run_isolux.h"
#include "tests/support/test_data.h"

namespace isolux::app {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(PendingFile, AppearsOnlyWhenCommitted) {
  const fs::path folder = test::temporaryFolder();
  {
    PendingFile pending(folder / "a.txt");
    EXPECT_EQ(pending.path().parent_path(), folder) << "a rename must not cross file systems";
    std::ofstream(pending.path()) << "new";
    EXPECT_FALSE(fs::exists(folder / "a.txt"));
    pending.commit();
  }
  EXPECT_THAT(test::filesIn(folder), ElementsAre("a.txt"));
  EXPECT_EQ(test::contentOf(folder / "a.txt"), "new");
}

TEST(PendingFile, KeepsTheOldFileOnFailure) {
  const fs::path folder = test::temporaryFolder();
  writeTextFile(folder / "a.txt", "old");
  {
    PendingFile pending(folder / "a.txt");
    std::ofstream(pending.path()) << "half";
  }
  EXPECT_THAT(test::filesIn(folder), ElementsAre("a.txt"));
  EXPECT_EQ(test::contentOf(folder / "a.txt"), "old");
}

TEST(PendingFile, IsRemovedOnTheWayOut) {
  const fs::path folder = test::temporaryFolder();
  PendingFile first(folder / "a.txt"), second(folder / "b.txt");
  std::ofstream(first.path()) << "half";
  removePendingFiles();
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST(PendingFile, RefusesWhatCannotBeReplaced) {
  const fs::path folder = test::temporaryFolder();
  EXPECT_THROW(PendingFile(folder / ""), base::Error);
  EXPECT_THROW(PendingFile{folder}, base::Error);
  EXPECT_THROW(PendingFile(folder / "no" / "a"), base::Error);
  EXPECT_EQ(PendingFile("/dev/null").target(), "/dev/null") << "written into where it stands, not replaced";
}

TEST(MadeFolder, StaysOnlyWithSomethingInIt) {
  const fs::path folder = test::temporaryFolder();
  { const MadeFolder made(folder / "a" / "b"); }
  EXPECT_TRUE(fs::is_empty(folder));
  {
    const MadeFolder made(folder / "a" / "b");
    writeTextFile(made.path() / "x.txt", "x");
  }
  EXPECT_EQ(test::contentOf(folder / "a" / "b" / "x.txt"), "x");
  { const MadeFolder there(folder / "a"); }
  EXPECT_TRUE(fs::exists(folder / "a" / "b"));
  EXPECT_THROW(MadeFolder(folder / "a" / "b" / "x.txt" / "c"), base::Error);
}

TEST(TextFile, ReadsWithALimit) {
  const fs::path file = test::temporaryFolder() / "a.txt";
  writeTextFile(file, std::string("a\0b", 3));
  EXPECT_EQ(readTextFile(file, 3), std::string("a\0b", 3));
  EXPECT_THROW(readTextFile(file, 2), base::Error);
  EXPECT_EQ(readBeginning(file, 1), "a");
  EXPECT_EQ(readBeginning(file, 100).size(), 3u);
  EXPECT_EQ(readBeginning(file.parent_path(), 10), "");
  EXPECT_THROW(readTextFile("/dev/zero", 100), base::Error);
}

TEST(ProgressLine, ShowsShareStageAndTimeLeft) {
  EXPECT_EQ(progressLine(0.5, "reading", 3, 10), "[#####     ]  50 %  reading  3 s left");
  EXPECT_EQ(progressLine(0, "reading", 3, 10), "[          ]   0 %  reading");
  EXPECT_EQ(progressLine(1, "", 3, 4), "[####] 100 %");
  EXPECT_THAT(progressLine(0.25, "x", 100, 4), HasSubstr("5 min 0 s left"));
  EXPECT_THAT(progressLine(0.1, "x", 3600, 4), HasSubstr("9 h 0 min left"));
  EXPECT_EQ(progressLine(-1, nullptr, 0, 4), "[    ]   0 %");
  EXPECT_EQ(progressLine(std::nan(""), "x", 0, 4), "[    ]   0 %  x");
  EXPECT_EQ(progressLine(7, "x", 0, 4), "[####] 100 %  x");
}

}  // namespace
}  // namespace isolux::app
