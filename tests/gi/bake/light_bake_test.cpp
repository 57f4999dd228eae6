#include "gi/bake/light_bake.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <future>
#include <numeric>
#include <optional>
#include <random>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "gi/bake/bake_queue.h"
#include "tests/gi/bake/formula_estimator.h"

namespace isolux::gi {
namespace {

using testing::ElementsAre;

constexpr double kNeverSeconds = 120.0;  // a test that waits this long hangs

const LatticeGeometry kGeometry = LatticeGeometry::make({24, 17, 9}, 1.0);

std::shared_ptr<LightLattice> makeLattice(const TexelEstimator& estimator,
                                          const LatticeGeometry& geometry = kGeometry) {
  return std::make_shared<LightLattice>(geometry, estimator.content(), "key");
}

std::vector<BlockRequest> everything(const LatticeGeometry& geometry = kGeometry) {
  return texelsWhere(geometry, [](glm::ivec3) { return true; });
}

TEST(LightBake, RoundsEndAtPowersOfFourThenEvenly) {
  EXPECT_THAT(roundsUpTo(1), ElementsAre(1u));
  EXPECT_THAT(roundsUpTo(4), ElementsAre(4u));
  EXPECT_THAT(roundsUpTo(100), ElementsAre(4u, 16u, 64u, 100u));
  EXPECT_THAT(roundsUpTo(256), ElementsAre(4u, 16u, 64u, 256u));
  EXPECT_THAT(roundsUpTo(3500), ElementsAre(4u, 16u, 64u, 256u, 1024u, 2048u, 3072u, 3500u));
}

TEST(LightBake, LatticeIsTheFormulaForAnyNumberOfThreads) {
  for (const int threads : {1, 2, 7})
    for (const bool background : {false, true})
      for (const LightContent content : {LightContent{LightContent::Kind::irradiance, 3, 0},
                                         LightContent{LightContent::Kind::transfer, 1, 3}}) {
        const auto estimator = std::make_shared<FormulaEstimator>(content);
        const auto lattice = makeLattice(*estimator);
        LightBake bake(lattice, estimator, {.samples = 100, .threads = threads, .background = background});
        bake.want(Priority::rest, everything());
        ASSERT_TRUE(bake.waitFor(0, kNeverSeconds));
        EXPECT_EQ(differenceFrom(*lattice, 100), "");
        EXPECT_TRUE(allHave(*lattice, everything(), 100));
      }
}

TEST(LightBake, CountsWhatItDoes) {
  const auto estimator = std::make_shared<FormulaEstimator>();
  const auto lattice = makeLattice(*estimator);
  const int texels = kGeometry.dims.x * kGeometry.dims.y * kGeometry.dims.z;
  std::uint64_t lit = 0;
  for (const BlockRequest& w : everything())
    for (int i = 0; i < kTexelsOfBlock; ++i)
      lit += w.texels[static_cast<std::size_t>(i)] &&
             FormulaEstimator::normalOf(kGeometry.texelOf(w.block, i)) != glm::vec3(0.0f);

  LightBake bake(lattice, estimator, {.samples = 20, .threads = 2});
  EXPECT_TRUE(bake.counters().idle);
  bake.setPaused(true);
  bake.want(Priority::rest, everything());
  EXPECT_FALSE(bake.waitFor(0, 0.0));  // the request is in the queue then
  BakeCounters counters = bake.counters();
  EXPECT_EQ(counters.texelsWanted, static_cast<std::uint64_t>(texels));
  EXPECT_EQ(counters.texelsStarted, 0u);
  EXPECT_FALSE(counters.idle);
  EXPECT_TRUE(counters.paused);

  bake.want(Priority::visible, {everything().front()});  // wanted twice, counted once
  EXPECT_FALSE(bake.waitFor(0, 0.0));
  EXPECT_EQ(bake.counters().texelsWanted, static_cast<std::uint64_t>(texels));

  bake.setPaused(false);
  ASSERT_TRUE(bake.waitFor(0, kNeverSeconds));
  counters = bake.counters();
  EXPECT_TRUE(counters.idle);
  EXPECT_EQ(counters.texelsWanted, lit);
  EXPECT_EQ(counters.texelsDone, lit);
  EXPECT_EQ(counters.texelsStarted, lit);
  EXPECT_EQ(counters.texelsLit, lit);
  EXPECT_EQ(counters.samplesWanted, 20 * lit);
  EXPECT_EQ(counters.samplesDone, 20 * lit);
  EXPECT_EQ(counters.rays, 40 * lit);
  EXPECT_EQ(counters.secondsLeft, 0.0);
  EXPECT_GT(counters.seconds, 0.0);
  EXPECT_GT(counters.raysPerSecond, 0.0);
  EXPECT_EQ(counters.threads, 2);
}

// What a bake on one thread asks its estimator for, in order.
struct Record {
  std::mutex mutex;
  std::vector<std::pair<glm::ivec3, std::uint32_t>> firstTexelAndSample;
  void operator()(std::span<const glm::ivec3> texels, SampleRange range) {
    const std::lock_guard lock(mutex);
    for (const glm::ivec3& texel : texels) firstTexelAndSample.emplace_back(texel, range.first);
  }
};

TEST(LightBake, ServesWishesThenRoundsThenTheOrderGiven) {
  const auto estimator = std::make_shared<FormulaEstimator>();
  Record record;
  std::atomic<bool> requested{
      false};  // a call may begin before the bake is paused, when nobody has wished yet
  estimator->before = [&](std::span<const glm::ivec3> texels, SampleRange range, std::stop_token) {
    if (requested) record(texels, range);
    return true;
  };
  const auto lattice = makeLattice(*estimator);
  const auto requestOf = [](glm::ivec3 texel) { return (texel.x + texel.y) % 4; };
  std::vector<std::uint32_t> order(kGeometry.blockCount());
  {
    LightBake bake(lattice, estimator, {.samples = 40, .threads = 1});
    bake.setPaused(true);
    std::mt19937 random(5);
    std::vector<std::uint32_t> blocks(kGeometry.blockCount());
    std::iota(blocks.begin(), blocks.end(), 0u);
    std::shuffle(blocks.begin(), blocks.end(), random);
    for (std::size_t i = 0; i < blocks.size(); ++i) order[blocks[i]] = static_cast<std::uint32_t>(i);
    for (int request = 3; request >= 0; --request) {
      auto wanted = texelsWhere(kGeometry, [&](glm::ivec3 texel) { return requestOf(texel) == request; });
      std::sort(wanted.begin(), wanted.end(),
                [&](const auto& a, const auto& b) { return order[a.block] < order[b.block]; });
      bake.want(static_cast<Priority>(request), wanted);
    }
    EXPECT_FALSE(
        bake.waitFor(0, 0.0));  // all requests are in the queue then: a worker may be taking some just now
    requested = true;
    bake.setPaused(false);
    ASSERT_TRUE(bake.waitFor(0, kNeverSeconds));
  }
  const auto rankOf = [&](const auto& asked) {
    return std::array<std::uint32_t, 3>{static_cast<std::uint32_t>(requestOf(asked.first)), asked.second,
                                        order[kGeometry.blockOf(asked.first)]};
  };
  EXPECT_TRUE(std::is_sorted(record.firstTexelAndSample.begin(), record.firstTexelAndSample.end(),
                             [&](const auto& a, const auto& b) { return rankOf(a) < rankOf(b); }));
  EXPECT_EQ(differenceFrom(*lattice, 40), "");
}

// Lets calls of an estimator through one at a time.
class Gate {
 public:
  bool pass(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    ++waiting_;
    changed_.notify_all();
    const bool open = changed_.wait(lock, stop, [&] { return allowed_ > 0; });
    --waiting_;
    allowed_ -= open;
    return open;
  }
  void allow(int calls) {
    const std::lock_guard lock(mutex_);
    allowed_ += calls;
    changed_.notify_all();
  }
  void awaitCaller() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return waiting_ > 0; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable_any changed_;
  int allowed_ = 0, waiting_ = 0;
};

TEST(LightBake, NewWishesGoBeforeTheRestOfAUnit) {
  const auto estimator = std::make_shared<FormulaEstimator>();
  Gate gate;
  Record record;
  estimator->before = [&](std::span<const glm::ivec3> texels, SampleRange range,
                          const std::stop_token& stop) {
    record(texels, range);
    return gate.pass(stop);
  };
  const auto lattice = makeLattice(*estimator, LatticeGeometry::make({16, 8, 8}, 1.0));
  LightBake bake(lattice, estimator, {.samples = 1024, .threads = 1});
  bake.want(Priority::rest, {{0, std::bitset<kTexelsOfBlock>().set()}});
  const auto recorded = [&] {
    const std::lock_guard lock(record.mutex);
    return record.firstTexelAndSample;
  };
  const auto awaitCall = [&](std::uint64_t call) {
    while (estimator->calls < call) std::this_thread::yield();
    gate.awaitCaller();
  };
  // On to the last round, which takes several calls: its first is at the gate.
  std::uint64_t call = 1;
  for (awaitCall(call); recorded().back().second < 256; awaitCall(++call)) gate.allow(1);
  const std::size_t before = recorded().size();
  bake.want(Priority::visible, {{1, std::bitset<kTexelsOfBlock>(2)}});
  gate.allow(1);
  awaitCall(++call);
  ASSERT_GT(recorded().size(), before);
  EXPECT_EQ(recorded()[before].first, glm::ivec3(9, 0, 0));
  EXPECT_EQ(recorded()[before].second, 0u);
}

TEST(LightBake, EndsAtOnceWithAnEstimatorThatIsSlow) {
  const auto estimator = std::make_shared<FormulaEstimator>();
  Gate gate;  // never opens; only a stop lets callers go
  estimator->before = [&](std::span<const glm::ivec3>, SampleRange, const std::stop_token& stop) {
    return gate.pass(stop);
  };
  const auto lattice = makeLattice(*estimator);
  for (const bool background : {false, true}) {
    const std::uint64_t before = estimator->calls;
    auto bake = std::make_unique<LightBake>(
        lattice, estimator, LightBake::Options{.samples = 100, .threads = 3, .background = background});
    bake->want(Priority::rest, everything());
    while (estimator->calls < before + 3) std::this_thread::yield();
    bake.reset();                             // no call ends without the stop
    EXPECT_EQ(estimator->calls, before + 3);  // and none begins after it
    EXPECT_EQ(lattice->bakedTexels(), 0u);
  }
  gate.allow(1 << 30);
  LightBake bake(lattice, estimator, {.samples = 100, .threads = 3});
  bake.want(Priority::rest, everything());
  ASSERT_TRUE(bake.waitFor(0, kNeverSeconds));
  EXPECT_EQ(differenceFrom(*lattice, 100), "");
}

TEST(LightBake, PauseLetsNoCallBegin) {
  const auto estimator = std::make_shared<FormulaEstimator>();
  Gate gate;
  estimator->before = [&](std::span<const glm::ivec3>, SampleRange, const std::stop_token& stop) {
    return gate.pass(stop);
  };
  const auto lattice = makeLattice(*estimator);
  LightBake bake(lattice, estimator, {.samples = 256, .threads = 2});
  bake.want(Priority::rest, everything());
  gate.allow(4);
  while (estimator->calls < 5) std::this_thread::yield();
  gate.awaitCaller();
  bake.setPaused(true);
  const std::uint64_t calls = estimator->calls;
  gate.allow(1 << 30);
  EXPECT_FALSE(bake.waitFor(0, 0.05));
  EXPECT_LE(estimator->calls, calls + 2);  // each thread may have been about to call
  EXPECT_TRUE(bake.counters().paused);
  bake.setPaused(false);
  EXPECT_TRUE(bake.waitFor(0, kNeverSeconds));
  EXPECT_EQ(differenceFrom(*lattice, 256), "");
}

// An owner that never ends its yield, and asks for it again and again, does not stop the bake: were each
// request a new quarter of a second, it would never end.
TEST(LightBake, YieldsForAQuarterOfASecondAtMost) {
  const auto estimator = std::make_shared<FormulaEstimator>();
  std::once_flag once;
  std::chrono::steady_clock::time_point first;
  estimator->before = [&](std::span<const glm::ivec3>, SampleRange, std::stop_token) {
    std::call_once(once, [&] { first = std::chrono::steady_clock::now(); });
    return true;
  };
  const auto lattice = makeLattice(*estimator);
  LightBake bake(lattice, estimator, {.samples = 4, .threads = 2});
  const auto start = std::chrono::steady_clock::now();
  bake.yield(true);
  bake.want(Priority::rest, everything());
  for (int asked = 0; !bake.waitFor(0, 0.01); ++asked) {
    ASSERT_LT(asked, 10000) << "each request begins anew";
    bake.yield(true);
  }
  EXPECT_GE(first - start, std::chrono::milliseconds(250));  // a load only makes it longer
}

TEST(LightBake, GoesOnWhenYieldEnds) {
  const auto estimator = std::make_shared<FormulaEstimator>();
  const auto lattice = makeLattice(*estimator);
  LightBake bake(lattice, estimator, {.samples = 64, .threads = 2});
  bake.want(Priority::rest, everything());
  for (int i = 0; i < 200; ++i) bake.yield(i % 2 == 0);
  ASSERT_TRUE(bake.waitFor(0, kNeverSeconds));
  EXPECT_EQ(differenceFrom(*lattice, 64), "");
}

// Paths of 0.2 ms at least: a texel's round of 768 of them takes 150 ms, and is cut. The request is made by
// the second call of that round itself: no thread has to be in time.
TEST(LightBake, HeedsWishesWithinTheRoundOfATexelWhosePathsAreLong) {
  const auto estimator = std::make_shared<FormulaEstimator>();
  const auto lattice = makeLattice(*estimator, LatticeGeometry::make({16, 8, 8}, 1.0));
  int x = 0;
  while (FormulaEstimator::normalOf({x, 0, 0}) == glm::vec3(0.0f)) ++x;
  const std::vector<BlockRequest> rest{{0, std::bitset<kTexelsOfBlock>(1ull << x)}},
      visible{{1, std::bitset<kTexelsOfBlock>(2)}};
  std::uint32_t longestCall = 0;  // all of the one thread of the bake
  int callsOfRound = 0;
  std::optional<int> callsBeforeTheWish;
  LightBake* asked = nullptr;
  std::promise<void> made;
  const std::shared_future<void> known = made.get_future().share();
  estimator->before = [&](std::span<const glm::ivec3> texels, SampleRange range, std::stop_token) {
    known.wait();
    const bool ofWish = texels.front() == glm::ivec3(9, 0, 0);
    if (ofWish && !callsBeforeTheWish) callsBeforeTheWish = callsOfRound;
    if (range.first >= 256) {
      longestCall = std::max(longestCall, range.count);
      if (!ofWish && ++callsOfRound == 2) asked->want(Priority::visible, visible);
    }
    std::this_thread::sleep_for(std::chrono::microseconds(200) * range.count);
    return true;
  };
  LightBake bake(lattice, estimator, {.samples = 1024, .threads = 1});
  asked = &bake;
  made.set_value();
  bake.want(Priority::rest, rest);
  ASSERT_TRUE(bake.waitFor(0, kNeverSeconds));
  EXPECT_EQ(callsBeforeTheWish, 2) << "the round was waited for";
  EXPECT_GT(callsOfRound, 2);
  EXPECT_LE(longestCall, 384u);
  EXPECT_EQ(differenceFrom(*lattice, 1024), "") << "what was summed before the wish counts once";
  EXPECT_TRUE(allHave(*lattice, rest, 1024) && allHave(*lattice, visible, 1024));
}

TEST(LightBake, WaitsForARound) {
  const auto estimator = std::make_shared<FormulaEstimator>();
  Gate gate;
  estimator->before = [&](std::span<const glm::ivec3>, SampleRange range, const std::stop_token& stop) {
    return range.first < 4 || gate.pass(stop);
  };
  const auto lattice = makeLattice(*estimator);
  LightBake bake(lattice, estimator, {.samples = 64, .threads = 2});
  bake.want(Priority::rest, everything());
  ASSERT_TRUE(bake.waitFor(4, kNeverSeconds));
  EXPECT_TRUE(allHave(*lattice, everything(), 4));
  EXPECT_FALSE(bake.waitFor(5, 0.0));
  gate.allow(1 << 30);
  EXPECT_TRUE(bake.waitFor(0, kNeverSeconds));
}

TEST(LightBake, MoreSamplesGoOnAndFewerLeaveWhatThereIs) {
  const auto estimator = std::make_shared<FormulaEstimator>();
  const auto lattice = makeLattice(*estimator);
  LightBake bake(lattice, estimator, {.samples = 64, .threads = 2});
  bake.want(Priority::rest, everything());
  ASSERT_TRUE(bake.waitFor(0, kNeverSeconds));
  const std::uint64_t paths = estimator->paths;
  bake.setSamples(256);
  ASSERT_TRUE(bake.waitFor(0, kNeverSeconds));
  EXPECT_EQ(estimator->paths, 4 * paths);
  EXPECT_EQ(differenceFrom(*lattice, 256), "");
  EXPECT_TRUE(allHave(*lattice, everything(), 256));
  bake.setSamples(16);
  ASSERT_TRUE(bake.waitFor(0, kNeverSeconds));
  EXPECT_TRUE(allHave(*lattice, everything(), 256));
  EXPECT_EQ(bake.counters().texelsDone, bake.counters().texelsWanted);
}

// 100 is no end of a round for 400: the same samples, summed in other groups.
TEST(LightBake, GoesOnFromAnyNumberOfSamples) {
  const auto estimator = std::make_shared<FormulaEstimator>();
  const auto lattice = makeLattice(*estimator);
  for (const std::uint32_t samples : {1u, 100u, 400u}) {
    LightBake bake(lattice, estimator, {.samples = samples, .threads = 2});
    bake.want(Priority::rest, everything());
    ASSERT_TRUE(bake.waitFor(0, kNeverSeconds));
  }
  EXPECT_TRUE(allHave(*lattice, everything(), 400));
  const auto block = lattice->at(0);
  ASSERT_TRUE(block);
  for (std::size_t i = 0; i < kTexelsOfBlock; ++i) {
    const glm::ivec3 texel = kGeometry.texelOf(0, static_cast<int>(i));
    if (block->samples[i] == 0) continue;
    EXPECT_EQ(block->means[3 * i], FormulaEstimator::bakedOf(texel, {1, 4, 16, 64, 100, 256, 400}, 0));
    EXPECT_NEAR(block->means[3 * i], FormulaEstimator::meanOf(texel, {0, 400}, 0), 1e-6);
  }
}

TEST(LightBake, PassesOverWhatIsNotInTheLattice) {
  const auto estimator = std::make_shared<FormulaEstimator>();
  const auto lattice = makeLattice(*estimator, LatticeGeometry::make({9, 9, 9}, 1.0));
  LightBake bake(lattice, estimator, {.samples = 4, .threads = 2});
  const auto all = std::bitset<kTexelsOfBlock>().set();
  bake.want(Priority::visible, {{7, all}, {8, all}, {0xffffffff, all}, {7, all}, {0, {}}});
  ASSERT_TRUE(bake.waitFor(0, kNeverSeconds));
  EXPECT_EQ(bake.counters().texelsWanted, FormulaEstimator::normalOf({8, 8, 8}) == glm::vec3(0.0f) ? 0u : 1u);
  EXPECT_FALSE(lattice->at(0));
}

TEST(LightBake, KeepsTheErrorOfItsEstimator) {
  const auto failWith = [](const std::function<void()>& fault) {
    const auto estimator = std::make_shared<FormulaEstimator>();
    std::atomic<int> calls{0};
    estimator->before = [&](std::span<const glm::ivec3>, SampleRange, std::stop_token) {
      if (++calls > 20) fault();
      return true;
    };
    const auto lattice = makeLattice(*estimator);
    LightBake bake(lattice, estimator, {.samples = 1000, .threads = 3});
    EXPECT_FALSE(bake.failure());
    bake.want(Priority::rest, everything());
    EXPECT_FALSE(bake.waitFor(0, kNeverSeconds));
    EXPECT_EQ(differenceFrom(*lattice, 1000), "");  // what was lit stays
    EXPECT_GT(lattice->bakedTexels(), 0u);
    EXPECT_FALSE(bake.counters().idle);
    ASSERT_TRUE(bake.failure());
    std::rethrow_exception(bake.failure());
  };
  EXPECT_THROW(failWith([] { throw std::bad_alloc(); }), std::bad_alloc);
  try {
    failWith([] { base::throwInput("sky.hdr", "row 3", "is black"); });
    FAIL();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::input);
    EXPECT_EQ(error.file(), "sky.hdr");
  }
  // A mistake of our own stays one: no input is blamed.
  EXPECT_THROW(failWith([] { throw std::logic_error("no such light"); }), std::logic_error);
  EXPECT_THROW(failWith([] { throw 7; }), int);
}

TEST(LightBake, BearsWishesThousandsOfTimesASecond) {
  const auto estimator = std::make_shared<FormulaEstimator>();
  const auto lattice = makeLattice(*estimator);
  LightBake bake(lattice, estimator, {.samples = 64, .threads = 2});
  bake.want(Priority::rest, everything());
  const auto odd = texelsWhere(kGeometry, [](glm::ivec3 t) { return (t.x + t.y + t.z) % 2 == 1; });
  const auto even = texelsWhere(kGeometry, [](glm::ivec3 t) { return (t.x + t.y + t.z) % 2 == 0; });
  for (int i = 0; i < 5000; ++i) {
    bake.want(Priority::visible, i % 2 ? odd : even);
    if (i % 100 == 0) {
      const BakeCounters counters = bake.counters();
      EXPECT_LE(counters.texelsDone, counters.texelsWanted);
    }
  }
  ASSERT_TRUE(bake.waitFor(0, kNeverSeconds));
  EXPECT_EQ(differenceFrom(*lattice, 64), "");
  EXPECT_TRUE(allHave(*lattice, everything(), 64));
}

// Starts, edits, cancels and resumes in every order; whatever was done, light is that of the formula.
TEST(LightBake, IsTheSameAfterAnyHistory) {
  const LatticeGeometry geometry = LatticeGeometry::make({17, 12, 9}, 1.0);
  const auto estimator = std::make_shared<FormulaEstimator>();
  std::mt19937 random(1);
  const auto upTo = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const auto anyTexels = [&] {
    const auto rest = static_cast<int>(1 + upTo(5));
    auto wanted = texelsWhere(geometry, [&](glm::ivec3 t) { return (t.x * 3 + t.y * 5 + t.z) % rest == 0; });
    std::shuffle(wanted.begin(), wanted.end(), random);
    wanted.resize(static_cast<std::size_t>(upTo(static_cast<int>(wanted.size()) + 1)));
    return wanted;
  };
  constexpr std::array<std::uint32_t, 3> ends{4, 16, 64};
  std::weak_ptr<LightLattice> gone;
  for (int sequence = 0; sequence < 1000; ++sequence) {
    auto lattice = makeLattice(*estimator, geometry);
    std::array<std::vector<BlockRequest>, 4> requests;
    std::uint32_t least = 0, most = 0;
    const int starts = 1 + upTo(3);
    for (int start = 0; start < starts; ++start) {
      std::uint32_t samples = ends[static_cast<std::size_t>(upTo(3))];
      most = std::max(most, samples);
      requests = {};
      LightBake bake(lattice, estimator, {.samples = samples, .threads = 1 + upTo(4)});
      for (int edit = upTo(8); edit >= 0; --edit) {
        const auto request = static_cast<std::size_t>(upTo(4));
        switch (upTo(8)) {
          case 0:
          case 1:
          case 2:
            requests[request] = anyTexels();
            bake.want(static_cast<Priority>(request), requests[request]);
            break;
          case 3:
            samples = ends[static_cast<std::size_t>(upTo(3))];
            most = std::max(most, samples);
            bake.setSamples(samples);
            break;
          case 4:
            bake.setThreads(1 + upTo(4));
            break;
          case 5:
            bake.setPaused(upTo(2) == 0);
            break;
          case 6:
            bake.yield(upTo(2) == 0);
            break;
          case 7:
            bake.waitFor(ends[static_cast<std::size_t>(upTo(3))], 0.001);
            break;
        }
      }
      if (start + 1 < starts) continue;  // cancelled as it is
      bake.setPaused(false);
      bake.yield(false);
      ASSERT_TRUE(bake.waitFor(0, kNeverSeconds)) << "sequence " << sequence;
      least = samples;
      ASSERT_FALSE(bake.failure());
      const BakeCounters counters = bake.counters();
      ASSERT_TRUE(counters.idle);
      ASSERT_EQ(counters.texelsDone, counters.texelsWanted);
      ASSERT_EQ(counters.samplesDone, counters.texelsWanted * least);
    }
    ASSERT_EQ(differenceFrom(*lattice, most), "") << "sequence " << sequence;
    for (const auto& request : requests)
      for (const BlockRequest& wanted : request) {
        const auto block = lattice->at(wanted.block);
        ASSERT_TRUE(block);
        for (std::size_t i = 0; i < kTexelsOfBlock; ++i)
          ASSERT_TRUE(!wanted.texels[i] || block->unlit[i] || block->samples[i] >= least);
      }
    gone = lattice;
    lattice.reset();
    ASSERT_TRUE(gone.expired());
  }
}

}  // namespace
}  // namespace isolux::gi
