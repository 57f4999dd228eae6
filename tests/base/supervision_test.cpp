// What a command writes on its supervisor's board. All of this program's tests run supervised: the board is
// made before main().
#include "base/supervision.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include "base/pending_file.h"
#include "base/supervision_board.h"

namespace isolux::base {
namespace {

namespace fs = std::filesystem;
using Slot = SupervisionBoard::Slot;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

SupervisionBoard* makeBoard() {
  const int file = ::memfd_create("board", 0);
  if (file < 0 || ::ftruncate(file, sizeof(SupervisionBoard)) != 0) return nullptr;
  void* const memory = ::mmap(nullptr, sizeof(SupervisionBoard), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  ::setenv(kBoardVariable, std::to_string(file).c_str(), 1);
  return memory == MAP_FAILED ? nullptr : static_cast<SupervisionBoard*>(memory);
}

SupervisionBoard* const board = makeBoard();

std::vector<std::string> announced() {
  std::vector<std::string> paths;
  for (const Slot& slot : board->slots)
    if (slot.state == Slot::announced) paths.emplace_back(slot.path);
  return paths;
}

// Other tests leave what killed processes of theirs announced.
class Supervision : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_NE(board, nullptr);
    for (Slot& slot : board->slots) slot.state = Slot::free;
  }
};

TEST_F(Supervision, FilesUnderConstructionStandOnTheBoard) {
  announcePending("one.part");
  announcePending("/elsewhere/two.part");
  EXPECT_THAT(announced(),
              UnorderedElementsAre((fs::current_path() / "one.part").string(), "/elsewhere/two.part"));
  withdrawPending("one.part");
  withdrawPending("never announced");
  EXPECT_THAT(announced(), ElementsAre("/elsewhere/two.part"));
  withdrawPending("/elsewhere/two.part");
  EXPECT_THAT(announced(), IsEmpty());
}

TEST_F(Supervision, WhatTheBoardHasNoRoomForIsLeftOut) {
  const std::string longest(sizeof(Slot::path) - 2, 'x');
  announcePending("/" + longest + "x");
  EXPECT_THAT(announced(), IsEmpty());
  announcePending("/" + longest);  // and its 0
  EXPECT_TRUE(announced() == std::vector<std::string>{"/" + longest});
  withdrawPending("/" + longest);
  const std::size_t slots = std::size(board->slots);
  for (std::size_t i = 0; i < slots + 3; ++i) announcePending("/" + std::to_string(i));
  EXPECT_EQ(announced().size(), slots);
  for (std::size_t i = 0; i < slots + 3; ++i) withdrawPending("/" + std::to_string(i));
  EXPECT_THAT(announced(), IsEmpty());
}

TEST_F(Supervision, AFileIsOnTheBoardUntilItHasItsName) {
  const fs::path file = fs::temp_directory_path() / ("isolux-supervised-" + std::to_string(::getpid()));
  {
    OutputFile output(file);
    output.write("text");
    ASSERT_EQ(announced().size(), 1u);
    EXPECT_EQ(fs::path(announced()[0]).parent_path(), file.parent_path());
    EXPECT_TRUE(fs::exists(announced()[0]));
    output.commit();
    EXPECT_THAT(announced(), IsEmpty());
  }
  fs::remove(file);
}

TEST_F(Supervision, TheFirstToClaimPrintsTheReport) {
  EXPECT_TRUE(claimReport());
  EXPECT_FALSE(claimReport());
  board->reported = 0;
  EXPECT_TRUE(claimReport());
  board->reported = 0;
  EXPECT_FALSE(claimInterruptReport());  // the supervisor's
}

}  // namespace
}  // namespace isolux::base
