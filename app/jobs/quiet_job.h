// One piece of work on a background thread that gives way to the user, with whatever renderer it makes; its
// owner polls, and stops it when the user needs the machine.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <utility>

#include "app/jobs/give_way.h"
#include "app/process/caught_error.h"
#include "base/error.h"
#include "base/progress.h"
#include "base/retire.h"

namespace isolux::app {

// `Work` is made of a Subject (`Work{subject}`), holds what it finds, and has
//   void run(base::Progress&), on the thread, which may throw base::Error,
//   static constexpr const char* kDoes: "measure accuracy", for a message;
// where somebody waits for it, static constexpr bool kIsAwaited = true: it gives way to nobody.
template <class Work>
class QuietJob {
 public:
  using Subject = typename Work::Subject;
  // Starts at once.
  explicit QuietJob(Subject subject) : shared_(std::make_shared<Shared>(std::move(subject)), run) {}
  ~QuietJob() { shared_->progress.requestStop(); }  // the thread ends elsewhere
  QuietJob(const QuietJob&) = delete;
  QuietJob& operator=(const QuietJob&) = delete;

  bool finished() const { return shared_->finished.load(std::memory_order_acquire); }
  const base::Progress& progress() const { return shared_->progress; }
  const std::optional<base::Error>& error() const { return shared_->error; }  // after finished()

 protected:
  Work& work() { return shared_->work; }
  const Work& work() const { return shared_->work; }

 private:
  struct Shared {
    explicit Shared(Subject subject) : work{std::move(subject)} {}
    Work work;
    base::Progress progress;
    std::atomic<bool> finished{false};
    std::optional<base::Error> error;
  };
  static void run(Shared& shared) {
    if constexpr (!requires { Work::kIsAwaited; }) giveWay();
    shared.error = caughtError("", Work::kDoes, [&] { shared.work.run(shared.progress); });
    shared.finished.store(true, std::memory_order_release);
  }

  base::RetiringThread<Shared> shared_;
};

}  // namespace isolux::app
