// Runs a function on a background thread and keeps what it returns, or the Error that ended it.
//
// The owner never waits: it polls finished(), or is notified. Destroying a task requests its work to stop;
// the thread and its data end in the background (base/destroy_in_background.h).
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

#include "base/caught_error.h"
#include "base/destroy_in_background.h"
#include "base/error.h"
#include "base/progress.h"

namespace isolux::base {

// Names the work in messages: "FILE: cannot DOES: REASON". `file` may be empty.
struct TaskName {
  std::string file, does;
};

// `Value`: what the work returns; may be void. `News`: what it finds before its end; empty at first.
template <class Value, class News = std::monostate>
class Task {
 public:
  // Starts work(progress), or work(progress, tell). The work calls tell(change) to have change(News&) called
  // while the owner cannot take the news.
  template <class Work>
  static std::unique_ptr<Task> start(TaskName name, Work work) {
    return std::unique_ptr<Task>(new Task(std::move(name), std::move(work)));
  }
  ~Task() { shared_->progress.requestStop(); }
  Task(const Task&) = delete;
  Task& operator=(const Task&) = delete;

  Progress& progress() { return shared_->progress; }
  bool finished() const { return shared_->finished.load(std::memory_order_acquire); }
  // After finished(): what ended the work, if it has no value.
  const std::optional<Error>& error() const { return shared_->error; }
  auto& value() { return *shared_->value; }
  // Returns the news since the last call. To miss none, call it after finished() once more.
  News take() {
    const std::lock_guard lock(shared_->mutex);
    return std::exchange(shared_->news, {});
  }
  // Has `notify` called on the task's thread when there is news and when it has finished; in this call, too.
  // It may be called after the task is destroyed.
  void setNotify(std::function<void()> notify) {
    const std::lock_guard lock(shared_->mutex);
    shared_->notify = std::move(notify);
    shared_->notify();
  }

 private:
  struct Shared;
  template <class Work>
  Task(TaskName name, Work work)
      : shared_(std::make_shared<Shared>(), [name = std::move(name), work = std::move(work)](Shared& shared) {
          shared.error = caughtError(name.file, name.does, [&] { shared.call(work); });
          shared.finished.store(true, std::memory_order_release);
          shared.tell([](News&) {});
        }) {}

  struct Shared {
    Progress progress;
    std::atomic<bool> finished{false};
    std::optional<std::conditional_t<std::is_void_v<Value>, std::monostate, Value>> value;
    std::optional<Error> error;
    std::mutex mutex;
    News news{};                   // guarded by `mutex`
    std::function<void()> notify;  // guarded by `mutex`

    template <class Change>
    void tell(const Change& change) {
      const std::lock_guard lock(mutex);
      change(news);
      if (notify) notify();
    }
    template <class Work>
    void call(const Work& work) {
      const auto result = [&] {
        if constexpr (std::is_invocable_v<const Work&, Progress&>)
          return work(progress);
        else
          return work(progress, [this](const auto& change) { tell(change); });
      };
      if constexpr (std::is_void_v<Value>)
        result();
      else
        value = result();
    }
  };

  BackgroundThread<Shared> shared_;
};

}  // namespace isolux::base
