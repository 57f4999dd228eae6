#include "volume/huge_pages.h"

#ifdef __linux__
#include <sys/mman.h>

#include <cstdint>
#endif

namespace isolux::volume {

#ifdef __linux__
void preferHugePages(const void* data, std::size_t bytes) {
  constexpr std::uintptr_t page = std::uintptr_t{1} << 21;
  const std::uintptr_t from = reinterpret_cast<std::uintptr_t>(data);
  const std::uintptr_t begin = (from + page - 1) & ~(page - 1), end = (from + bytes) & ~(page - 1);
  if (begin >= end) return;
  void* const first = reinterpret_cast<void*>(begin);
  madvise(first, end - begin, MADV_HUGEPAGE);
  constexpr int collapse = 25;  // MADV_COLLAPSE, which headers before Linux 6.1 lack
  madvise(first, end - begin, collapse);
}
#else
void preferHugePages(const void*, std::size_t) {}
#endif

}  // namespace isolux::volume
