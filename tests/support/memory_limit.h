// The memory budget of the process, smaller for the length of a test.
#pragma once

#include "scene/memory_budget.h"

namespace isolux::test {

class MemoryLimit {
 public:
  // What is held already, and `more` bytes.
  explicit MemoryLimit(std::size_t more) {
    scene::machineMemory().setLimit(scene::machineMemory().held() + more);
  }
  ~MemoryLimit() { scene::machineMemory().setLimit(before_); }
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;

 private:
  std::size_t before_ = scene::machineMemory().limit();
};

}  // namespace isolux::test
