// Which times of a card are waited for: with a card that is only a clock.
#include "render/gl/part_timer.h"

#include <algorithm>
#include <map>
#include <memory>

#include <gtest/gtest.h>

namespace isolux::test {
namespace {

// Its timers are ready at once or only when they are waited for.
struct ClockCard {
  static inline GLuint64 now = 0;  // ns
  static inline bool ready = true;
  static inline std::map<GLuint, GLuint64> times;
  static inline GLuint queries = 0;
  static inline int waits = 0, flushes = 0;

  static std::shared_ptr<render::Gl> make() {
    times.clear();
    now = 0;
    queries = 0;
    waits = flushes = 0;
    ready = true;
    auto gl = std::make_shared<render::Gl>();
    gl->CreateQueries = [](GLenum, GLsizei, GLuint* id) { *id = ++queries; };
    gl->DeleteQueries = [](GLsizei, const GLuint*) {};
    gl->QueryCounter = [](GLuint id, GLenum) { times[id] = now; };
    gl->Flush = [] { ++flushes; };
    gl->GetQueryObjectui64v = [](GLuint id, GLenum what, GLuint64* value) {
      if (what == GL_QUERY_RESULT_AVAILABLE)
        *value = ready ? 1 : 0;
      else {
        waits += ready ? 0 : 1;
        *value = times[id];
      }
    };
    return gl;
  }
};

// Draws so many rays, each of which takes `nanoseconds`; returns the parts, and the longest in ms.
std::pair<int, double> drawTimed(render::PartTimer& timer, int rays, GLuint64 nanoseconds) {
  int parts = 0;
  double longest = 0.0;
  timer.beginDraw();
  for (int left = rays; left > 0; ++parts) {
    const int now = std::min(timer.beginPart(), left);
    const GLuint64 took = static_cast<GLuint64>(now) * nanoseconds;
    ClockCard::now += took;
    longest = std::max(longest, static_cast<double>(took) * 1e-6);
    timer.endPart(now);
    left -= now;
  }
  timer.endDraw();
  return {parts, longest};
}

TEST(PartTimerTest, PartsOfASlowCardStayShort) {
  render::PartTimer timer(ClockCard::make());
  for (int frame = 0; frame < 10; ++frame) EXPECT_LT(drawTimed(timer, 1 << 20, 100).second, 10.0);
  // The rays become ten times as costly: the next parts are cut as soon as a time is known.
  const auto [parts, longest] = drawTimed(timer, 1 << 20, 1000);
  EXPECT_GT(parts, 100);
  EXPECT_LT(drawTimed(timer, 1 << 20, 1000).second, 10.0);
  EXPECT_LT(longest, 100.0);
}

TEST(PartTimerTest, AFastCardIsNotWaitedForOnceItIsKnown) {
  render::PartTimer timer(ClockCard::make());
  for (int frame = 0; frame < 6; ++frame) drawTimed(timer, 1 << 20, 1);
  ClockCard::ready = false;  // from now on times come late
  ClockCard::waits = 0;
  ClockCard::flushes = 0;
  const int parts = drawTimed(timer, 1 << 19, 1).first;
  EXPECT_EQ(parts, 1);
  EXPECT_EQ(ClockCard::waits, 0);
  EXPECT_EQ(ClockCard::flushes, parts);
}

TEST(PartTimerTest, AtMostThreePartsAreOnTheirWay) {
  render::PartTimer timer(ClockCard::make());
  drawTimed(timer, 1 << 20, 100);
  ClockCard::ready = false;
  drawTimed(timer, 1 << 22, 100);
  EXPECT_GT(ClockCard::waits, 0);
  EXPECT_LE(ClockCard::queries, 2 * 3u);  // timers are used again
}

}  // namespace
}  // namespace isolux::test
