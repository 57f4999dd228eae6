// Asks for 2 MiB pages behind large tables that are read in no order.
#pragma once

#include <cstddef>

namespace isolux::volume {

// For the whole 2 MiB pages within the `bytes` at `data`: those not yet touched become such pages when they
// are, those already touched are gathered into them (Linux 6.1). A wish: where it cannot be granted nothing
// changes, and the contents never do. Any thread.
void preferHugePages(const void* data, std::size_t bytes);

}  // namespace isolux::volume
