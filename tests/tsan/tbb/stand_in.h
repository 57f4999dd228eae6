// The part of oneTBB that Isolux uses, made of plain threads: for builds with ThreadSanitizer only.
//
// Debian's oneTBB is not built for ThreadSanitizer, which therefore does not see how work is handed from
// thread to thread, and reports every use of it; suppressing those reports would hide races of our own as
// well. Here every hand-over is a thread's start and end, which it knows. Ranges are cut into more pieces
// than there are threads, and pieces go to whichever thread comes first, so that bodies meet as they do in
// oneTBB. Calls inside a body run on its own thread.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <iterator>
#include <list>
#include <mutex>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace tbb {

class split {};

template <class Value>
class blocked_range {
 public:
  using size_type = std::size_t;
  blocked_range(Value begin, Value end, size_type grain = 1) : begin_(begin), end_(end), grain_(grain) {}
  Value begin() const { return begin_; }
  Value end() const { return end_; }
  size_type size() const { return static_cast<size_type>(end_ - begin_); }
  size_type grainsize() const { return grain_; }
  bool empty() const { return !(begin_ < end_); }

 private:
  Value begin_, end_;
  size_type grain_;
};

class global_control {
 public:
  enum parameter { max_allowed_parallelism };
  global_control(parameter, std::size_t threads)
      : before_(limit().exchange(std::max<std::size_t>(threads, 1))) {}
  ~global_control() { limit() = before_; }
  global_control(const global_control&) = delete;
  global_control& operator=(const global_control&) = delete;
  static std::size_t active_value(parameter) { return limit(); }

 private:
  static std::atomic<std::size_t>& limit() {
    static std::atomic<std::size_t> threads{
        4};  // also where there are fewer cores: threads that never meet never race
    return threads;
  }
  std::size_t before_;
};

namespace info {
inline int default_concurrency() {
  return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}
}  // namespace info

namespace stand_in {

inline thread_local bool inBody = false;

// Calls piece(i) for 0 .. count - 1; the first exception is thrown here.
template <class Piece>
void forEachPiece(std::size_t count, const Piece& piece) {
  const std::size_t threads =
      std::min(count, global_control::active_value(global_control::max_allowed_parallelism));
  if (inBody || threads <= 1) {
    for (std::size_t i = 0; i < count; ++i) piece(i);
    return;
  }
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    const bool before = std::exchange(inBody, true);
    try {
      for (std::size_t i; (i = next++) < count;) piece(i);
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
      next = count;
    }
    inBody = before;
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < threads; ++i) others.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

template <class Value>
std::vector<blocked_range<Value>> pieces(const blocked_range<Value>& range) {
  constexpr std::size_t mostPieces = 32;
  const std::size_t size = range.empty() ? 0 : range.size();
  const std::size_t step =
      std::max({range.grainsize(), (size + mostPieces - 1) / mostPieces, std::size_t{1}});
  std::vector<blocked_range<Value>> all;
  for (std::size_t from = 0; from < size; from += step)
    all.emplace_back(static_cast<Value>(range.begin() + static_cast<Value>(from)),
                     static_cast<Value>(range.begin() + static_cast<Value>(std::min(from + step, size))),
                     range.grainsize());
  return all;
}

}  // namespace stand_in

template <class Value, class Body>
void parallel_for(const blocked_range<Value>& range, const Body& body) {
  const auto all = stand_in::pieces(range);
  stand_in::forEachPiece(all.size(), [&](std::size_t i) { body(all[i]); });
}

template <class Value, class Result, class Body, class Join>
Result parallel_deterministic_reduce(const blocked_range<Value>& range, const Result& identity,
                                     const Body& body, const Join& join) {
  const auto all = stand_in::pieces(range);
  std::vector<Result> results(all.size(), identity);
  stand_in::forEachPiece(all.size(), [&](std::size_t i) { results[i] = body(all[i], identity); });
  Result sum = identity;
  for (const Result& result : results) sum = join(sum, result);
  return sum;
}

template <class Value, class Result, class Body, class Join>
Result parallel_reduce(const blocked_range<Value>& range, const Result& identity, const Body& body,
                       const Join& join) {
  return parallel_deterministic_reduce(range, identity, body, join);
}

template <class Iterator, class Less = std::less<>>
void parallel_sort(Iterator begin, Iterator end, const Less& less = {}) {
  std::sort(begin, end, less);
}

template <class... Bodies>
void parallel_invoke(const Bodies&... bodies) {
  const std::vector<std::function<void()>> all{std::function<void()>(std::cref(bodies))...};
  stand_in::forEachPiece(all.size(), [&](std::size_t i) { all[i](); });
}

// A value for each thread that asks.
template <class Value>
class enumerable_thread_specific {
 public:
  enumerable_thread_specific() : make_([] { return Value(); }) {}
  template <class Make, class = std::enable_if_t<std::is_invocable_r_v<Value, Make>>>
  explicit enumerable_thread_specific(Make make) : make_(std::move(make)) {}
  explicit enumerable_thread_specific(const Value& value) : make_([value] { return value; }) {}

  Value& local() {
    const std::lock_guard lock(mutex_);
    const std::thread::id self = std::this_thread::get_id();
    for (auto& entry : entries_)
      if (entry.first == self) return entry.second;
    return entries_.emplace_back(self, make_()).second;
  }
  template <class Function>
  void combine_each(const Function& function) {
    for (auto& entry : entries_) function(entry.second);
  }
  template <class Join>
  Value combine(const Join& join) {
    if (entries_.empty()) return make_();
    Value sum = entries_.front().second;
    for (auto entry = std::next(entries_.begin()); entry != entries_.end(); ++entry)
      sum = join(sum, entry->second);
    return sum;
  }

 private:
  std::function<Value()> make_;
  std::mutex mutex_;
  std::list<std::pair<std::thread::id, Value>> entries_;
};
template <class Value>
using combinable = enumerable_thread_specific<Value>;

class task_arena {
 public:
  explicit task_arena(int threads = -1) : threads_(threads) {}
  template <class Function>
  auto execute(const Function& function) -> decltype(function()) {
    if (threads_ > 1 || threads_ < 0) return function();
    struct Alone {
      bool before = std::exchange(stand_in::inBody, true);
      ~Alone() { stand_in::inBody = before; }
    } const alone;
    return function();
  }

 private:
  int threads_;
};

namespace this_task_arena {
inline int max_concurrency() {
  return static_cast<int>(global_control::active_value(global_control::max_allowed_parallelism));
}
template <class Function>
auto isolate(const Function& function) -> decltype(function()) {
  return function();
}
}  // namespace this_task_arena

}  // namespace tbb
