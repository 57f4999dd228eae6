#include "app/ready/give_way.h"

#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

namespace isolux::app {

void giveWay() {
  constexpr int nice = 10;
  const sched_param none{};
  sched_setscheduler(0, SCHED_BATCH, &none);
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), nice);
}

}  // namespace isolux::app
