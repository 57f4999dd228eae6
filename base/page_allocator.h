// Allocates blocks of 1 MiB and more directly from the system, for vectors of megabytes with a short life.
//
// Such blocks return to the system when they are freed. malloc() would keep them in the arena of the
// allocating thread, which soon fragments.
#pragma once

#include <cstddef>
#include <new>

#include <sys/mman.h>

namespace isolux::base {

template <class T>
struct PageAllocator {
  using value_type = T;
  static constexpr std::size_t kOwnPages = std::size_t{1} << 20;  // bytes

  PageAllocator() = default;
  template <class U>
  explicit PageAllocator(const PageAllocator<U>&) {}

  // Throws std::bad_alloc.
  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    if (bytes < kOwnPages) return static_cast<T*>(::operator new(bytes));
    void* const pages = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (pages == MAP_FAILED) throw std::bad_alloc();
    return static_cast<T*>(pages);
  }
  void deallocate(T* memory, std::size_t count) noexcept {
    const std::size_t bytes = count * sizeof(T);
    if (bytes < kOwnPages)
      ::operator delete(memory);
    else
      ::munmap(memory, bytes);
  }
  bool operator==(const PageAllocator&) const = default;
};

}  // namespace isolux::base
