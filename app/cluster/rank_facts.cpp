#include "app/cluster/rank_facts.h"

#include <array>

#include <sched.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include "app/version.h"

namespace isolux::app {

std::string hostName() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "an unnamed host";
}

int coresOfMachine() {
  return static_cast<int>(::sysconf(_SC_NPROCESSORS_ONLN));
}

bool isBoundToOneCore() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  return ::sched_getaffinity(0, sizeof cores, &cores) == 0 && CPU_COUNT(&cores) == 1 && coresOfMachine() > 1;
}

std::string boundNote(const std::string& who, int cores) {
  return who + " is bound to one of the " + std::to_string(cores) +
         " cores of its machine: mpirun --bind-to none gives it all";
}

ClusterHello helloOf(const ClusterLight& light, const volume::Grid& grid, std::optional<int> threads,
                     bool threadsAsked) {
  ClusterHello hello;
  hello.host = hostName();
  hello.version = version();
  if (light.working().sky) hello.skyKey = light.working().sky->key();
  if (light.working().lamps) hello.lampsKey = light.working().lamps->key();
  hello.arithmetic = light.plan().arithmetic;
  hello.target = light.plan().target;
  hello.volumeHash = grid.hash();
  const auto allowed = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  hello.threads = threads.value_or(static_cast<int>(allowed));
  hello.coresOfMachine = coresOfMachine();
  hello.bound = !threadsAsked && isBoundToOneCore();
  return hello;
}

}  // namespace isolux::app
