// Limits the memory that the process allocates for large data.
//
// Code reserves bytes before every large allocation. If the data do not fit, the request fails with a message
// that states the sizes. The system then does not have to kill the process. The budget is a host setting, not
// part of the Scene. It counts memory that grows with the data: voxels, tables of the tracer, coefficients,
// distance fields, baked lighting, images. The reserve that allowedMemory() leaves covers small allocations.
// All sizes are in bytes. All members are safe from any thread.
//
//   const MemoryBudget::Held held = machineMemory().reserve(bytes, "the tables of the tracer",
//                                                           "--memory-budget raises the budget");
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
  // `systemLeft`, if given, returns the bytes that the system has left now. It is called for every 64 MiB,
  // because other processes allocate memory, too.
  explicit MemoryBudget(std::size_t limit, std::size_t (*systemLeft)() = nullptr)
      : limit_(limit), systemLeft_(systemLeft) {}
  MemoryBudget(const MemoryBudget&) = delete;
  MemoryBudget& operator=(const MemoryBudget&) = delete;

  // Counts bytes as held for its lifetime; it is stored next to the data that it counts. A copy counts the
  // same number again without asking, as the copied data take memory again. The budget must outlive it.
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
    // Takes over the bytes of `other`. Requires that both belong to the same budget.
    void add(Held other) noexcept;
    // Releases the bytes above `bytes`.
    void shrinkTo(std::size_t bytes) noexcept;

   private:
    friend class MemoryBudget;
    Held(MemoryBudget* budget, std::size_t bytes) noexcept;  // adds to the count
    MemoryBudget* budget_ = nullptr;
    std::size_t bytes_ = 0;
  };

  // Reserves `bytes`. `what` names the data ("the light of 134217728 texels"); `remedy` says what the user
  // can do ("a lower gi.lattice_scale needs less"). Throws Error{memory} and reserves nothing if the budget
  // has less left.
  [[nodiscard]] Held reserve(std::size_t bytes, std::string_view what, std::string_view remedy);
  // Returns nullopt if the budget has less left.
  [[nodiscard]] std::optional<Held> tryReserve(std::size_t bytes);
  // Checks as reserve() does but reserves nothing: for work whose parts reserve memory themselves.
  void check(std::size_t bytes, std::string_view what, std::string_view remedy) const;
  // Counts memory that is already allocated; never fails.
  [[nodiscard]] Held count(std::size_t bytes) noexcept { return {this, bytes}; }

  std::size_t limit() const noexcept { return limit_.load(std::memory_order_relaxed); }
  std::size_t held() const noexcept { return held_.load(std::memory_order_relaxed); }
  std::size_t left() const noexcept;
  // Sets the limit. Bytes already held stay held, even if they exceed it.
  void setLimit(std::size_t limit) noexcept { limit_.store(limit, std::memory_order_relaxed); }

  // Returns the error that reserve() throws.
  Error refusal(std::size_t bytes, std::string_view what, std::string_view remedy) const;

 private:
  bool systemHas(std::size_t bytes) const;
  std::atomic<std::size_t> limit_;
  std::size_t (*systemLeft_)();
  std::atomic<std::size_t> held_{0};
};

// Returns the budget of this process. Its limit is allowedMemory() at the first call, unless set.
MemoryBudget& machineMemory();

// Returns "WHAT would take 42.0 GiB beside the 2.0 GiB that are held, more than the memory budget of 3.0 GiB;
// REMEDY, --memory-budget changes the budget".
std::string overBudgetText(std::size_t bytes, std::size_t held, std::size_t limit, std::string_view what,
                           std::string_view remedy);

// Returns how many bytes this process may still allocate: the minimum over available memory, address space
// (ulimit -v) and the process's control groups.
std::size_t systemMemoryLeft();
// Returns systemMemoryLeft() less a reserve for allocations that are not counted: an eighth, 64 MiB to 1 GiB.
std::size_t allowedMemory();
// Returns the address space left, or the largest std::size_t if it is unlimited.
std::size_t addressSpaceLeft();

// Parses "512M", "16 GiB", "1.5g" or "200000000" to bytes; K, M, G, T are powers of 1024. Throws
// Error{usage}.
std::size_t parseMemorySize(const std::string& text);
// Returns a size for messages: "1.5 GiB".
std::string memoryText(std::size_t bytes);

}  // namespace isolux::base
