#include "python/volume_thread.h"

#include <atomic>
#include <chrono>
#include <exception>
#include <future>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <unistd.h>

namespace isolux::python {

namespace py = pybind11;
using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

namespace {

constexpr milliseconds kSignals{10};   // how often the one who waits looks for signals
constexpr milliseconds kTold{50};      // how often it tells how far the work is
constexpr milliseconds kStopping{60};  // how long work that is stopped is waited for

std::atomic<bool> isEnding{false};
std::thread::id endingThread;

// All that are alive, each with its process: a fork has those of the other, too, whose threads it lacks.
struct Desks {
  std::mutex mutex;
  std::vector<std::pair<VolumeThread*, pid_t>> alive;
};
Desks& desks() {
  static auto* const all = new Desks;  // for good: desks outlive static objects
  return *all;
}

// A daemon thread that took the lock of a Python that ends would be ended in the middle of our functions.
void parkIfEnding() {
  if (!isEnding.load() || std::this_thread::get_id() == endingThread) return;
  while (true) std::this_thread::sleep_for(std::chrono::hours(1));
}

}  // namespace

void endPython() {
  endingThread = std::this_thread::get_id();
  isEnding.store(true);
  VolumeThread::stopAll();
}

struct VolumeThread::Job {
  Work work;
  base::Progress progress;
  std::promise<void> promise{};
  std::future<void> end = promise.get_future();

  bool waitFor(milliseconds time) { return end.wait_for(time) == std::future_status::ready; }
  void run() {
    std::exception_ptr failure;
    try {
      progress.throwIfStopped();
      work(progress);
    } catch (...) {
      failure = std::current_exception();
    }
    work = nullptr;  // whose captures the caller may be waiting to see gone
    if (failure)
      promise.set_exception(std::move(failure));
    else
      promise.set_value();
  }
};

VolumeThread::VolumeThread(std::function<void()> leave) : process_(::getpid()) {
  auto jobs = std::make_shared<Jobs>();
  jobs->leave = std::move(leave);
  thread_ =
      std::make_unique<base::BackgroundThread<Jobs>>(jobs, [here = std::this_thread::get_id()](Jobs& own) {
        if (std::this_thread::get_id() == here)
          own.refused = true;
        else
          work(own);
      });
  if (jobs->refused) throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
  const std::lock_guard lock(desks().mutex);
  desks().alive.emplace_back(this, process_);
}

VolumeThread::~VolumeThread() {
  if (::getpid() != process_) {  // the thread stayed in the process that was forked
    static_cast<void>(thread_.release());
    return;
  }
  const std::lock_guard lock(desks().mutex);
  std::erase(desks().alive, std::pair(this, process_));
  destroyInBackground();
}

// With the lock of all desks.
void VolumeThread::destroyInBackground() {
  if (!thread_) return;
  {
    const std::lock_guard lock((*thread_)->mutex);
    (*thread_)->leaving = true;
    if ((*thread_)->running) (*thread_)->running->progress.requestStop();
    for (const std::shared_ptr<Job>& job : (*thread_)->waiting) job->progress.requestStop();
  }
  (*thread_)->changed.notify_all();
  thread_.reset();
}

void VolumeThread::stopAll() {
  const std::lock_guard lock(desks().mutex);
  for (const auto& [desk, process] : desks().alive)
    if (process == ::getpid()) desk->destroyInBackground();
}

void VolumeThread::work(Jobs& jobs) {
  std::unique_lock lock(jobs.mutex);
  while (true) {
    jobs.changed.wait(lock, [&] { return jobs.leaving || !jobs.waiting.empty(); });
    if (jobs.waiting.empty()) break;
    jobs.running = std::move(jobs.waiting.front());
    jobs.waiting.pop_front();
    const std::shared_ptr<Job> job = jobs.running;
    lock.unlock();
    job->run();
    lock.lock();
    jobs.running.reset();
  }
  lock.unlock();
  jobs.leave();
}

void VolumeThread::requireOwnProcess() const {
  if (::getpid() != process_)
    throw std::runtime_error(
        "a volume does not outlive fork(): open it in the new process, or start that by \"spawn\"");
}

void VolumeThread::run(Work work, const py::object& told) {
  requireOwnProcess();
  const auto job = std::make_shared<Job>();
  job->work = std::move(work);
  {
    const py::gil_scoped_release released;
    parkIfEnding();
    {
      const std::lock_guard lock(desks().mutex);
      if (!thread_) throw std::runtime_error("Python ends");
      const std::lock_guard own((*thread_)->mutex);
      (*thread_)->waiting.push_back(job);
      (*thread_)->changed.notify_all();
    }
    Clock::time_point last = Clock::now();
    while (!job->waitFor(kSignals)) {
      parkIfEnding();
      const py::gil_scoped_acquire acquired;
      bool raised = ::PyErr_CheckSignals() != 0;
      if (!raised && !told.is_none() && Clock::now() - last >= kTold) {
        last = Clock::now();
        PyObject* const answer =
            ::PyObject_CallFunction(told.ptr(), "ds", job->progress.fraction(), job->progress.stage());
        raised = answer == nullptr;
        Py_XDECREF(answer);
      }
      if (!raised) continue;
      job->progress.requestStop();
      py::error_already_set error;  // takes what was raised
      {
        const py::gil_scoped_release again;
        job->waitFor(kStopping);
      }
      throw error;
    }
    parkIfEnding();
  }
  job->end.get();
}

}  // namespace isolux::python
