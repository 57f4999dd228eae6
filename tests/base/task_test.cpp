// Work on a thread: its value, what it tells before, whatever it throws, and an end that nobody waits for.
#include "base/task.h"

#include <atomic>
#include <functional>
#include <new>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace isolux::base {
namespace {

void waitUntil(const std::function<bool()>& condition) {
  while (!condition()) std::this_thread::yield();
}

TEST(Task, KeepsItsValue) {
  const auto task = Task<int>::start({"", "count"}, [](Progress&) { return 7; });
  waitUntil([&] { return task->finished(); });
  ASSERT_FALSE(task->error());
  EXPECT_EQ(task->value(), 7);
}

TEST(Task, KeepsWhateverIsThrown) {
  struct Case {
    std::function<void()> work;
    ErrorKind kind;
    const char* line;
  };
  for (const auto& [work, kind, line] : std::vector<Case>{
           {[] { throw std::logic_error("no such case"); }, ErrorKind::input,
            "a.hdr: cannot measure: no such case"},
           {[] { throw std::bad_alloc(); }, ErrorKind::memory, "a.hdr: not enough memory to measure"},
           {[] { throwInput("b.mha", "", "is cut"); }, ErrorKind::input, "b.mha: is cut"},
           {[] { throw 7; }, ErrorKind::input, "a.hdr: cannot measure"}}) {
    const auto task = Task<void>::start({"a.hdr", "measure"}, [work](Progress&) { work(); });
    waitUntil([&] { return task->finished(); });
    ASSERT_TRUE(task->error()) << line;
    EXPECT_EQ(task->error()->kind(), kind);
    EXPECT_STREQ(task->error()->what(), line);
  }
}

// Each piece of news is taken once, also of a task that fails.
TEST(Task, TellsItsNewsInOrder) {
  using Counting = Task<void, std::vector<int>>;
  const auto task = Counting::start({"", "count"}, [](Progress&, const auto& tell) {
    for (int i = 0; i < 100; ++i) tell([i](std::vector<int>& news) { news.push_back(i); });
    throw std::logic_error("enough");
  });
  std::vector<int> all;
  waitUntil([&] {
    const bool finished = task->finished();
    for (const int one : task->take()) all.push_back(one);
    return finished;
  });
  ASSERT_EQ(all.size(), 100u);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(all[static_cast<std::size_t>(i)], i);
  EXPECT_TRUE(task->take().empty());
  EXPECT_TRUE(task->error());
}

TEST(Task, NotifiesOfNewsAndOfItsEnd) {
  std::atomic<int> notified{0};
  std::atomic<bool> mayEnd{false}, knownAtItsEnd{false};
  const auto task = Task<void, int>::start({"", "count"}, [&](Progress&, const auto& tell) {
    tell([](int& news) { ++news; });
    waitUntil([&] { return mayEnd.load(); });
  });
  task->setNotify([&] {
    ++notified;
    if (task && task->finished()) knownAtItsEnd = true;
  });
  EXPECT_GE(notified, 1);  // of what there was before, too
  const int before = notified;
  mayEnd = true;
  waitUntil([&] { return knownAtItsEnd.load(); });
  EXPECT_GT(notified, before);
  EXPECT_EQ(task->take(), 1);
}

TEST(Task, DestroyedItStopsAndEndsInTheBackground) {
  std::atomic<bool> ended{false};
  auto task = Task<void>::start({"", "wait"}, [&](Progress& progress) {
    waitUntil([&] { return progress.stopRequested(); });
    ended = true;
  });
  EXPECT_FALSE(task->finished());
  task.reset();
  EXPECT_TRUE(awaitDestroyed(60.0));
  EXPECT_TRUE(ended);
}

}  // namespace
}  // namespace isolux::base
