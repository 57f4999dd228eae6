// Asks for 2 MiB pages behind large tables that are read in no order.
#pragma once

#include <cstddef>

#include "base/progress.h"

namespace isolux::volume {

// For the whole 2 MiB pages within the `bytes` at `data`: those not yet touched become such pages when they
// are, those already touched are gathered into them (Linux 6.1), a few at a time, and no longer once a stop
// was requested. A request: where it cannot be granted, or where the machine is set to give no such pages
// (/sys/kernel/mm/transparent_hugepage/enabled), nothing changes, and the contents never do. Any thread.
void preferHugePages(const void* data, std::size_t bytes, const base::Progress& progress);

}  // namespace isolux::volume
