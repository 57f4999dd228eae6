// Files that appear whole or not at all.
#include "base/pending_file.h"

#include <algorithm>
#include <csignal>
#include <fstream>
#include <sstream>
#include <vector>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.h"

namespace isolux::base {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class PendingFileTest : public testing::Test {
 protected:
  PendingFileTest() {
    static int count = 0;
    folder_ = fs::temp_directory_path() /
              ("isolux-pending-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
    fs::create_directories(folder_);
  }
  ~PendingFileTest() override { fs::remove_all(folder_); }

  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_))
      names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }
  static std::string contentOf(const fs::path& file) {
    std::stringstream content;
    content << std::ifstream(file, std::ios::binary).rdbuf();
    return content.str();
  }
  static void write(const fs::path& file, const std::string& text) {
    OutputFile output(file);
    output.write(text);
    output.commit();
  }
  // The reason for which it fails.
  static std::string failure(const fs::path& file, std::size_t bytes) {
    try {
      OutputFile output(file);
      output.write(std::string(bytes, 'x'));
      output.commit();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
      return error.what();
    }
    ADD_FAILURE() << "no error";
    return {};
  }

  fs::path folder_;
};

TEST_F(PendingFileTest, ALinkStaysALinkAndItsTargetIsReplaced) {
  fs::create_directory(folder_ / "far");
  write(folder_ / "far" / "real.txt", "old");
  fs::create_symlink("far/real.txt", folder_ / "second");
  fs::create_symlink("second", folder_ / "first");
  write(folder_ / "first", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "first"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "second"));
  EXPECT_EQ(contentOf(folder_ / "far" / "real.txt"), "new");
  fs::create_symlink("far/not_yet.txt", folder_ / "third");
  write(folder_ / "third", "made");
  EXPECT_TRUE(fs::is_symlink(folder_ / "third"));
  EXPECT_EQ(contentOf(folder_ / "far" / "not_yet.txt"), "made");
  fs::create_symlink("circle", folder_ / "circle");
  EXPECT_THROW(PendingFile(folder_ / "circle"), Error);
}

