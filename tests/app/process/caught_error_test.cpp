// Whatever a background job's work throws is its error, and the process goes on.
#include "app/process/caught_error.h"

#include <functional>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/jobs/quiet_job.h"
#include "tests/support/poll.h"

namespace isolux::app {
namespace {

struct ThrowingWork {
  using Subject = std::function<void()>;
  static constexpr const char* kDoes = "measure";
  void run(base::Progress&) { subject(); }
  Subject subject;
};

TEST(CaughtError, ABackgroundJobKeepsWhateverIsThrown) {
  struct Case {
    std::function<void()> work;
    base::ErrorKind kind;
    const char* line;
  };
  for (const auto& [work, kind, line] : std::vector<Case>{
           {[] { throw std::logic_error("no such case"); }, base::ErrorKind::input,
            "cannot measure: no such case"},
           {[] { throw std::bad_alloc(); }, base::ErrorKind::memory, "not enough memory to measure"},
           {[] { base::throwInput("a.mha", "", "is cut"); }, base::ErrorKind::input, "a.mha: is cut"},
           {[] { throw 7; }, base::ErrorKind::input, "cannot measure"}}) {
    const QuietJob<ThrowingWork> job(work);
    ASSERT_TRUE(test::pollUntil([&] { return job.finished(); }));
    ASSERT_TRUE(job.error()) << line;
    EXPECT_EQ(job.error()->kind(), kind);
    EXPECT_STREQ(job.error()->what(), line);
  }
}

TEST(CaughtError, NamesTheFileAndKeepsNothingWhereAllGoesWell) {
  EXPECT_FALSE(caughtError("a.hdr", "load", [] {}));
  const auto error = caughtError("a.hdr", "load", [] { EXPECT_TRUE(nlohmann::json::parse("{").empty()); });
  ASSERT_TRUE(error);
  EXPECT_EQ(std::string(error->what()).find("a.hdr: cannot load: "), 0u) << error->what();
}

}  // namespace
}  // namespace isolux::app
