// The memory budget of the process, smaller for the length of a test.
#pragma once

#include "base/memory_budget.h"

namespace isolux::test {

class MemoryLimit {
 public:
  // What is held already, and `more` bytes.
  explicit MemoryLimit(std::size_t more) {
    base::machineMemory().setLimit(base::machineMemory().held() + more);
  }
  ~MemoryLimit() { base::machineMemory().setLimit(before_); }
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;

 private:
  std::size_t before_ = base::machineMemory().limit();
};

}  // namespace isolux::test
