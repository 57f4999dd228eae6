#include "base/huge_pages.h"

#ifdef __linux__
#include <sys/mman.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <string>
#endif

namespace isolux::volume {

#ifdef __linux__
namespace {

// "always [madvise] never": the word in brackets holds. Collapsing would go against "never".
bool machineGivesHugePages() {
  std::ifstream file("/sys/kernel/mm/transparent_hugepage/enabled");
  std::string policy;
  std::getline(file, policy);
  return file && policy.find("[never]") == std::string::npos;
}

}  // namespace

void preferHugePages(const void* data, std::size_t bytes, const base::Progress& progress) {
  constexpr std::uintptr_t page = std::uintptr_t{1} << 21;
  constexpr std::uintptr_t piece = 8 * page;  // copied in some milliseconds
  constexpr int collapse = 25;                // MADV_COLLAPSE, which headers before Linux 6.1 lack
  static const bool given = machineGivesHugePages();
  const std::uintptr_t from = reinterpret_cast<std::uintptr_t>(data);
  const std::uintptr_t begin = (from + page - 1) & ~(page - 1), end = (from + bytes) & ~(page - 1);
  if (!given || begin >= end) return;
  // Whole pages within the data.
  // NOLINTBEGIN(performance-no-int-to-ptr)
  madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
  for (std::uintptr_t at = begin; at < end && !progress.stopRequested(); at += piece)
    madvise(reinterpret_cast<void*>(at), std::min(piece, end - at), collapse);
  // NOLINTEND(performance-no-int-to-ptr)
}
#else
void preferHugePages(const void*, std::size_t, const base::Progress&) {}
#endif

}  // namespace isolux::volume
