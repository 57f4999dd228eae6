#include "gi/bake/light_bake.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <stop_token>
#include <system_error>
#include <thread>
#include <utility>

#include "base/error.h"
#include "base/mailbox.h"
#include "gi/bake/bake_queue.h"
#include "gi/bake/bake_unit.h"

#ifdef __linux__
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace isolux::gi {

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kLongestYield = std::chrono::milliseconds(250);
constexpr auto kYieldStep =
    std::chrono::milliseconds(2);  // how often a thread that yields looks whether to go on

// A tenth of what an ordinary thread gets: a window stays fluent, and yet a stop is seen within some 40 ms
// beside a busy process on the same core. At nice 19 that takes 200 ms, in SCHED_IDLE seconds. SCHED_BATCH:
// waking up interrupts nobody. A thread that may not change its priority keeps it: the bake is then only less
// polite.
void runInBackground() {
#ifdef __linux__
  constexpr int kNice = 10;
  const sched_param none{};
  sched_setscheduler(0, SCHED_BATCH, &none);
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNice);
#endif
}

}  // namespace

// The speed of a bake over its last two seconds of work.
class BakeRate {
 public:
  // Records the totals at `seconds` of work (without pauses). Cheap: most calls only compare the time.
  void note(double seconds, std::uint64_t rays, std::uint64_t paths) {
    last_ = {seconds, rays, paths};
    if (seconds < marks_.back().seconds + kStep) return;
    marks_.push_back(last_);
    while (marks_.size() > 2 && marks_[1].seconds <= seconds - kWindow) marks_.pop_front();
  }
  double raysPerSecond() const { return per(last_.rays - marks_.front().rays); }
  double pathsPerSecond() const { return per(last_.paths - marks_.front().paths); }

 private:
  static constexpr double kWindow = 2.0, kStep = 0.1;  // seconds
  struct Mark {
    double seconds = 0.0;
    std::uint64_t rays = 0, paths = 0;
  };
  double per(std::uint64_t count) const {
    const double seconds = last_.seconds - marks_.front().seconds;
    return seconds > 0.0 ? static_cast<double>(count) / seconds : 0.0;
  }

  std::deque<Mark> marks_{{}};  // never empty; the first is the last one older than the window
  Mark last_;
};

// Three sides. Owners (the window's thread) and workers share atomics and mailboxes only, so that an owner
// never waits for a worker that the system has put aside. Workers and waitFor() share the queue and the
// tally, each with its lock; `queueLock` is locked first where both are. Owners among themselves share
// `asking` and `threadsLock`.
struct LightBake::Parts {
  // What is asked for, and by which thread count.
  std::array<base::Mailbox<std::vector<BlockRequest>>, 4> requests;  // not yet in the queue
  std::atomic<std::uint32_t> samples{0};                             // not yet in the queue; 0: none
  std::atomic<std::uint64_t> orders{0};  // counts want() and setSamples(), after each
  std::atomic<int> threads{1};
  std::atomic<bool> paused{false}, yielding{false};
  std::atomic<Clock::rep> yieldsUntil{0};
  std::atomic<std::uint32_t> signal{0};  // rises with all that a waiting thread may want to know

  // What is told.
  struct Report {
    BakeCounters counters;           // all but texelsLit, threads, paused
    std::uint64_t orders = 0;        // that are in the queue
    int working = 0;                 // threads
    Clock::time_point workingSince;  // of counters.seconds
    double pathsPerSecond = 0.0;
  };
  base::Mailbox<Report> report;
  // Reports that the owner has read, for the next ones: whoever frees what another thread has allocated may
  // wait for the allocator's lock.
  base::Mailbox<Report> spent;
  std::atomic<bool> failed{false};
  std::exception_ptr firstFailure;  // not written any more once `failure` points to it
  std::atomic<const std::exception_ptr*> failure{nullptr};
  std::mutex asking;
  Report lastReport;  // guarded by `asking`

  std::shared_ptr<LightLattice> lattice;
  std::shared_ptr<const TexelEstimator> estimator;
  bool background = false;

  std::mutex queueLock;
  BakeQueue queue;
  std::uint64_t ordersTaken = 0;

  std::mutex tallyLock;
  Report tally;
  std::uint64_t paths = 0;
  BakeRate rate;

  std::mutex finishedLock;  // of waitFor() and the workers that wake it
  std::condition_variable finished;

  std::mutex threadsLock;
  std::vector<std::jthread> workers;  // the last member: they end before the rest goes

  Parts(std::shared_ptr<LightLattice> l, std::shared_ptr<const TexelEstimator> e, const Options& options)
      : lattice(std::move(l)),
        estimator(std::move(e)),
        background(options.background),
        queue(*lattice, options.samples) {
    tally.counters.samplesWanted = queue.samples();
    lastReport = tally;
  }
  ~Parts() {
    requestStop();
    workers.clear();
  }

