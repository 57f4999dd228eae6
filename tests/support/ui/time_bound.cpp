#include "tests/support/ui/time_bound.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include <unistd.h>

#include <gtest/gtest.h>

namespace isolux::test {

namespace {

constexpr unsigned boundInSeconds = 180;
char message[256];  // prepared when a test starts: the handler may do little
int messageLength = 0;

void endLateTest(int) {
  if (::write(STDERR_FILENO, message, static_cast<std::size_t>(messageLength)) < 0) std::_Exit(1);
  std::abort();
}

class TimeBound : public testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo& test) override {
    const int length = std::snprintf(message, sizeof message, "%s.%s took more than %u s\n",
                                     test.test_suite_name(), test.name(), boundInSeconds);
    messageLength = std::min(length, static_cast<int>(sizeof message) - 1);
    restartTimeBound();
  }
  void OnTestEnd(const testing::TestInfo&) override { ::alarm(0); }
};

}  // namespace

void boundEachTest() {
  std::signal(SIGALRM, endLateTest);
  testing::UnitTest::GetInstance()->listeners().Append(new TimeBound);  // which owns it
}

void restartTimeBound() {
  ::alarm(boundInSeconds);
}

}  // namespace isolux::test
