// Where the work of one volume is done: a thread of its own, so that an OpenGL context stays on one thread
// and whoever waits can be interrupted.
//
// Python's lock is not held while the work runs. The thread that waits takes it back every few milliseconds
// to look for signals and to tell how far the work is.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>

#include <pybind11/pybind11.h>
#include <sys/types.h>

#include "base/destroy_in_background.h"
#include "base/progress.h"

namespace isolux::python {

// Python ends, on this thread: others that wait for work do not come back, because there is nothing to come
// back to.
void endPython();

using Work = std::function<void(base::Progress&)>;

class VolumeThread {
 public:
  // `leave` is called on the desk's thread when the desk is given up.
  explicit VolumeThread(std::function<void()> leave);
  ~VolumeThread();  // stops what is under way; does not wait for it
  // Python ends: every desk stops what it is at, whoever still holds it; base::awaitDestroyed() waits for
  // their threads.
  static void stopAll();
  VolumeThread(const VolumeThread&) = delete;
  VolumeThread& operator=(const VolumeThread&) = delete;

  // Runs `work` after what others have asked for, and waits. `told`: called with (fraction, stage) now and
  // then, or None. Throws what the work throws, and pybind11::error_already_set where a signal or `told`
  // raises: then the work is stopped, and waited for a moment only. With Python's lock held.
  void run(Work work, const pybind11::object& told);
  // As run(); returns what `question` returns, which both keep: an interrupted caller is gone before it ends.
  template <class Question>
  auto answer(Question question, const pybind11::object& told) {
    const auto kept = std::make_shared<decltype(question(std::declval<base::Progress&>()))>();
    run([kept, question = std::move(question)](base::Progress& progress) { *kept = question(progress); },
        told);
    return std::move(*kept);
  }

 private:
  struct Job;
  struct Jobs {
    std::mutex mutex;
    std::condition_variable changed;
    std::deque<std::shared_ptr<Job>> waiting;
    std::shared_ptr<Job> running;
    bool leaving = false;
    bool refused = false;  // by the system: there is no thread
    std::function<void()> leave;
  };
  static void work(Jobs& jobs);
  void destroyInBackground();
  void requireOwnProcess() const;

  pid_t process_;
  std::unique_ptr<base::BackgroundThread<Jobs>> thread_;  // null once Python ends
};

}  // namespace isolux::python