  void wake() {
    signal.fetch_add(1, std::memory_order_acq_rel);
    signal.notify_all();
  }
  void requestStop() {
    {
      const std::lock_guard lock(threadsLock);
      for (std::jthread& worker : workers) worker.request_stop();
    }
    wake();
  }

  bool yields() const { return yielding && Clock::now().time_since_epoch().count() < yieldsUntil; }
  bool mustWait(int worker) const { return paused || failure.load() || worker >= threads || yields(); }

  // With `queueLock` locked.
  void takeOrders();
  void tellQueue();
  // With `tallyLock` locked.
  double secondsWorked() const;
  void tell() {
    std::unique_ptr<Report> next = spent.take();
    if (!next) next = std::make_unique<Report>();
    *next = tally;
    report.put(std::move(next));
  }

  void begin();
  void note(std::uint64_t rays, std::uint64_t morePaths);
  void end();
  void work(int worker, const std::stop_token& stop) noexcept;
  bool workOnce(int worker, UnitRunner& runner, const std::stop_token& stop);
  // With `threadsLock` locked. Returns how many are left.
  int leaveThreadsToOthers();
  void wakeWaiters();
  void fail(std::exception_ptr thrown) noexcept;
};

void LightBake::Parts::takeOrders() {
  ordersTaken = orders.load(std::memory_order_acquire);
  if (const std::uint32_t wanted = samples.exchange(0)) queue.setSamples(wanted);
  for (std::size_t w = 0; w < requests.size(); ++w)
    if (const auto request = requests[w].take()) queue.want(static_cast<Priority>(w), std::move(*request));
}

void LightBake::Parts::tellQueue() {
  const BakeQueue::Totals& totals = queue.totals();
  const std::lock_guard lock(tallyLock);
  BakeCounters& counters = tally.counters;
  counters.texelsWanted = totals.wanted;
  counters.texelsDone = totals.done;
  counters.texelsStarted = totals.started;
  counters.samplesWanted = totals.wanted * queue.samples();
  counters.samplesDone = totals.samplesDone;
  counters.texelsSeen = totals.seen;
  counters.texelsSmooth = totals.smooth;
  counters.idle = queue.idle();
  tally.orders = ordersTaken;
  tell();
}

double LightBake::Parts::secondsWorked() const {
  const std::chrono::duration<double> now = Clock::now() - tally.workingSince;
  return tally.counters.seconds + (tally.working > 0 ? now.count() : 0.0);
}

void LightBake::Parts::begin() {
  const std::lock_guard lock(tallyLock);
  if (tally.working++ == 0) tally.workingSince = Clock::now();
}

void LightBake::Parts::note(std::uint64_t rays, std::uint64_t morePaths) {
  const std::lock_guard lock(tallyLock);
  tally.counters.rays += rays;
  paths += morePaths;
  rate.note(secondsWorked(), tally.counters.rays, paths);
  tally.counters.raysPerSecond = rate.raysPerSecond();
  tally.pathsPerSecond = rate.pathsPerSecond();
  tell();
}

void LightBake::Parts::end() {
  const std::lock_guard lock(tallyLock);
  tally.counters.seconds = secondsWorked();
  tally.workingSince = Clock::now();
  --tally.working;
}

// Takes one unit and works on it; false: there is nothing to do, or the thread must wait.
bool LightBake::Parts::workOnce(int worker, UnitRunner& runner, const std::stop_token& stop) {
  std::optional<BakeQueue::Unit> unit;
  std::uint64_t ordersThen = 0;
  {
    const std::lock_guard queueGuard(queueLock);
    takeOrders();
    ordersThen = ordersTaken;
    if (!mustWait(worker)) unit = queue.take();
    tellQueue();
  }
  if (!unit) return false;
  begin();
  std::exception_ptr thrown;
  try {
    runner.run(*unit, stop, [&](std::uint64_t rays, std::uint64_t morePaths) {
      note(rays, morePaths);
      return stop.stop_requested() || mustWait(worker) || orders != ordersThen;
    });
  } catch (...) {
    thrown = std::current_exception();
  }
  end();
  {
    const std::lock_guard queueGuard(queueLock);
    try {
      queue.give(*unit);
    } catch (...) {
      if (!thrown) thrown = std::current_exception();
    }
    tellQueue();
  }
  if (thrown) fail(thrown);
  wake();  // threads for which nothing but this block was left, and waitFor()
  return true;
}

// The system has no more threads: some end again, because libraries that find none when they want one end the
// process.
int LightBake::Parts::leaveThreadsToOthers() {
  constexpr std::size_t left = 4;
  const std::size_t kept =
      workers.size() > left ? workers.size() - left : std::min<std::size_t>(workers.size(), 1);
  for (std::size_t i = kept; i < workers.size(); ++i) workers[i].request_stop();
  wake();
  workers.resize(kept);  // joins: a worker ends after a call of 8 ms
  return static_cast<int>(kept);
}

