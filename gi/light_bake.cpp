#include "gi/light_bake.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <new>
#include <stop_token>
#include <system_error>
#include <thread>
#include <utility>

#include "gi/bake_queue.h"
#include "gi/bake_rate.h"
#include "gi/bake_unit.h"

#ifdef __linux__
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace isolux::gi {

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kLongestYield = std::chrono::milliseconds(250);

// A thread that may not change its priority keeps it: the bake is then only less polite.
void runInBackground() {
#ifdef __linux__
  const sched_param none{};
  if (sched_setscheduler(0, SCHED_IDLE, &none) != 0)
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), 19);
#endif
}

scene::Error errorOf(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const scene::Error& error) {
    return error;
  } catch (const std::bad_alloc&) {
    return {scene::ErrorKind::memory, "", "", "out of memory for stored light"};
  } catch (const std::exception& error) {
    return {scene::ErrorKind::input, "", "", std::string("the bake failed: ") + error.what()};
  } catch (...) {
    return {scene::ErrorKind::input, "", "", "the bake failed"};
  }
}

}  // namespace

// Two locks. `front` is held for moments only, so that the window never waits for a thread that runs when
// nobody else does: it guards what callers set and ask. `queueLock` guards the queue, which may take a
// millisecond over new wishes; it is locked first where both are.
struct LightBake::Parts {
  std::shared_ptr<LightLattice> lattice;
  std::shared_ptr<const TexelEstimator> estimator;
  bool background = false;

  std::mutex queueLock;
  BakeQueue queue;

  std::mutex front;
  std::condition_variable_any changed;  // with `signal`
  std::uint64_t signal = 0;             // rises with all that a waiting thread may want to know
  std::array<std::optional<std::vector<WantedBlock>>, 4> wishes;  // not yet in the queue
  std::optional<std::uint32_t> samples;                           // not yet in the queue
  std::uint64_t orders = 0;                                       // counts want() and setSamples()
  int threads = 1;
  bool paused = false, yielding = false;
  Clock::time_point yieldsUntil;
  std::optional<scene::Error> error;
  BakeQueue::Totals totals;
  std::uint32_t samplesWanted = 1;  // a texel, that `totals` are of
  bool queueIdle = true;
  int working = 0;  // threads
  Clock::time_point workingSince;
  double workedSeconds = 0.0;  // before workingSince
  std::uint64_t rays = 0, paths = 0;
  BakeRate rate;

  std::mutex threadsLock;
  std::vector<std::jthread> workers;  // the last member: they end before the rest goes

  Parts(std::shared_ptr<LightLattice> l, std::shared_ptr<const TexelEstimator> e, const Options& options)
      : lattice(std::move(l)),
        estimator(std::move(e)),
        background(options.background),
        queue(*lattice, options.samples),
        samplesWanted(queue.samples()) {}

  template <typename Change>
  void set(Change change) {
    {
      const std::lock_guard lock(front);
      change();
      ++signal;
    }
    changed.notify_all();
  }

  // With `front` locked.
  bool mustWait(int worker) const {
    return paused || error || worker >= threads || (yielding && Clock::now() < yieldsUntil);
  }
  double seconds() const {
    const std::chrono::duration<double> now = Clock::now() - workingSince;
    return workedSeconds + (working > 0 ? now.count() : 0.0);
  }
  bool ordersWait() const {
    return samples || std::any_of(wishes.begin(), wishes.end(), [](const auto& w) { return w.has_value(); });
  }

  // With `queueLock` locked.
  void takeOrders();
  void publish();

  void work(int worker, const std::stop_token& stop) noexcept;
  bool workOnce(int worker, UnitRunner& runner, const std::stop_token& stop);
  void fail(const std::exception_ptr& thrown);
};

void LightBake::Parts::takeOrders() {
  decltype(wishes) freshWishes;
  std::optional<std::uint32_t> freshSamples;
  {
    const std::lock_guard lock(front);
    freshWishes.swap(wishes);
    freshSamples.swap(samples);
    if (freshSamples || std::any_of(freshWishes.begin(), freshWishes.end(),
                                    [](const auto& wish) { return wish.has_value(); }))
      queueIdle = false;  // until publish() knows better
  }
  if (freshSamples) queue.setSamples(*freshSamples);
  for (std::size_t w = 0; w < freshWishes.size(); ++w)
    if (freshWishes[w]) queue.want(static_cast<Wish>(w), std::move(*freshWishes[w]));
}

void LightBake::Parts::publish() {
  const std::lock_guard lock(front);
  totals = queue.totals();
  samplesWanted = queue.samples();
  queueIdle = queue.idle();
}

// Takes one unit and works on it; false: there is nothing to do, or the thread must wait.
bool LightBake::Parts::workOnce(int worker, UnitRunner& runner, const std::stop_token& stop) {
  std::optional<BakeQueue::Unit> unit;
  std::uint64_t ordersThen = 0;
  {
    const std::lock_guard queueGuard(queueLock);
    takeOrders();
    bool wait = false;
    {
      const std::lock_guard lock(front);
      wait = mustWait(worker);
      ordersThen = orders;
    }
    if (!wait) unit = queue.take();
    publish();
    if (!unit) return false;
    const std::lock_guard lock(front);
    if (working++ == 0) workingSince = Clock::now();
  }
  std::exception_ptr thrown;
  try {
    runner.run(*unit, stop, [&](std::uint64_t moreRays, std::uint64_t morePaths) {
      const std::lock_guard lock(front);
      rays += moreRays;
      paths += morePaths;
      rate.note(seconds(), rays, paths);
      return stop.stop_requested() || mustWait(worker) || orders != ordersThen;
    });
  } catch (...) {
    thrown = std::current_exception();
  }
  {
    const std::lock_guard queueGuard(queueLock);
    {
      const std::lock_guard lock(front);
      workedSeconds = seconds();
      workingSince = Clock::now();
      --working;
    }
    try {
      queue.give(*unit);
    } catch (...) {
      if (!thrown) thrown = std::current_exception();
    }
    publish();
  }
  set([] {});
  if (thrown) fail(thrown);
  return true;
}

