// Brings what background tasks report to the window's thread, which therefore need not poll them.
#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <variant>

#include <QTimer>

#include "base/task.h"

namespace isolux::ui {

// Returns a function that any thread may call, at any time: `call` then runs soon on the window's thread, if
// `receiver` still exists. Requires to be called on the window's thread.
std::function<void()> posted(QObject* receiver, std::function<void()> call);

// From now on `timer` calls the slot once, so long after it was last started.
template <class Receiver, class Slot>
void callOnce(QTimer& timer, int milliseconds, Receiver* receiver, Slot slot) {
  timer.setSingleShot(true);
  timer.setInterval(milliseconds);
  timer.callOnTimeout(receiver, slot);
}

// The task at work for an object of the window's thread. Null when there is none.
template <class Value, class News = std::monostate>
class BackgroundTask {
 public:
  using Task = base::Task<Value, News>;

  BackgroundTask() {
    timer_.callOnTimeout([this] { look(); });
  }

  // Watches `task` instead of the one before. ended(task) is called after it has finished, when this is null
  // again. Until then, progressed() is called often and when there is news. Nothing is called after reset().
  void watch(std::unique_ptr<Task> task, std::function<void(Task&)> ended,
             std::function<void()> progressed = {}) {
    reset();
    task_ = std::move(task);
    ended_ = std::move(ended);
    progressed_ = std::move(progressed);
    if (progressed_) timer_.start(kProgressMilliseconds);
    task_->setNotify(posted(&timer_, [this, number = number_] {
      if (number == number_) look();
    }));
  }
  // Stops the task, which ends in the background.
  void reset() {
    ++number_;
    timer_.stop();
    task_.reset();
  }

  explicit operator bool() const { return task_ != nullptr; }
  Task* operator->() const { return task_.get(); }
  Task& operator*() const { return *task_; }

 private:
  static constexpr int kProgressMilliseconds = 50;

  void look() {
    if (task_->finished()) {
      const std::function<void(Task&)> ended = std::move(ended_);
      const std::unique_ptr<Task> task = std::move(task_);
      reset();
      ended(*task);
    } else if (progressed_) {
      const std::function<void()> progressed = progressed_;  // which may watch another task
      progressed();
    }
  }

  std::unique_ptr<Task> task_;
  std::function<void(Task&)> ended_;
  std::function<void()> progressed_;
  QTimer timer_;
  int number_ = 0;  // of the task; what is posted for those before is ignored
};

}  // namespace isolux::ui
