// How much memory the program may hold, and how much it holds: asked before anything large is allocated, so
// that what does not fit is refused with a line that says the sum, and nobody is ended by the system.
//
// A value of the machine, not of the Scene. What is counted is what grows with the data: voxels, tables of
// the tracer, coefficients, distance fields, stored light, pictures. Small things are what the reserve is
// for, that allowedMemory() leaves. Bytes everywhere. All members are safe from any thread.
//
//   const MemoryBudget::Held held = machineMemory().reserve(bytes, "the tables of the tracer",
//   "--memory-budget raises the budget");
#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/error.h"

namespace isolux::base {

class MemoryBudget {
 public:
  // `systemLeft`, where given, says what the system has left now; it is asked with every 64 MiB, because
  // others take memory, too.
  explicit MemoryBudget(std::size_t limit, std::size_t (*systemLeft)() = nullptr)
      : limit_(limit), systemLeft_(systemLeft) {}
  MemoryBudget(const MemoryBudget&) = delete;
  MemoryBudget& operator=(const MemoryBudget&) = delete;

  // Bytes that are held as long as this lives, kept beside what they are of. A copy holds as many again,
  // without asking, as the copy of the data does. The budget must outlive it.
  class Held {
   public:
    Held() = default;
    ~Held() { release(); }
    Held(const Held& other) : Held(other.budget_, other.bytes_) {}
    Held(Held&& other) noexcept
        : budget_(std::exchange(other.budget_, nullptr)), bytes_(std::exchange(other.bytes_, 0)) {}
    Held& operator=(Held other) noexcept {
      std::swap(budget_, other.budget_);
      std::swap(bytes_, other.bytes_);
      return *this;
    }
    std::size_t bytes() const noexcept { return bytes_; }
    void release() noexcept;
    // Holds what `other` held, too; both are of one budget.
    void add(Held other) noexcept;
    // Gives back what is above `bytes`.
    void shrinkTo(std::size_t bytes) noexcept;

   private:
    friend class MemoryBudget;
    Held(MemoryBudget* budget, std::size_t bytes) noexcept;  // counts
    MemoryBudget* budget_ = nullptr;
    std::size_t bytes_ = 0;
  };

  // `what` needs the memory ("the light of 134217728 texels"); `remedy` is what the user can do about it ("a
  // lower gi.lattice_scale needs less"). Throws Error{memory} and holds nothing where the budget has less
  // left.
  [[nodiscard]] Held reserve(std::size_t bytes, std::string_view what, std::string_view remedy);
  // Nothing where the budget has less left.
  [[nodiscard]] std::optional<Held> tryReserve(std::size_t bytes);
  // As reserve(), but holds nothing: for work whose parts ask again.
  void check(std::size_t bytes, std::string_view what, std::string_view remedy) const;
  // Of memory that is there already: counted, never refused.
  [[nodiscard]] Held count(std::size_t bytes) noexcept { return {this, bytes}; }

  std::size_t limit() const noexcept { return limit_.load(std::memory_order_relaxed); }
  std::size_t held() const noexcept { return held_.load(std::memory_order_relaxed); }
  std::size_t left() const noexcept;
  // What is held already stays, even where it is more.
  void setLimit(std::size_t limit) noexcept { limit_.store(limit, std::memory_order_relaxed); }

  // The error that reserve() throws.
  Error refusal(std::size_t bytes, std::string_view what, std::string_view remedy) const;

 private:
  bool systemHas(std::size_t bytes) const;
  std::atomic<std::size_t> limit_;
  std::size_t (*systemLeft_)();
  std::atomic<std::size_t> held_{0};
};

// The budget of this process: allowedMemory() when it was first asked for, unless set.
MemoryBudget& machineMemory();

// "WHAT would take 42.0 GiB beside the 2.0 GiB that are held, more than the memory budget of 3.0 GiB; REMEDY,
// --memory-budget changes the budget".
std::string overBudgetText(std::size_t bytes, std::size_t held, std::size_t limit, std::string_view what,
                           std::string_view remedy);

// What the system says that this process may still take: the least of the memory that is available, the
// address space (ulimit -v) and the control groups it is in.
std::size_t systemMemoryLeft();
// The same less a reserve for all that is not counted: an eighth, 64 MiB to 1 GiB.
std::size_t allowedMemory();
// Of the address space alone; the greatest number where it has no limit.
std::size_t addressSpaceLeft();

// "512M", "16 GiB", "1.5g", "200000000": bytes; K, M, G, T are powers of 1024. Throws Error{usage}.
std::size_t parseMemorySize(const std::string& text);
// "1.5 GiB", for messages.
std::string memoryText(std::size_t bytes);

}  // namespace isolux::base