void LightBake::Parts::fail(const std::exception_ptr& thrown) {
  scene::Error kept = errorOf(thrown);
  set([&] {
    if (!error) error = std::move(kept);
  });
}

void LightBake::Parts::work(int worker, const std::stop_token& stop) noexcept {
  if (background) runInBackground();
  UnitRunner runner(*lattice, *estimator);
  while (!stop.stop_requested()) {
    std::uint64_t seen = 0;
    std::optional<Clock::time_point> yields;
    {
      const std::lock_guard lock(front);
      seen = signal;
      if (yielding && Clock::now() < yieldsUntil) yields = yieldsUntil;
    }
    bool worked = false;
    try {
      worked = workOnce(worker, runner, stop);
    } catch (...) {
      fail(std::current_exception());
    }
    if (worked) continue;
    std::unique_lock lock(front);
    const auto news = [&] { return signal != seen; };
    if (yields)
      changed.wait_until(lock, stop, *yields, news);
    else
      changed.wait(lock, stop, news);
  }
}

LightBake::LightBake(std::shared_ptr<LightLattice> lattice, std::shared_ptr<const TexelEstimator> estimator,
                     Options options)
    : parts_(std::make_unique<Parts>(std::move(lattice), std::move(estimator), options)) {
  setThreads(options.threads);
}

LightBake::~LightBake() {
  const std::lock_guard lock(parts_->threadsLock);
  for (std::jthread& worker : parts_->workers) worker.request_stop();
}

void LightBake::want(Wish wish, std::vector<WantedBlock> blocks) {
  parts_->set([&] {
    // Swapped: what was there is freed with the lock open.
    auto& waiting = parts_->wishes[static_cast<std::size_t>(wish)];
    if (!waiting) waiting.emplace();
    waiting->swap(blocks);
    ++parts_->orders;
  });
}

void LightBake::setSamples(std::uint32_t samples) {
  parts_->set([&] {
    parts_->samples = samples;
    ++parts_->orders;
  });
}

// Threads that are too many wait; none is ended before the bake.
void LightBake::setThreads(int threads) {
  threads = std::max(threads, 1);
  {
    const std::lock_guard lock(parts_->threadsLock);
    try {
      while (static_cast<int>(parts_->workers.size()) < threads) {
        const auto worker = static_cast<int>(parts_->workers.size());
        parts_->workers.emplace_back(
            [parts = parts_.get(), worker](const std::stop_token& stop) { parts->work(worker, stop); });
      }
    } catch (const std::system_error&) {  // the system gives no more
      threads = std::max(static_cast<int>(parts_->workers.size()), 1);
      if (parts_->workers.empty()) parts_->fail(std::make_exception_ptr(std::bad_alloc()));
    }
  }
  parts_->set([&] { parts_->threads = threads; });
}

void LightBake::setPaused(bool paused) {
  parts_->set([&] { parts_->paused = paused; });
}

void LightBake::yield(bool yielding) {
  parts_->set([&] {
    if (yielding && !parts_->yielding) parts_->yieldsUntil = Clock::now() + kLongestYield;
    parts_->yielding = yielding;
  });
}

BakeCounters LightBake::counters() const {
  BakeCounters counters;
  counters.texelsLit = parts_->lattice->bakedTexels();
  const std::lock_guard lock(parts_->front);
  const BakeQueue::Totals& totals = parts_->totals;
  counters.texelsWanted = totals.wanted;
  counters.texelsDone = totals.done;
  counters.texelsStarted = totals.started;
  counters.samplesWanted = totals.wanted * parts_->samplesWanted;
  counters.samplesDone = totals.samplesDone;
  counters.rays = parts_->rays;
  counters.seconds = parts_->seconds();
  counters.raysPerSecond = parts_->rate.raysPerSecond();
  const double pathsPerSecond = parts_->rate.pathsPerSecond();
  if (pathsPerSecond > 0.0)
    counters.secondsLeft =
        static_cast<double>(counters.samplesWanted - counters.samplesDone) / pathsPerSecond;
  counters.threads = parts_->threads;
  counters.paused = parts_->paused;
  counters.idle = parts_->queueIdle && !parts_->ordersWait();
  return counters;
}

bool LightBake::waitFor(std::uint32_t samples, double timeoutSeconds) const {
  using Seconds = std::chrono::duration<double>;
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           Seconds(std::clamp(timeoutSeconds, 0.0, 1e8)));
  BakeQueue::Cursor cursor;
  for (;;) {
    std::uint64_t seen = 0;
    bool failed = false;
    {
      const std::lock_guard lock(parts_->front);
      seen = parts_->signal;
      failed = parts_->error.has_value();
    }
    if (failed) return false;
    {
      const std::lock_guard lock(parts_->queueLock);
      parts_->takeOrders();
      parts_->publish();
      if (parts_->queue.fulfilled(samples, cursor)) return true;
    }
    std::unique_lock lock(parts_->front);
    if (!parts_->changed.wait_until(lock, deadline, [&] { return parts_->signal != seen; })) return false;
  }
}

std::optional<scene::Error> LightBake::error() const {
  const std::lock_guard lock(parts_->front);
  return parts_->error;
}

const std::shared_ptr<LightLattice>& LightBake::lattice() const {
  return parts_->lattice;
}

}  // namespace isolux::gi
