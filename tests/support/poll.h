// Waits for what other threads and processes do. (Of a window: waitUntil() in tests/support/ui, which handles
// events.)
#pragma once

#include <functional>

namespace isolux::test {

// Looks every millisecond until `condition` holds; false at the timeout, which guards against waiting for
// ever.
[[nodiscard]] bool pollUntil(const std::function<bool()>& condition, double timeoutSeconds = 120.0);

}  // namespace isolux::test
