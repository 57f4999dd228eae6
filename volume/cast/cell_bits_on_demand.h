// Which cells of a block can hold a crossing: what is found out when a ray first comes there, for all rays
// that come later. Safe from many threads.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <tbb/concurrent_vector.h>

#include "base/memory_budget.h"

namespace isolux::volume::casting {

class CellBitsOnDemand {
 public:
  using Words = std::array<std::uint64_t, 8>;  // of 8^3 cells: bit x + 8 y of word z

  // `active`: of the blocks, how many rays may come to. Throws base::Error{memory}.
  CellBitsOnDemand(std::size_t blocks, std::size_t active);

  // Null where nobody has been.
  const Words* find(std::size_t block) const;
  // Two who add the same add the same twice, and one of them stays.
  const Words* add(std::size_t block, const Words& words);

 private:
  base::MemoryBudget::Held held_;
  std::vector<std::atomic<std::uint32_t>> places_;  // in words_, from 1; 0: none
  tbb::concurrent_vector<Words> words_;
};

}  // namespace isolux::volume::casting