TEST_F(PendingFileTest, TheAccessRightsOfAReplacedFileAreKept) {
  const fs::path file = folder_ / "a.txt";
  for (const mode_t mode : {0600, 0664, 0755}) {
    write(file, "old");
    ASSERT_EQ(::chmod(file.c_str(), mode), 0);
    write(file, "new");
    struct stat status {};
    ASSERT_EQ(::stat(file.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777u, mode);
  }
}

TEST_F(PendingFileTest, AReadOnlyFileIsRefusedAndStays) {
  const fs::path file = folder_ / "a.txt";
  write(file, "old");
  ASSERT_EQ(::chmod(file.c_str(), 0444), 0);
  EXPECT_THAT(failure(file, 3), HasSubstr("read-only"));
  EXPECT_EQ(contentOf(file), "old");
  EXPECT_THAT(files(), ElementsAre("a.txt"));
}

TEST_F(PendingFileTest, WhatAKilledProcessLeftIsRemovedByTheNextWrite) {
  const pid_t child = ::fork();
  if (child == 0) {
    new OutputFile(folder_ / "a.txt");
    ::_exit(::kill(::getpid(), SIGKILL));
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_EQ(files().size(), 1u);
  const PendingFile living(folder_ / "b.txt");
  EXPECT_THAT(files(), ElementsAre(living.path().filename().string())) << "its own stays";
}

TEST_F(PendingFileTest, WhatALivingProcessWritesIsLeftAlone) {
  const PendingFile living(folder_ / "a.txt");
  std::ofstream(folder_ / ".notes.part") << "not ours";
  std::ofstream(folder_ / ".a.b-1.part") << "not ours";
  const pid_t child = ::fork();
  if (child == 0) {
    { const PendingFile other(folder_ / "b.txt"); }
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(files().size(), 3u);
  EXPECT_TRUE(fs::exists(living.path()));
}

TEST_F(PendingFileTest, ALockKeepsOthersFromTheSameFileOnly) {
  const fs::path file = folder_ / "a.txt";
  const auto refused = [](const fs::path& target) {
    try {
      const OutputLock lock(target);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
      EXPECT_THAT(error.what(), HasSubstr("another isolux is at work on this file"));
      return true;
    }
    return false;
  };
  fs::create_symlink("a.txt", folder_ / "link");
  {
    OutputLock lock(file);
    EXPECT_TRUE(refused(file));
    EXPECT_TRUE(refused(folder_ / "link"));
    EXPECT_FALSE(refused(folder_ / "b.txt"));
    write(file, "written meanwhile");
    EXPECT_TRUE(refused(file)) << "of the name, not of the file that it had";
    const OutputLock moved(std::move(lock));
    EXPECT_TRUE(refused(file));
  }
  EXPECT_FALSE(refused(file));
  EXPECT_FALSE(refused("/dev/null"));
  EXPECT_THAT(files(), ElementsAre("a.txt", "link"));
}

TEST_F(PendingFileTest, TheLockOfAKilledProcessHoldsNobody) {
  const auto leave = [&] {
    const pid_t child = ::fork();
    if (child == 0) {
      new OutputLock(folder_ / "a.txt");
      ::_exit(::kill(::getpid(), SIGKILL));
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_EQ(files().size(), 1u);
  };
  leave();
  { const OutputLock again(folder_ / "a.txt"); }
  EXPECT_THAT(files(), IsEmpty());
  leave();
  write(folder_ / "b.txt", "the next write removes it");
  EXPECT_THAT(files(), ElementsAre("b.txt"));
}

TEST_F(PendingFileTest, AFileThatDoesNotFitIsAnErrorAtAnyByte) {
  const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit limited{100000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limited), 0);
  for (const std::size_t bytes : {100001u, 103000u, 1000000u})  // in the stream's last buffer, and before
    EXPECT_THAT(failure(folder_ / "a.txt", bytes), HasSubstr("cannot be written: File too large"));
  EXPECT_THAT(files(), IsEmpty());
  write(folder_ / "a.txt", std::string(100000, 'x'));
  EXPECT_THAT(failure(folder_ / "a.txt", 100001), HasSubstr("File too large"));
  EXPECT_EQ(contentOf(folder_ / "a.txt").size(), 100000u) << "the old one stays";
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, ignored);
}

TEST_F(PendingFileTest, AnyNameThatTheFileSystemTakesCanBeWritten) {
  const std::string longName(250, 'n');
  write(folder_ / longName, "x");
  write(folder_ / "caf\xe9 \n.txt", "x");
  EXPECT_EQ(files().size(), 2u);
}

// A job's log: what was written before stays, and what comes after stands behind.
TEST_F(PendingFileTest, AStreamIsWrittenIntoWhereItStands) {
  const fs::path log = folder_ / "job.log";
  const int file = ::open(log.c_str(), O_RDWR | O_CREAT, 0600);
  ASSERT_EQ(::write(file, "before\n", 7), 7);
  for (const std::string folder : {"/proc/self/fd/", "/dev/fd/"})
    write(folder + std::to_string(file), "through " + folder + "\n");
  fs::create_symlink("/dev/fd/" + std::to_string(file), folder_ / "link");
  write(folder_ / "link", "through a link\n");
  ASSERT_EQ(::write(file, "after\n", 6), 6);
  ::close(file);
  EXPECT_EQ(contentOf(log), "before\nthrough /proc/self/fd/\nthrough /dev/fd/\nthrough a link\nafter\n");
  EXPECT_THAT(files(), ElementsAre("job.log", "link"));
}

TEST_F(PendingFileTest, PipesAndDevicesAreStreamsToo) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  write("/dev/fd/" + std::to_string(ends[1]), "text");
  ::close(ends[1]);
  std::string read(10, ' ');
  read.resize(static_cast<std::size_t>(::read(ends[0], read.data(), read.size())));
  EXPECT_EQ(read, "text");
  EXPECT_THAT(failure("/dev/fd/" + std::to_string(ends[0]), 1),
              HasSubstr("cannot be written: Bad file descriptor"))
      << "the end that is read";
  ::close(ends[0]);
  EXPECT_THAT(failure("/dev/fd/" + std::to_string(ends[0]), 1),
              HasSubstr("cannot be written: Bad file descriptor"))
      << "closed";
  write("/dev/null", "text");
  EXPECT_THAT(failure("/dev/full", 1), HasSubstr("No space left on device"));
}

TEST_F(PendingFileTest, AWriterMayGoBackInItsFile) {
  OutputFile output(folder_ / "a.txt");
  output.write("0000 rest");
  output.go(2);
  EXPECT_EQ(output.at(), 2u);
  output.write("11");
  output.commit();
  EXPECT_EQ(contentOf(folder_ / "a.txt"), "0011 rest");
}

}  // namespace
}  // namespace isolux::base