void LightBake::Parts::wakeWaiters() {
  const std::lock_guard lock(finishedLock);
  finished.notify_all();
}

void LightBake::Parts::fail(std::exception_ptr thrown) noexcept {
  if (!failed.exchange(true)) {
    firstFailure = std::move(thrown);
    failure.store(&firstFailure, std::memory_order_release);
  }
  wake();
  wakeWaiters();
}

void LightBake::Parts::work(int worker, const std::stop_token& stop) noexcept {
  if (background) runInBackground();
  UnitRunner runner(*lattice, *estimator);
  while (!stop.stop_requested()) {
    const std::uint32_t seen = signal.load(std::memory_order_acquire);
    const bool yielded = yields();
    bool worked = false;
    try {
      worked = workOnce(worker, runner, stop);
    } catch (...) {
      fail(std::current_exception());
    }
    wakeWaiters();
    if (worked || stop.stop_requested()) continue;
    if (yielded)
      std::this_thread::sleep_for(kYieldStep);
    else
      signal.wait(seen, std::memory_order_acquire);
  }
}

LightBake::LightBake(std::shared_ptr<LightLattice> lattice, std::shared_ptr<const TexelEstimator> estimator,
                     Options options)
    : parts_(std::make_unique<Parts>(std::move(lattice), std::move(estimator), options)) {
  setThreads(options.threads);
}

LightBake::~LightBake() = default;

void LightBake::requestStop() {
  parts_->requestStop();
}

void LightBake::want(Priority request, std::vector<BlockRequest> blocks) {
  const auto w = static_cast<std::size_t>(request);
  parts_->requests[w].put(std::make_unique<std::vector<BlockRequest>>(std::move(blocks)));
  parts_->orders.fetch_add(1, std::memory_order_acq_rel);
  parts_->wake();
}

void LightBake::setSamples(std::uint32_t samples) {
  parts_->samples = std::max(samples, 1u);
  parts_->orders.fetch_add(1, std::memory_order_acq_rel);
  parts_->wake();
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
      threads = parts_->leaveThreadsToOthers();
      if (threads == 0)
        parts_->fail(std::make_exception_ptr(
            base::Error(base::ErrorKind::memory, "", "light",
                        "cannot create a thread; raise the process limit (ulimit -u)")));
    }
  }
  parts_->threads = std::max(threads, 1);
  parts_->wake();
}

void LightBake::setPaused(bool paused) {
  parts_->paused = paused;
  parts_->wake();
}

void LightBake::yield(bool yielding) {
  if (yielding && !parts_->yielding)
    parts_->yieldsUntil = (Clock::now() + kLongestYield).time_since_epoch().count();
  parts_->yielding = yielding;
  parts_->wake();
}

BakeCounters LightBake::counters() const {
  Parts& parts = *parts_;
  // Before the report, so that what is missing there is missed.
  const std::uint64_t orders = parts.orders.load(std::memory_order_acquire);
  const std::lock_guard lock(parts.asking);
  if (auto news = parts.report.take()) {
    parts.lastReport = *news;
    parts.spent.put(std::move(news));
  }
  const Parts::Report& report = parts.lastReport;
  BakeCounters counters = report.counters;
  counters.texelsLit = parts.lattice->bakedTexels();
  if (report.working > 0) {
    const std::chrono::duration<double> now = Clock::now() - report.workingSince;
    counters.seconds += now.count();
  }
  if (report.pathsPerSecond > 0.0)
    counters.secondsLeft =
        static_cast<double>(counters.samplesWanted - counters.samplesDone) / report.pathsPerSecond;
  counters.threads = parts.threads;
  counters.paused = parts.paused;
  counters.takenIn = report.orders == orders;
  counters.idle = counters.idle && counters.takenIn;
  return counters;
}

bool LightBake::waitFor(std::uint32_t samples, double timeoutSeconds) const {
  using Seconds = std::chrono::duration<double>;
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           Seconds(std::clamp(timeoutSeconds, 0.0, 1e8)));
  BakeQueue::Cursor cursor;
  for (;;) {
    const std::uint32_t seen = parts_->signal.load(std::memory_order_acquire);
    if (parts_->failure.load()) return false;
    {
      const std::lock_guard lock(parts_->queueLock);
      parts_->takeOrders();
      parts_->tellQueue();
      if (parts_->queue.fulfilled(samples, cursor)) return true;
    }
    std::unique_lock lock(parts_->finishedLock);
    if (!parts_->finished.wait_until(lock, deadline, [&] { return parts_->signal != seen; })) return false;
  }
}

std::exception_ptr LightBake::failure() const {
  const std::exception_ptr* const failure = parts_->failure.load(std::memory_order_acquire);
  return failure ? *failure : nullptr;
}

const std::shared_ptr<LightLattice>& LightBake::lattice() const {
  return parts_->lattice;
}

}  // namespace isolux::gi
